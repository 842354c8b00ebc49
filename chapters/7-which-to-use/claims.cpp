// SPDX-License-Identifier: MIT-0
// The claims of chapter 7. Each name is a sentence that the chapter says.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "choose/contests.h"
#include "choose/entrants.h"
#include "float_floor.h"
#include "level_by_choice.h"
#include "map.h"
#include "measure/longest_stable_step.h"
#include "measure/many_starts.h"
#include "measure/method_of.h"
#include "measure/methods.h"
#include "particles.h"
#include "position_error.h"
#include "summary_table.h"
#include "verdicts.h"
#include "work_precision.h"
#include "your_spring.h"

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using measure::Method;
using method::backward_euler;
using method::euler;
using method::rk4;
using method::symplectic_euler;
using method::velocity_verlet;

namespace {

/// The errors of one method on the six things at 60 Hz [cm].
std::map<std::string, double> errors(const Method& step) {
  std::map<std::string, double> found;
  for_each_thing([&](const auto& name, const auto& scene, double seconds) {
    found[name] = 100 * max_position_error(step, scene, frame, seconds);
  });
  return found;
}

/// The words for the three kinds of force, one after the other.
std::string words(const Method& step) {
  const Verdict found = verdict(step);
  return verdict_word(found.position) + ", " + verdict_word(found.velocity) + ", " +
         verdict_word(found.constant);
}

/// The cheapest evaluations a second with which a method keeps all six within a centimetre.
std::map<std::string, double> bills() {
  std::map<std::string, double> found;
  for (const auto& [thing, done] : contests_to_within(centimetre)) {
    found["chosen"] += taken(done).evaluations;
    for (const Entry& entry : done.methods) {
      if (entry.method->header == "linear_damping.h") continue;  // not for all six
      found[entry.name] += entry.good ? entry.evaluations : INFINITY;
    }
  }
  return found;
}

/// The farthest that a spring has been in many steps; infinite from a million times the start on.
double farthest(const Method& step, double homega, double zeta) {
  double most = 0;
  scenes::State<double> s{1, 0.5};
  measure::run(step, spring_of(zeta), s, homega, 100'000, [&](double, const auto& now) {
    if (!(std::abs(now.x) <= most)) most = std::abs(now.x);
  });
  return most < 1e6 ? most : INFINITY;
}

/// Returns whether a whole run with so many steps in each frame stays within the bounds.
template <class Scene>
bool meets(const Method& step, const Scene& scene, const Bounds& bounds, long substeps) {
  const double h = 1 / bounds.hz / double(substeps);
  double farthest = 0, error = 0, energy = 0;
  auto s = scene.start();
  long n = 0;
  measure::run(step, scene, s, h, bounds.frames() * substeps, [&](double t, const auto& now) {
    if (n++ % substeps != 0) return;
    const auto x = scene.exact(t).x;
    farthest = std::max(farthest, measure::length(x));
    if (!(measure::length(now.x - x) <= error)) error = measure::length(now.x - x);
    if constexpr (requires { scene.energy(now.x, now.v); }) {
      const double first = scene.energy(scene.start().x, scene.start().v);
      const double change = std::abs((scene.energy(now.x, now.v) - first) / first);
      if (!(change <= energy)) energy = change;
    }
  });
  return error <= bounds.error * farthest && !(energy > bounds.energy);
}

/// A method and its steps in each frame.
std::string title(const Method& method, long substeps) {
  return std::string(method.function) + " " + std::to_string(substeps) + ", ";
}

/// Every way to meet the bounds for less, by name and steps in each frame.
template <class Scene>
std::string cheaper(const Scene& scene, const Bounds& bounds, double evaluations) {
  std::string found;
  for (const Method* entrant : entrants_on(scene)) {
    const double once = bounds.hz * evaluations_per_step(*entrant);
    for (long substeps = std::lround(evaluations / once); substeps > 0; --substeps) {
      if (once * double(substeps) > evaluations - 1e-9) continue;
      if (meets(*entrant, scene, bounds, substeps)) found += title(*entrant, substeps);
    }
  }
  return found;
}

/// The distance by which one last place of a float in each number of its start moves a turn, in no
/// precision but double [m].
double moved_by_a_last_place() {
  const auto start = shuttle_in<float>().start();
  const auto next = [](float value) { return std::nextafter(value, INFINITY); };
  ShuttleVec<double> x = start.x.cast<double>(), v = start.v.cast<double>();
  ShuttleVec<double> x_aside = start.x.unaryExpr(next).cast<double>();
  ShuttleVec<double> v_aside = start.v.unaryExpr(next).cast<double>();
  double largest = 0;
  const double h = frame / 4;
  for (double t = 0; t < shuttle_turn; t += h) {
    measure::rk4(x, v, t, h, shuttle);
    measure::rk4(x_aside, v_aside, t, h, shuttle);
    largest = std::max(largest, (x_aside - x).norm());
  }
  return largest;
}

}  // namespace

TEST_CASE("No method keeps all six things within a centimetre at 60 steps a second") {
  for (const Method* entrant : entrants) {
    INFO(entrant->name);
    double worst = 0;
    for (const auto& [thing, error] : errors(*entrant)) worst = std::max(worst, error);
    CHECK(worst > 1);
  }
}

TEST_CASE("Euler and symplectic Euler miss the centimetre with all six things") {
  for (const auto& found : {errors(euler), errors(symplectic_euler)}) {
    CHECK(found.size() == 6);
    for (const auto& [thing, error] : found) {
      INFO(thing);
      CHECK(error > 1);
    }
  }
}

TEST_CASE("With drag in the acceleration only the implicit methods hold the hatch at 60 Hz") {
  for (const Method* entrant : entrants) {
    INFO(entrant->name);
    CHECK(
        std::isfinite(errors(*entrant)["hatch"]) ==
        (entrant == &backward_euler || entrant == &method::trapezoid || entrant == &method::bdf2));
  }
  CHECK(errors(backward_euler)["hatch"] < 5);
  for (const Method* entrant : entrants) {
    if (entrant != &backward_euler) {
      CHECK(errors(*entrant)["shuttle"] < errors(backward_euler)["shuttle"]);
    }
  }
}

TEST_CASE("With drag divided symplectic Euler holds the hatch as near as backward Euler") {
  const double divided = max_position_error(method::linear_damping_implicit_last, hatch, frame, 1);
  CHECK_THAT(divided, WithinRel(max_position_error(backward_euler, hatch, frame, 1), 0.05));
}

TEST_CASE("Dormand-Prince keeps five of the six things within a micrometre") {
  for (const auto& [thing, error] : errors(method::dopri5)) {
    INFO(thing);
    if (thing == "hatch") {
      CHECK(std::isinf(error));
    } else {
      CHECK(error < 1e-4);
    }
  }
}

TEST_CASE("Euler is lousy for forces of position, okay for velocity and bad for constant ones") {
  CHECK(words(euler) == "lousy, okay, bad");
}

TEST_CASE("RK4 is great for forces of all three kinds") {
  CHECK(words(rk4) == "great, great, great");
  CHECK(1e4 * verdict(rk4).position < verdict(velocity_verlet).position);
  CHECK(1e4 * verdict(rk4).velocity < verdict(velocity_verlet).velocity);
}

TEST_CASE(
    "In a quarter of the steps RK4 is a hundred times nearer than velocity Verlet on drone and "
    "skid") {
  CHECK(100 * max_position_error(rk4, drone, 4 * frame, minute) <
        max_position_error(velocity_verlet, drone, frame, minute));
  CHECK(100 * max_position_error(rk4, skid, 4 * frame, moment) <
        max_position_error(velocity_verlet, skid, frame, moment));
}

TEST_CASE("Backward Euler is lousy for forces of position, okay for velocity, bad for constant") {
  CHECK(words(backward_euler) == "lousy, okay, bad");
}

TEST_CASE("Velocity Verlet is good for forces of position and of velocity and exact for constant") {
  CHECK(words(velocity_verlet) == "good, good, great");
  CHECK(verdict(velocity_verlet).constant < 1e-11);
}

TEST_CASE("Symplectic Euler is okay for forces of position, bad for velocity and constant ones") {
  CHECK(words(symplectic_euler) == "okay, bad, bad");
}

TEST_CASE("On a skid backward Euler errs as far as Euler, to the other side") {
  CHECK_THAT(verdict(backward_euler).velocity, WithinRel(verdict(euler).velocity, 0.05));
  const double truth = skid.exact(0.5).x;
  CHECK(measure::after(euler, skid, skid.start(), frame, 30).x > truth);
  CHECK(measure::after(backward_euler, skid, skid.start(), frame, 30).x < truth);
}

TEST_CASE("On a skid symplectic Euler has the velocity of Euler, and a worse place") {
  const auto start = skid.start();
  const auto swapped = measure::after(symplectic_euler, skid, start, frame, 60);
  CHECK(swapped.v == measure::after(euler, skid, start, frame, 60).v);
  CHECK_THAT(verdict(symplectic_euler).velocity / verdict(euler).velocity, WithinAbs(5, 0.2));
}

TEST_CASE("What backward Euler is great for is the length of the step") {
  constexpr scenes::LinearDrag<> brake{.c = 1, .g = 0};
  CHECK(std::isinf(measure::longest_stable_step(backward_euler, brake)));
  CHECK_THAT(measure::longest_stable_step(euler, brake), WithinAbs(2, 1e-9));
  CHECK_THAT(measure::longest_stable_step(velocity_verlet, brake), WithinAbs(1, 1e-9));
}

TEST_CASE(
    "Of the charts' methods that ask once a step velocity Verlet is nearest on all four scenes") {
  const auto check = [](const auto& scene, double seconds) {
    const double least = max_position_error(velocity_verlet, scene, frame, seconds);
    for (const Method* entrant : entrants) {
      INFO(entrant->name);
      if (price(*entrant, scene, frame) > 1) continue;
      CHECK(max_position_error(*entrant, scene, frame, seconds) >
            least * (1 - 1e-6));  // leapfrog's places are the same
    }
  };
  check(suspension, 1);
  check(leaf, 2);
  check(lamp, 10);
  check(shuttle, 8);
}

TEST_CASE("Without drag drift, kick, drift is nearer than velocity Verlet, with drag farther") {
  const auto ratio = [](const auto& scene, double seconds) {
    return max_position_error(measure::compiled<measure::LeapfrogDrift>, scene, frame, seconds) /
           max_position_error(velocity_verlet, scene, frame, seconds);
  };
  CHECK_THAT(ratio(lamp, 10), WithinAbs(0.62, 0.01));
  CHECK_THAT(ratio(shuttle, 8), WithinAbs(0.19, 0.01));
  CHECK(ratio(suspension, 1) > 3);
  CHECK(ratio(leaf, 2) > 50);
}

TEST_CASE("At 240 evaluations RK4's shuttle is 300 times nearer than Verlet's") {
  const double best = max_position_error(rk4, shuttle, frame, 8);
  CHECK_THAT(max_position_error(velocity_verlet, shuttle, frame / 4, 8) / best, WithinAbs(337, 5));
  CHECK_THAT(max_position_error(symplectic_euler, shuttle, frame / 4, 8) / best,
             WithinAbs(4600, 50));
}

TEST_CASE(
    "Near the planet the shuttle is four times as fast as far out, and pulled 16 times as hard") {
  const auto near = shuttle.exact(0), far = shuttle.exact(shuttle.period() / 2);
  const auto pull = [](const auto& s) { return shuttle(s.x, s.v, 0.0).norm(); };
  CHECK_THAT(near.v.norm() / far.v.norm(), WithinRel(4, 1e-9));
  CHECK_THAT(pull(near) / pull(far), WithinRel(16, 1e-9));
}

TEST_CASE(
    "For the price methods of order four and five hold the shuttle ten times nearer than others") {
  const Method* const high[] = {&method::yoshida4, &rk4, &method::dopri5};
  for (const Method* one : high) {
    for (const int rate : {40, 75, 150, 210}) {
      const double paid = double(rate * price(*one, shuttle, 1.0 / rate));
      const double error = max_position_error(*one, shuttle, 1.0 / rate, 8);
      for (const Method* other : entrants) {
        if (std::count(std::begin(high), std::end(high), other)) continue;
        const double h = double(price(*other, shuttle, frame)) / paid;
        CHECK(max_position_error(*other, shuttle, h, 8) > 10 * error);
      }
    }
  }
}

TEST_CASE("In a minute backward Euler changes the shuttle's energy by more than ten times itself") {
  for (const int rate : {30, 60, 120, 240}) {
    CHECK(energy_error(backward_euler, shuttle, 1.0 / rate) > 10);
  }
}

TEST_CASE("Twice the steps halve Euler's error, quarter Verlet's and leave a sixteenth of RK4's") {
  const auto gain = [](const Method& step) {
    return max_position_error(step, lamp, 1.0 / 960, 10) /
           max_position_error(step, lamp, 1.0 / 1920, 10);
  };
  CHECK_THAT(gain(symplectic_euler), WithinAbs(2, 0.05));
  CHECK_THAT(gain(velocity_verlet), WithinAbs(4, 0.05));
  CHECK_THAT(
      max_position_error(rk4, lamp, 1.0 / 120, 10) / max_position_error(rk4, lamp, 1.0 / 240, 10),
      WithinAbs(16, 1));
}

TEST_CASE("At 30 steps a second Euler's lamp goes over the top, at 60 and more it does not") {
  const auto widest_swing = [](double rate) {
    double most = 0;
    auto s = lamp.start();
    measure::run(euler, lamp, s, 1 / rate, std::lround(10 * rate),
                 [&](double, const auto& now) { most = std::max(most, std::abs(now.x)); });
    return most;
  };
  CHECK(widest_swing(30) > std::numbers::pi);
  for (const double rate : {60, 120, 240}) CHECK(widest_swing(rate) < 2);
}

TEST_CASE("On the leaf symplectic Euler is five times as far off as Euler") {
  CHECK_THAT(max_position_error(symplectic_euler, leaf, frame, 2) /
                 max_position_error(euler, leaf, frame, 2),
             WithinAbs(5, 0.2));
}

TEST_CASE("On a damped spring Yoshida is no better than midpoint at the same rate per evaluation") {
  CHECK_THAT(max_position_error(method::yoshida4, suspension, 1.0 / 80, 1) /
                 max_position_error(method::midpoint, suspension, 1.0 / 120, 1),
             WithinAbs(1.1, 0.15));
}

TEST_CASE("At equal price RK4's energy error passes velocity Verlet's after two hours") {
  CHECK(energy_error(rk4, shuttle, frame) < energy_error(velocity_verlet, shuttle, frame / 4) / 90);
  CHECK(energy_passes() > 120 * 60);
  CHECK(energy_passes() < 130 * 60);
}

TEST_CASE("After a day velocity Verlet's shuttle is a turn behind, and RK4's seven ahead") {
  CHECK_THAT(ahead_after_a_day(velocity_verlet, frame / 4), WithinAbs(-1.2, 0.1));
  CHECK_THAT(ahead_after_a_day(rk4, frame), WithinAbs(7.3, 0.1));
}

TEST_CASE("Set out a second later Verlet's shuttle is 0.04 turns ahead after a day, RK4's seven") {
  CHECK_THAT(ahead_after_a_day(velocity_verlet, frame / 4, 1), WithinAbs(0.04, 0.005));
  CHECK_THAT(ahead_after_a_day(rk4, frame, 1), WithinAbs(7.3, 0.1));
}

TEST_CASE(
    "At 240 evaluations a second Yoshida keeps the shuttle's energy eighty times nearer than "
    "Verlet for a day") {
  const double yoshida = energy_error(method::yoshida4, shuttle, 3 * frame / 4, day);
  const double verlet = energy_error(velocity_verlet, shuttle, frame / 4, day);
  CHECK_THAT(verlet / yoshida, WithinAbs(84, 4));
  CHECK(std::abs(ahead_after_a_day(method::yoshida4, 3 * frame / 4)) < 0.02);
}

TEST_CASE("On the suspension velocity Verlet and RK4 meet at 120 evaluations a second") {
  const auto error = [](const Method& step, double rate) {
    return max_position_error(step, suspension, 1 / rate, 1);
  };
  CHECK_THAT(error(velocity_verlet, 120) / error(rk4, 30), WithinAbs(1, 0.1));
  CHECK(error(velocity_verlet, 60) < error(rk4, 15) / 3);
  CHECK(error(rk4, 60) < error(velocity_verlet, 240) / 3);
  CHECK(error(method::dopri5, 40) < error(rk4, 60));
}

TEST_CASE("Just inside the limits of the map a spring stays, just outside it explodes") {
  int checked = 0;
  for (const auto& [name, step] : mapped) {
    for (const double zeta : {0.1, 0.5, 1.0, 2.0}) {
      INFO(name << ", zeta " << zeta);
      const double limit = stable_until(step, zeta);
      CHECK(farthest(step, 0.98 * limit, zeta) < 100);
      if (limit == widest) continue;
      CHECK(std::isinf(farthest(step, 1.02 * limit, zeta)));
      ++checked;
    }
  }
  CHECK(checked == 34);
}

TEST_CASE("What has no map of its own has the limits of something that has") {
  const auto limits = [](const Method& step) {
    std::vector<long> rounded;
    for (const double zeta : {0.0, 0.1, 0.5, 1.0, 2.0}) {
      rounded.push_back(std::lround(1e6 * stable_until(step, zeta)));
    }
    return rounded;
  };
  for (const Method* entrant : entrants) {
    INFO(entrant->name << ": give it a map, in chapters/7-which-to-use/map.h");
    const auto same = [&](const Mapped& one) { return limits(one.method) == limits(*entrant); };
    CHECK(std::any_of(std::begin(mapped), std::end(mapped), same));
  }
}

TEST_CASE("The eigenvalues know the limits that the formulas give") {
  for (const double zeta : {0.2, 0.5, 1.0, 1.5}) {
    const double root = std::sqrt(1 + zeta * zeta);
    CHECK_THAT(stable_until(symplectic_euler, zeta), WithinAbs(2 * (root - zeta), 1e-8));
    CHECK_THAT(stable_until(method::linear_damping_implicit_last, zeta),
               WithinAbs(std::min(widest, 2 * (root + zeta)), 1e-8));
    if (zeta <= 1) CHECK_THAT(stable_until(euler, zeta), WithinAbs(2 * zeta, 1e-8));
  }
}

TEST_CASE(
    "At 30 Hz a critically damped spring of 40 per second is lost by four methods, not Euler") {
  std::string lost;
  for (const auto& [method, way] : camera_paths()) {
    INFO(method);
    const bool gone = std::abs(way.back()) > 10 * camera.x0;
    CHECK((gone || std::abs(way.back()) < 0.1 * camera.x0));
    if (gone) lost += method + ", ";
  }
  CHECK(lost == "symplectic Euler, velocity Verlet, Yoshida 4, predicted Euler, ");
}

TEST_CASE(
    "With drag divided symplectic Euler's limit rises with the damping, and falls otherwise") {
  const auto divided = [](double zeta) {
    return measure::longest_stable_step(method::linear_damping_implicit_last, spring_of(zeta));
  };
  const auto plain = [](double zeta) {
    return measure::longest_stable_step(symplectic_euler, spring_of(zeta));
  };
  for (const double zeta : {0.1, 0.5, 1.0, 2.0}) {
    CAPTURE(zeta);
    CHECK_THAT(divided(zeta), WithinRel(2 * (std::sqrt(1 + zeta * zeta) + zeta), 1e-6));
    CHECK_THAT(plain(zeta) * divided(zeta), WithinRel(4, 1e-6));
  }
}

TEST_CASE(
    "At half critical damping and at critical velocity Verlet takes the shortest steps of the "
    "map") {
  for (const double zeta : {0.5, 1.0}) {
    for (const auto& [name, step] : mapped) {
      CAPTURE(name, zeta);
      CHECK(stable_until(step, zeta) >= stable_until(velocity_verlet, zeta));
    }
  }
}

TEST_CASE(
    "Drag divided is true to life for longer steps than drag as a force below critical damping") {
  for (const double zeta : {0.1, 0.3, 0.5, 0.7}) {
    CAPTURE(zeta);
    CHECK(accurate_until(method::linear_damping_implicit_last, zeta) >
          accurate_until(symplectic_euler, zeta));
  }
}

TEST_CASE("Backward Euler is stable on all of the map, and true to 0.2 without damping") {
  for (int i = 0; i <= 20; ++i) CHECK(stable_until(backward_euler, tallest * i / 20) == widest);
  CHECK_THAT(accurate_until(backward_euler, 0), WithinAbs(0.2, 0.01));
}

TEST_CASE("The exact step is stable and true on all of the map") {
  for (int i = 0; i <= 20; ++i) {
    CHECK(stable_until(method::spring_exact, tallest * i / 20) == widest);
    CHECK(accurate_until(method::spring_exact, tallest * i / 20) == widest);
  }
}

TEST_CASE("One exact step of a second ends where sixty of a frame do") {
  const auto once = measure::after(method::spring_exact, suspension, suspension.start(), 1.0, 1);
  const auto often =
      measure::after(method::spring_exact, suspension, suspension.start(), frame, 60);
  CHECK_THAT(once.x, WithinAbs(often.x, 1e-15));
  CHECK_THAT(once.x, WithinAbs(suspension.exact(1).x, 1e-15));
  const auto leap =
      measure::after(method::constant_acceleration, height_of_jump, height_of_jump.start(), 1.0, 1);
  CHECK_THAT(leap.x, WithinAbs(height_of_jump.exact(1).x, 1e-15));
}

TEST_CASE("In float RK4's shuttle stays a tenth of a millimetre off, and more than 480 Hz hurt") {
  for (const long rate : {60L, 120L, 240L, 480L}) {
    const double off = measure::median(errors_along_its_way(measure::rk4, rate));
    CHECK(off > 0.4e-4);
    CHECK(off < 1.6e-4);
  }
  CHECK(measure::median(errors_along_its_way(measure::rk4, 960)) > 1.7e-4);
  for (long rate = 960; rate < 7680; rate *= 2) {
    CHECK(error_of_a_turn<float>(measure::rk4, 2 * rate) >
          error_of_a_turn<float>(measure::rk4, rate));
  }
}

TEST_CASE(
    "In float one start in twenty leaves RK4's shuttle ten times as far off as another one in "
    "twenty") {
  const auto errors = errors_along_its_way(measure::rk4, 240);
  CHECK(measure::quantile(errors, 0.95) > 10 * measure::quantile(errors, 0.05));
}

TEST_CASE(
    "At 60 steps a second float changes no more than a per cent for symplectic Euler and Verlet, "
    "at 240 a tenth for Verlet") {
  const auto changed = [](const auto& step, long rate) {
    return measure::median(changes_by_float(step, rate));
  };
  CHECK(changed(measure::velocity_verlet, 60) < 0.01);
  CHECK(changed(measure::symplectic_euler, 60) < 0.01);
  CHECK_THAT(changed(measure::velocity_verlet, 240), WithinAbs(0.09, 0.02));
}

TEST_CASE("Packs move the particles to where structs do") {
  auto structs = cloud(64);
  auto packs = packed(structs);
  for (int n = 0; n < 60; ++n) {
    step_structs(structs, frame_of_float);
    step_packs(packs, frame_of_float);
  }
  const auto expected = packed(structs);
  double most = 0;
  for (std::size_t n = 0; n < packs.size(); ++n) {
    for (int i = 0; i < 4; ++i) {
      most = std::max(most, double(std::abs(packs[n].x.a[i] - expected[n].x.a[i])));
      most = std::max(most, double(std::abs(packs[n].x.d[i] - expected[n].x.d[i])));
    }
  }
  // Sixty steps, each of which rounds a few numbers of size one.
  CHECK(most <= 60 * 4 * double(std::numeric_limits<float>::epsilon()));
}

TEST_CASE("Sixteen steps in one visit are the sixteen steps, bit for bit") {
  auto packs = packed(cloud(2048)), blocks = packs;
  for (int n = 0; n < steps_a_visit; ++n) step_packs(packs, frame_of_float);
  step_blocks(blocks, frame_of_float);
  bool same = true;
  for (std::size_t n = 0; n < packs.size(); ++n) {
    for (int i = 0; i < 4; ++i) {
      same = same && packs[n].x.a[i] == blocks[n].x.a[i] && packs[n].v.d[i] == blocks[n].v.d[i];
    }
  }
  CHECK(same);
}

TEST_CASE(
    "With compensated sums rounding moves RK4 in float by five micrometres, up to 7680 steps a "
    "second") {
  for (const long rate : {120L, 480L, 1920L, 7680L}) {
    const double moved = measure::median(
        along_its_way([&](const auto& s, double) { return rounding_of_sums(s, rate); }));
    CHECK(moved < 5e-6);
    CHECK(measure::median(errors_along_its_way(measure::rk4, rate)) > 10 * moved);
  }
  // Before the sums matter the method's own error is what it was.
  CHECK_THAT(compensated_error(30) / error_of_a_turn<double>(measure::rk4, 30), WithinAbs(1, 0.3));
}

TEST_CASE(
    "One last place of a float in its start moves the shuttle's turn by more than a tenth of a "
    "millimetre") {
  CHECK(moved_by_a_last_place() > 1e-4);
  CHECK(moved_by_a_last_place() < 3e-4);
}

TEST_CASE(
    "For the pendulum of the exercise choose takes Verlet in one step, in two, then Yoshida") {
  const scenes::Pendulum<> pendulum{.length = 9.81 / 9, .angle = 2.5};
  const auto first = [&](double error) {
    return contest(pendulum, Bounds{.hz = 30, .seconds = 10, .error = error}).methods[0];
  };
  CHECK(first(1e-2).method == &velocity_verlet);
  CHECK(first(1e-2).last.substeps == 1);
  CHECK(first(1e-3).method == &velocity_verlet);
  CHECK(first(1e-3).last.substeps == 2);
  CHECK(first(1e-4).method == &method::yoshida4);
  CHECK(first(1e-4).last.substeps == 1);
}

TEST_CASE("Far from the origin float's floor is a hundred times higher or more") {
  for (const long rate : {60L, 240L, 480L}) {
    const double far = error_far_away(measure::rk4, rate);
    CHECK(far > 100 * error_of_a_turn<float>(measure::rk4, rate));
    CHECK(far < 10'000 * error_of_a_turn<float>(measure::rk4, rate));
  }
}

TEST_CASE("An implicit step is billed for its derivatives, and what knows its force for one") {
  CHECK(price(euler, shuttle, frame) == 1);
  CHECK(price(velocity_verlet, shuttle, frame) == 1);
  CHECK(price(method::yoshida4, shuttle, frame) == 3);
  CHECK(price(rk4, shuttle, frame) == 4);
  CHECK(price(method::dopri5, shuttle, frame) == 6);
  CHECK(price(backward_euler, shuttle, frame) == 2);
  CHECK(price(method::trapezoid, shuttle, frame) == 3);
  for (const Method* knows : {&method::spring_exact, &method::spring_folded,
                              &method::backward_euler_spring, &method::constant_acceleration}) {
    CHECK(price(*knows, suspension, frame) == 1);
  }
}

TEST_CASE(
    "In the scenes that were tried no method and no number of steps meets the bounds for less than "
    "the chosen one") {
  const auto check = [](const auto& scene, const Bounds& bounds, double evaluations) {
    const Contest found = contest(scene, bounds);
    const Entry& best = found.methods[0];
    CHECK(best.good);
    CHECK(best.evaluations == evaluations);
    CHECK(best.evaluations ==
          bounds.hz * double(best.last.substeps) * evaluations_per_step(*best.method));
    CHECK(cheaper(scene, bounds, best.evaluations).empty());
    // The search sees what is there: with room for one frame of RK4 more it finds the chosen one.
    CHECK_THAT(cheaper(scene, bounds, best.evaluations + 4 * bounds.hz),
               ContainsSubstring(title(*best.method, best.last.substeps)));
  };
  check(example, example_bounds, 240);
  check(example, {.error = 0.012}, 180);
  check(hatch, {.seconds = 1, .error = 0.01}, 240);
  check(suspension, {.seconds = 1, .error = 0.1}, 60);
  check(scenes::Spring<>{.omega = 25, .zeta = 0.3}, {.hz = 30, .seconds = 5, .error = 0.02}, 90);
  check(shuttle, {.seconds = 8, .error = 0.001}, 180);
  check(shuttle, {.seconds = 8, .error = 0.002}, 180);
  check(shuttle, {.seconds = 8, .error = 0.1, .energy = 1e-5}, 180);
  check(lamp, {.seconds = 10, .error = 0.1}, 60);
  check(leaf, {.seconds = 2, .error = 1e-6}, 240);
}

TEST_CASE("No method keeps the level within a centimetre with fewer steps than it is billed for",
          "[long]") {
  for_each_thing([&](const std::string& thing, const auto& scene, double seconds) {
    Bounds bounds{.seconds = seconds};
    bounds.error = centimetre / size_of(scene, bounds);
    const Contest found = contest(scene, bounds);
    for (const Method* entrant : entrants) {
      const Entry& entry = entry_of(found, *entrant);
      if (!entry.good) continue;
      INFO(thing << ", " << title(*entrant, entry.last.substeps));
      CHECK(meets(*entrant, scene, bounds, entry.last.substeps));
      bool fewer = false;
      for (long substeps = entry.last.substeps - 1; substeps > 0; --substeps) {
        fewer = fewer || meets(*entrant, scene, bounds, substeps);
      }
      CHECK_FALSE(fewer);
    }
  });
}

TEST_CASE("By time, too, symplectic Euler for everything is the dearest that solves for nothing") {
  auto found = times_alone();
  const double talks = found["symplectic Euler"];
  for (const Method* entrant : entrants) {
    INFO(entrant->name);
    const double time = found[std::string(entrant->name)];
    if (entrant != &method::bdf2) CHECK((time <= talks || std::isinf(time)));
  }
  CHECK_THAT(talks / found["velocity Verlet"], WithinAbs(9, 1));
}

TEST_CASE(
    "By time the choice for each thing costs a sixth less than velocity Verlet for everything") {
  CHECK_THAT(time_of_choice() / times_alone()["velocity Verlet"], WithinAbs(5.0 / 6, 0.03));
}

TEST_CASE("In a loop the folded exact step takes less than half the time of velocity Verlet's") {
  for (const char* spring : {"suspension", "hatch"}) {
    const double folded = step_time(spring, in_a_loop, method::spring_folded);
    CHECK(folded < 0.5 * step_time(spring, in_a_loop, velocity_verlet));
    CHECK(step_time(spring, in_a_loop, method::spring_exact) > 10 * folded);
  }
}

TEST_CASE("In uneven frames RK4 in one step and Störmer–Verlet miss the example's bound ninefold") {
  const Contest found = full_contest(example, example_bounds);
  const Entry& one_step = entry_of(found, rk4);
  CHECK(one_step.last.substeps == 1);
  CHECK(one_step.uneven > 9 * example_bounds.error);
  CHECK(entry_of(found, method::stormer_verlet).uneven > 9 * example_bounds.error);
  CHECK(entry_of(found, velocity_verlet).uneven <= example_bounds.error);
}

TEST_CASE(
    "On an orbit of eccentricity 0.9 adaptive steps cost a fourteenth of the cheapest equal ones") {
  const Contest found =
      full_contest(scenes::Orbit<>{.eccentricity = 0.9, .mu = 100}, {.error = 0.01});
  const Entry& best = found.methods.front();
  REQUIRE(best.good);
  CHECK_THAT(best.evaluations / found.undisturbed.front().evaluations, WithinAbs(14, 0.5));
}

TEST_CASE("When nothing meets the bounds the nearest miss comes first") {
  const Bounds bounds{.hz = 10, .seconds = 1, .error = 1e-18};
  const Contest found = contest(shuttle, bounds);
  for (const Entry& entry : found.methods) {
    CHECK_FALSE(entry.good);
    CHECK(miss(entry.last, bounds) >= miss(found.methods[0].last, bounds));
  }
}

TEST_CASE("The best single method costs nearly twice what the choice for each thing costs") {
  auto found = bills();
  double best = INFINITY;
  for (const Method* entrant : entrants) best = std::min(best, found[std::string(entrant->name)]);
  CHECK(found["velocity Verlet"] == best);
  CHECK_THAT(best / found["chosen"], WithinAbs(1.75, 0.05));
}

TEST_CASE(
    "Symplectic Euler for everything costs 16 times the choice, and started by half a kick 3") {
  auto found = bills();
  CHECK_THAT(found["symplectic Euler"] / found["chosen"], WithinAbs(15.6, 0.5));
  CHECK_THAT(found["leapfrog"] / found["chosen"], WithinAbs(3.1, 0.1));
  for (const auto& [method, bill] : found) {
    INFO(method);
    CHECK((bill <= found["symplectic Euler"] || std::isinf(bill)));  // the dearest that get there
  }
}

TEST_CASE(
    "With 1024 steps a frame Euler, predicted and backward Euler miss the shuttle's centimetre") {
  const Contest& found = contests_to_within(centimetre).at("shuttle");
  for (const Entry& entry : found.methods) {
    INFO(entry.name);
    CHECK(entry.good == (entry.method != &euler && entry.method != &method::predicted_euler &&
                         entry.method != &backward_euler));
  }
}

TEST_CASE(
    "On the example velocity Verlet and RK4 cost the same, symplectic Euler 8 times as much") {
  const Contest found = contest(example, example_bounds);
  const double least = entry_of(found, velocity_verlet).evaluations;
  CHECK(least == entry_of(found, rk4).evaluations);
  CHECK(found.methods[0].evaluations == least);
  CHECK_THAT(entry_of(found, symplectic_euler).evaluations / least, WithinAbs(8, 0.5));
  CHECK(found.exact[0].method == &method::spring_folded);
  CHECK(found.exact[0].evaluations == 60);
}

TEST_CASE(
    "At 60 Hz symplectic Euler holds 19 swings a second, and RK4 27 for four times the price") {
  CHECK_THAT(swings_held(symplectic_euler), WithinAbs(19.1, 0.05));
  CHECK_THAT(swings_held(rk4), WithinAbs(27, 0.05));
}

TEST_CASE("At 60 Hz Yoshida holds 15 swings a second, fewer than velocity Verlet for one step") {
  CHECK_THAT(swings_held(method::yoshida4), WithinAbs(15, 0.05));
  CHECK(swings_held(method::yoshida4) < swings_held(velocity_verlet));
}

TEST_CASE(
    "The velocity that Störmer–Verlet shows has order one, that of velocity Verlet order two") {
  const auto gain = [](const Method& step) {
    const scenes::Pendulum<> swing = lamp;
    return measure::largest_error(step, swing, 1.0 / 240, 2400).velocity /
           measure::largest_error(step, swing, 1.0 / 480, 4800).velocity;
  };
  CHECK_THAT(gain(method::stormer_verlet), WithinAbs(2, 0.05));
  CHECK_THAT(gain(velocity_verlet), WithinAbs(4, 0.05));
}

TEST_CASE("Euler's jump is eight centimetres off, and the exact step asks as often") {
  CHECK_THAT(errors(euler)["jump"], WithinAbs(8.2, 0.05));
  CHECK(thrown_ball.v0 == height_of_jump.v0);  // the ball of `choose`
  CHECK(price(method::constant_acceleration, height_of_jump, frame) ==
        price(euler, height_of_jump, frame));
}

TEST_CASE("A swing twice a second to one per cent takes velocity Verlet 288 steps a second") {
  CHECK_THAT(max_position_error(velocity_verlet, twice_a_second, 1.0 / 288, 10),
             WithinRel(0.01, 0.02));
}

TEST_CASE(
    "For the swing of the exercise choose takes RK4, and bills velocity Verlet for five steps a "
    "frame") {
  const Contest found = contest(twice_a_second, example_bounds);
  CHECK(found.methods[0].method == &rk4);
  CHECK(found.methods[0].last.substeps == 1);
  CHECK(entry_of(found, velocity_verlet).last.substeps == 5);
  CHECK(found.methods[0].evaluations < 288);
}

TEST_CASE("Velocity Verlet with drag divided at the end has more room and only order one") {
  const Method divided =
      measure::method_of([](auto& x, auto& v, auto, double h, const auto& spring) {
        const auto pull = [&] { return -spring.omega * spring.omega * x; };
        v = v + h / 2 * pull();
        x = x + h * v;
        v = (v + h / 2 * pull()) / (1 + h * spring.damping());
      });
  for (const double zeta : {0.0, 0.5, 1.0, 2.0}) {
    CHECK_THAT(stable_until(divided, zeta), WithinAbs(2, 1e-6));
  }
  // Symplectic Euler with the division: 2 (sqrt(1 + zeta^2) + zeta) is 4 at zeta = 0.75.
  const auto& rival = method::linear_damping_implicit_last;
  CHECK_THAT(measure::longest_stable_step(rival, spring_of(0.75)), WithinRel(4, 1e-6));
  const double gain = max_position_error(divided, suspension, 1.0 / 960, 1) /
                      max_position_error(divided, suspension, 1.0 / 1920, 1);
  CHECK_THAT(gain, WithinAbs(2, 0.1));
}

TEST_CASE("To a millimetre only the lamp pays more, and the level an eighth more") {
  for (const auto& [name, found] : contests_to_within(centimetre / 10)) {
    INFO(name);
    const Entry& before = taken(contests_to_within(centimetre).at(name));
    const Entry& now = taken(found);
    CHECK(now.method == before.method);
    CHECK(now.evaluations == (name == "lamp" ? 2 : 1) * before.evaluations);
  }
  CHECK(total_to_within(centimetre / 10) == 1.125 * total_to_within(centimetre));
}
