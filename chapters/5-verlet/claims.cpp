// SPDX-License-Identifier: MIT-0
// The claims of chapter 5. Each name is a sentence that the chapter says.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "float_digits.h"
#include "jitter_runs.h"
#include "measure/energy.h"
#include "measure/error.h"
#include "measure/evaluations.h"
#include "measure/methods.h"
#include "measure/stability.h"
#include "rope_runs.h"
#include "scenes/orbit.h"
#include "scenes/pendulum.h"
#include "toys.h"
#include "two_ropes.h"
#include "verlet_starts.h"
#include "wheel_runs.h"

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using measure::leapfrog;
using measure::stormer_verlet;
using measure::stormer_verlet_carried;
using measure::velocity_verlet;
using scenes::LinearDrag;
using scenes::Spring;

namespace {

constexpr Spring<> bouncy{.omega = 3, .x0 = 0.4, .v0 = 1.3};

template <class Step, class Scene>
measure::Halving last_halving(Step step, const Scene& scene, double h = 1.0 / 64) {
  return measure::halvings(step, scene, h, 4.0, 4).back();
}

/// What a method keeps after some steps.
template <class Step, class Scene>
auto kept_after(Step step, const Scene& scene, double h, long steps) {
  auto memory = measure::start(step, scene.start(), h, scene);
  for (long n = 0; n < steps; ++n) measure::advance(step, memory, double(n) * h, h, scene);
  return memory;
}

/// The largest distance between the positions of two methods in 1000 steps.
template <class One, class Other, class Scene>
double apart(One one, Other other, const Scene& scene, double h) {
  double most = 0;
  auto a = measure::start(one, scene.start(), h, scene);
  auto b = measure::start(other, scene.start(), h, scene);
  for (long n = 0; n < 1000; ++n) {
    measure::advance(one, a, double(n) * h, h, scene);
    measure::advance(other, b, double(n) * h, h, scene);
    most = std::max(most, measure::length(a[0] - b[0]));
  }
  return most;
}

constexpr scenes::Pendulum<> pendulum{.angle = 2};
const scenes::Orbit<> orbit{.eccentricity = 0.6};

// A position is rounded in every step, which changes the distance to the next one, and so moves all
// positions that follow: n steps may add n^2 / 2 roundings.
const double rounding = 1000 * 1000 / 2 * std::numeric_limits<double>::epsilon();

/// The order that steps of h/2 and 3h/2 in turn have on a spring.
template <class Step>
double order_of_uneven(Step step) {
  double error[2] = {};
  for (const int fine : {0, 1}) {
    const double h = 1.0 / (fine ? 480 : 240);
    int n = 0;
    uneven_run(
        step, bouncy, 3, [&] { return (n++ % 2 + 0.5) * h; },
        [&](double t, double x) {
          error[fine] = std::max(error[fine], std::abs(x - bouncy.exact(t).x));
        });
  }
  return std::log2(error[0] / error[1]);
}

/// A weight on a stick that turns freely, pushed back along the direction that it had.
struct OldDirection : Spoke {
  void step_along_the_old() {
    const Vec old = x;
    step();
    const double along = x.dot(old);
    x += (std::sqrt(along * along - x.squaredNorm() + 1) - along) * old;
  }
};

}  // namespace

TEST_CASE("At 60 steps a second a rope of stiff springs is longer than 100 m after five frames") {
  const auto s = measure::after(stormer_verlet, rope_of_springs, rope_of_springs.start(), frame, 5);
  CHECK(length_of(s.x) > 100);
  const auto later =
      measure::after(stormer_verlet, rope_of_springs, rope_of_springs.start(), frame, 8);
  CHECK_THAT(length_of(later.x), WithinRel(0.9 * 384.4e6, 0.1));  // of the way to the moon
  const auto calm =
      measure::after(stormer_verlet, rope_of_springs, rope_of_springs.start(), frame / 6, 3600);
  CHECK(length_of(calm.x) < 2.2);
}

TEST_CASE(
    "At 360 steps a second the stiff springs hold two metres, and at 60 links do, to a tenth") {
  auto s = rope_of_springs.start();
  measure::run(stormer_verlet, rope_of_springs, s, frame / 6, 600,
               [&](double, const auto& now) { REQUIRE_THAT(length_of(now.x), WithinRel(2, 0.1)); });
  Rope rope = two_metres(20, {1, 0});
  for (int n = 0; n < 100; ++n) {
    rope.step(frame, 8);
    REQUIRE_THAT(2 * (1 + stretch(rope)), WithinRel(2, 0.1));
  }
}

TEST_CASE("After 42 frames a rope reaches beyond its two metres with one iteration and with four") {
  const auto reach = [](int iterations) {
    Rope rope = two_metres(20, {1, 0});
    for (int n = 0; n < 42; ++n) rope.step(frame, iterations);
    double most = 0;
    for (const Vec& point : rope.x) most = std::max(most, point.norm());
    return most;
  };
  CHECK_THAT(reach(1), WithinAbs(2.77, 0.01));
  CHECK_THAT(reach(4), WithinAbs(2.36, 0.01));
  CHECK(reach(64) < 2);
}

TEST_CASE("The fastest motion of the stiff rope is 102 swings a second, of one of its springs 72") {
  CHECK_THAT(fastest_swing(), WithinAbs(102, 0.5));
  // Twenty equal masses held at one end: the formula for neighbours against neighbours.
  const double root = std::sqrt(rope_of_springs.k / rope_of_springs.mass);
  CHECK_THAT(fastest_swing() * 2 * std::numbers::pi,
             WithinRel(2 * root * std::sin(39 * std::numbers::pi / 82), 1e-6));
  // Two masses and one spring, by running them.
  const double h = 1e-5;
  double x = 1e-3, v = 0;  // of one mass; the other mirrors it
  int swings = 0;
  for (int n = 0; n < 100'000; ++n) {
    const double before = x;
    integrate::symplectic_euler(x, v, 0.0, h, [](double place, double, double) {
      return -rope_of_springs.k * 2 * place / rope_of_springs.mass;
    });
    swings += before < 0 && x >= 0;
  }
  CHECK(swings == 72);
}

TEST_CASE("With its own start position Verlet has order two, in the position") {
  for (const double order : {last_halving(stormer_verlet, drone).position_order,
                             last_halving(stormer_verlet, swing).position_order}) {
    CHECK_THAT(order, WithinAbs(2, 0.05));
  }
}

TEST_CASE("Started with x_previous = x, position Verlet has order zero in motion") {
  CHECK_THAT(last_halving(from_rest, drone).position_order, WithinAbs(0, 0.01));
  CHECK(last_halving(from_rest, drone).error.position > 10);
}

TEST_CASE("Started with x_previous = x, position Verlet has order one from rest") {
  CHECK_THAT(last_halving(from_rest, swing, 1.0 / 512).position_order, WithinAbs(1, 0.05));
}

TEST_CASE("Started with x - h v, position Verlet goes through the places of symplectic Euler") {
  CHECK(apart(by_velocity, measure::symplectic_euler, drone, frame) < 10 * rounding);
  CHECK(apart(by_velocity, measure::symplectic_euler, pendulum, frame) < rounding);
  CHECK_THAT(last_halving(by_velocity, drone).position_order, WithinAbs(1, 0.05));
}

TEST_CASE("Under a constant force position Verlet is exact with its own start, else as swapped") {
  const LinearDrag<> fall{.c = 0};
  const auto fallen = [&](auto step) {
    return -measure::after(step, fall, fall.start(), frame, 10).x / (fall.g * frame * frame);
  };
  CHECK_THAT(fallen(stormer_verlet), WithinRel(50, 1e-12));
  CHECK_THAT(fallen(from_rest), WithinRel(55, 1e-12));
  CHECK_THAT(fallen(measure::symplectic_euler), WithinRel(55, 1e-12));
}

TEST_CASE("Position Verlet, leapfrog and velocity Verlet go through the same places") {
  const auto same = [](const auto& scene, double h) {
    CHECK(apart(stormer_verlet, leapfrog, scene, h) < rounding);
    CHECK(apart(stormer_verlet, velocity_verlet, scene, h) < rounding);
    CHECK(apart(stormer_verlet, measure::midpoint, scene, h) > 1000 * rounding);
  };
  same(pendulum, 1.0 / 60);
  same(orbit, 1.0 / 60);
  same(bouncy, 1.0 / 60);
}

TEST_CASE("Leapfrog's velocity is the last distance of position Verlet over the step") {
  for (const long steps : {1L, 10L, 200L}) {
    const auto positions = kept_after(stormer_verlet, pendulum, frame, steps);
    const auto frog = kept_after(leapfrog, pendulum, frame, steps);
    CHECK_THAT(integrate::stormer_verlet_velocity(positions[0], positions[1], frame),
               WithinAbs(frog[1], 1e-11));
  }
}

TEST_CASE("Begun half a kick back, symplectic Euler takes the steps of leapfrog bit for bit") {
  const double h = 1.0 / 60;
  auto s = pendulum.start();
  double x = s.x, v_half = integrate::leapfrog_start(s.x, s.v, 0.0, h, pendulum);
  CHECK(v_half == s.v - h / 2 * pendulum(s.x, s.v, 0.0));
  s.v = v_half;
  for (int n = 0; n < 1000; ++n) {
    integrate::leapfrog(x, v_half, n * h, h, pendulum);
    integrate::symplectic_euler(s.x, s.v, n * h, h, pendulum);
    CHECK(s.x == x);
    CHECK(s.v == v_half);
  }
}

TEST_CASE("Velocity Verlet's velocity is the mean of leapfrog's before and after") {
  for (const long steps : {1L, 10L, 200L}) {
    const double before = kept_after(leapfrog, pendulum, frame, steps)[1];
    const double after = kept_after(leapfrog, pendulum, frame, steps + 1)[1];
    CHECK_THAT(kept_after(velocity_verlet, pendulum, frame, steps)[1],
               WithinAbs((before + after) / 2, 1e-12));
    CHECK(std::abs(before - after) > 1e-3);
  }
}

TEST_CASE("Each of the three asks for the acceleration once in a step") {
  CHECK(measure::evaluations_per_step(stormer_verlet, pendulum, frame) == 1);
  CHECK(measure::evaluations_per_step(leapfrog, pendulum, frame) == 1);
  CHECK(measure::evaluations_per_step(velocity_verlet, pendulum, frame) == 1);
}

TEST_CASE("Position Verlet's velocity has order one, leapfrog's and velocity Verlet's two") {
  CHECK_THAT(last_halving(stormer_verlet, bouncy).velocity_order, WithinAbs(1, 0.02));
  CHECK_THAT(last_halving(leapfrog, bouncy).velocity_order, WithinAbs(2, 0.02));
  CHECK_THAT(last_halving(velocity_verlet, bouncy).velocity_order, WithinAbs(2, 0.02));
}

TEST_CASE("In a fall position Verlet's velocity is short by g h / 2") {
  const LinearDrag<> fall{.c = 0};
  for (const long steps : {1L, 60L}) {
    const auto s = measure::after(stormer_verlet, fall, fall.start(), frame, steps);
    CHECK_THAT(s.v - fall.exact(double(steps) * frame).v, WithinAbs(9.81 * frame / 2, 1e-10));
  }
}

TEST_CASE("Half a kick of the acceleration brings position Verlet's velocity to order two") {
  CHECK_THAT(last_halving(stormer_verlet_carried, bouncy).velocity_order, WithinAbs(2, 0.02));
}

TEST_CASE(
    "In single precision position Verlet loses more than ten times what velocity Verlet does") {
  CHECK(lost_digits(stormer_verlet) > 10 * lost_digits(velocity_verlet));
  CHECK(lost_digits(stormer_verlet) < 1e-4);
}

TEST_CASE("With its last distance kept position Verlet loses no more than velocity Verlet") {
  CHECK(lost_digits(measure::stormer_verlet_distance) < 1.1 * lost_digits(velocity_verlet));
  // In double both swing alike.
  const Spring<> slow{.omega = 6.28, .x0 = 1};
  auto s = slow.start(), other = s;
  measure::run(measure::stormer_verlet_distance, slow, s, 1 / 240.0, 2400,
               [](double, const auto&) {});
  measure::run(stormer_verlet, slow, other, 1 / 240.0, 2400, [](double, const auto&) {});
  CHECK_THAT(s.x, WithinAbs(other.x, 1e-11));
}

TEST_CASE("All three hold an undamped spring while h omega is less than two, and none beyond") {
  const auto widest_swing = [](auto step, double homega) {
    double most = 0;
    auto s = Spring<>{.v0 = 0.5}.start();
    measure::run(step, Spring<>{}, s, homega, 10'000,
                 [&](double, const auto& now) { most = std::max(most, std::abs(now.x)); });
    return most;
  };
  const auto held = [&](auto step) {
    CHECK(widest_swing(step, 1.99) < 20);
    CHECK(widest_swing(step, 2.01) > 1e6);
  };
  held(stormer_verlet);
  held(leapfrog);
  held(velocity_verlet);
}

TEST_CASE("At the price of 60 evaluations a second Verlet beats midpoint and RK4 beats Verlet") {
  const auto error = [](auto step, int rate) {
    return measure::largest_error(step, drone, 1.0 / rate, 8 * rate).position;
  };
  CHECK_THAT(error(measure::midpoint, 30) / error(velocity_verlet, 60), WithinAbs(16, 0.5));
  CHECK_THAT(error(measure::heun, 30) / error(velocity_verlet, 60), WithinAbs(16, 0.5));
  CHECK_THAT(error(measure::symplectic_euler, 60) / error(velocity_verlet, 60), WithinAbs(147, 5));
  CHECK(error(measure::rk4, 15) < error(velocity_verlet, 60) / 100);
}

TEST_CASE(
    "After an hour the drone has its energy under Verlet, and 1.3 per cent more by midpoint") {
  const auto gain = [](auto step, int rate) {
    const auto energy = [](auto& x, auto& v) { return drone.energy(x, v); };
    return measure::drift(step, drone, 1.0 / rate, 3600 * rate, energy);
  };
  CHECK(gain(velocity_verlet, 60).largest < 1e-4);
  CHECK_THAT(gain(measure::midpoint, 30).last, WithinAbs(0.0128, 0.0002));
}

TEST_CASE("Under drag position Verlet and leapfrog have order one, and velocity Verlet two") {
  for (const auto& [halving, order] : {std::pair{last_halving(stormer_verlet, leaf), 1},
                                       std::pair{last_halving(leapfrog, leaf), 1},
                                       std::pair{last_halving(velocity_verlet, leaf), 2},
                                       std::pair{last_halving(stormer_verlet_carried, leaf), 2}}) {
    CHECK_THAT(halving.position_order, WithinAbs(order, 0.03));
    CHECK_THAT(halving.velocity_order, WithinAbs(order, 0.03));
  }
}

TEST_CASE("A leaf ends at the right speed by all three") {
  for (const double speed : {measure::after(stormer_verlet, leaf, leaf.start(), frame, 2000).v,
                             measure::after(leapfrog, leaf, leaf.start(), frame, 2000).v,
                             measure::after(velocity_verlet, leaf, leaf.start(), frame, 2000).v}) {
    CHECK_THAT(-speed, WithinRel(leaf.terminal_speed(), 1e-9));
  }
}

TEST_CASE("Drag alone is stable under position Verlet while c h < 2, by velocity Verlet to 1") {
  const LinearDrag<> drag{.c = 1, .g = 0};
  CHECK_THAT(measure::stability_limit(stormer_verlet, drag, 0.1, 10.0), WithinAbs(2, 1e-9));
  CHECK_THAT(measure::stability_limit(leapfrog, drag, 0.1, 10.0), WithinAbs(2, 1e-9));
  CHECK_THAT(measure::stability_limit(velocity_verlet, drag, 0.1, 10.0), WithinAbs(1, 1e-9));
}

TEST_CASE("A damper shrinks position Verlet's limit to 2 (sqrt(1 + zeta^2) - zeta)") {
  for (const double zeta : {0.1, 0.5, 1.0, 2.0}) {
    const double limit = 2 * (std::sqrt(1 + zeta * zeta) - zeta);
    CHECK_THAT(measure::stability_limit(stormer_verlet, Spring<>{.zeta = zeta}, 1e-3, 4.0),
               WithinRel(limit, 1e-9));
  }
}

TEST_CASE("A damper shrinks velocity Verlet's limit to 2 (sqrt(1 + 4 zeta^2) - 2 zeta)") {
  for (const double zeta : {0.1, 0.5, 1.0, 2.0}) {
    const double limit = 2 * (std::sqrt(1 + 4 * zeta * zeta) - 2 * zeta);
    CHECK_THAT(measure::stability_limit(velocity_verlet, Spring<>{.zeta = zeta}, 1e-3, 4.0),
               WithinRel(limit, 1e-9));
  }
}

TEST_CASE("A factor of 0.99 in each step brakes twice as hard at 60 steps a second as at 30") {
  const auto kept = [](int rate) { return std::pow(0.99, rate); };
  for (const int rate : {30, 60, 144}) {
    CHECK_THAT(braked(rate), WithinRel(kept(rate), 1e-12));
  }
  CHECK_THAT(std::log(braked(60)) / std::log(braked(30)), WithinAbs(2, 1e-9));
}

TEST_CASE("Without a force position Verlet moves equally far in every frame, long or short") {
  const LinearDrag<> ice{.c = 0, .g = 0};
  double x = 0, x_previous = -0.05;
  for (const double length : frames::recorded) {
    const double before = x;
    integrate::stormer_verlet(x, x_previous, 0.0, length, ice);
    REQUIRE_THAT(x - before, WithinAbs(0.05, 1e-12));
  }
}

TEST_CASE(
    "With recorded frames for steps, ten jumps of position Verlet reach from 0.46 to 1.84 m") {
  double lowest = INFINITY, highest = 0;
  for (std::size_t first = 0; first < 600; first += 60) {
    lowest = std::min(lowest, top(plain, jump, first));
    highest = std::max(highest, top(plain, jump, first));
  }
  CHECK_THAT(lowest, WithinAbs(0.46, 0.005));
  CHECK_THAT(highest, WithinAbs(1.845, 0.005));
}

TEST_CASE("Corrected, position Verlet jumps exactly, whatever the frames") {
  for (std::size_t first = 0; first < 600; first += 60) {
    frames::Playback frames{.at = first};
    uneven_run(
        corrected, jump, 1.0, [&] { return frames.next(); },
        [](double t, const auto& x) { CHECK_THAT(x.y(), WithinAbs(jump.exact(t).x.y(), 1e-12)); });
  }
}

TEST_CASE("With only the distance corrected, a jump is up to three centimetres low") {
  double lowest = INFINITY;
  for (std::size_t first = 0; first < 600; first += 60) {
    lowest = std::min(lowest, top(distance_corrected, jump, first));
  }
  CHECK_THAT(jump.exact(5 / 9.81).x.y() - lowest, WithinAbs(0.032, 0.002));
}

TEST_CASE("On uneven steps the corrected formula has order two, uncorrected it has none") {
  CHECK_THAT(order_of_uneven(corrected), WithinAbs(2, 0.05));
  CHECK_THAT(order_of_uneven(plain), WithinAbs(0, 0.05));
}

TEST_CASE("On recorded frames a strong spring swings five times too far, corrected as it is") {
  CHECK_THAT(widest(corrected, 20), WithinAbs(5.5, 0.1));
  CHECK_THAT(widest(corrected, 2), WithinAbs(1, 0.003));
  // With steps of one length, the longest of all: a swing of at most 1 / sqrt(1 - (h omega / 2)^2).
  const double longest = *std::max_element(frames::recorded.begin(), frames::recorded.end());
  CHECK(20 * longest < 2);
}

TEST_CASE("Torn over hundreds of metres, at ten steps a second, a rope of links comes back") {
  Rope rope = two_metres(20, {1, 0});
  for (std::size_t i = 1; i < rope.x.size(); ++i) {
    rope.x[i] += 100 * Vec(std::sin(double(i * i)), std::cos(double(3 * i)));
  }
  CHECK(stretch(rope) > 1000);
  for (int n = 0; n < 3000; ++n) rope.step(0.1, 50);
  CHECK_THAT(stretch(rope), WithinRel(hanging(20, 0.1, 50), 0.01));
}

TEST_CASE("Position-based dynamics moves a rope as position Verlet does") {
  Rope rope = two_metres(20, {1, 0}), written_down = rope;
  std::vector<Vec> v(21, Vec::Zero());
  for (int n = 0; n < 100; ++n) {
    rope.step(frame, 8);
    const std::vector<Vec> before = written_down.x;
    for (std::size_t i = 1; i < v.size(); ++i) {
      v[i] += frame * gravity(before[i], v[i], 0.0);
      written_down.x[i] += frame * v[i];
    }
    for (int k = 0; k < 8; ++k) {
      for (std::size_t i = 1; i < v.size(); ++i) written_down.pull(i);
    }
    for (std::size_t i = 1; i < v.size(); ++i) v[i] = (written_down.x[i] - before[i]) / frame;
  }
  for (std::size_t i = 1; i < v.size(); ++i) {
    CHECK((rope.x[i] - written_down.x[i]).norm() < 1e-9);
  }
}

TEST_CASE("With one iteration a hanging rope of n links is stretched by n (n - 1) g h^2 / 2") {
  for (const int links : {1, 2, 10, 20}) {
    for (const double h : {frame, frame / 2}) {
      CHECK_THAT(2 * hanging(links, h, 1), WithinAbs(stretch_of_stiff_links(links, h), 2e-5));
    }
  }
}

TEST_CASE("XPBD stretches a rope by what was asked for plus the stretch of stiff links") {
  for (const int substeps : {1, 4, 8, 16, 32}) {
    CHECK_THAT(hangs_longer(substeps, true), WithinAbs(1 + hangs_longer(substeps, false), 1e-3));
  }
}

TEST_CASE("Position Verlet without a velocity takes the steps of its header") {
  double x = 1, x_previous = 0.98, y = x, y_previous = x_previous;
  for (int n = 0; n < 600; ++n) {
    without_velocity(x, x_previous, frame, [](double place) { return -9 * place; });
    integrate::stormer_verlet(y, y_previous, 0.0, frame,
                              [](double place, double, double) { return -9 * place; });
    CHECK_THAT(x, WithinAbs(y, 1e-9));
  }
}

TEST_CASE("A hanging rope of n links is stretched by about n^2 g h^2 / (2 q)") {
  for (const int links : {10, 20}) {
    for (const double h : {frame, frame / 2}) {
      for (const int q : {1, 2, 4}) {
        const double predicted = links * links * 9.81 * h * h / (2 * q);
        CHECK_THAT(2 * hanging(links, h, q), WithinRel(predicted, 0.14));  // for many links
      }
    }
  }
}

TEST_CASE(
    "A link that is pulled is 2 j g h^2 / q too long, and about half of that after the step") {
  for (const int q : {1, 2, 4}) {
    const auto links = hanging_links(20, frame, q);
    const double each = 9.81 * frame * frame / q;
    CHECK_THAT(links.back().pulled,
               WithinRel(20 * each, 1e-6));  // under the nail, which doesn't give
    for (std::size_t i = 0; i < links.size() - 1; ++i) {
      const double carried = double(i + 1);
      CHECK_THAT(links[i].pulled, WithinRel(2 * carried * each, 1e-6));
      if (carried >= 10) CHECK_THAT(links[i].after / links[i].pulled, WithinAbs(0.46, 0.02));
    }
  }
}

TEST_CASE(
    "In recorded frames a rope that hangs is at times four times as stretched as it should be") {
  const double rule = hanging(20, frame, 8);
  for (const auto& [least, most] :
       {hanging_in_recorded_frames(plain, 20, 8), hanging_in_recorded_frames(corrected, 20, 8)}) {
    CHECK(most > 4 * rule);
    CHECK(least < -rule);
  }
}

TEST_CASE("Eight steps of one iteration stretch a rope an eighth as far as one step of eight") {
  CHECK_THAT(hanging(20, frame, 8) / hanging(20, frame / 8, 1), WithinAbs(8, 0.3));
}

TEST_CASE("A weight of p points stretches a hanging rope by (n - 1) (p - 1) g h^2 / q more") {
  const auto stretch = [](double weight, int substeps, int iterations) {
    const double n = double(RopeWithWeight::links), h = frame / substeps;
    return (n * (n - 1) / 2 + (n - 1) * (weight - 1)) * 9.81 * h * h / iterations / 2;  // of 2 m
  };
  for (const double weight : {1.0, 5.0, 10.0, 20.0}) {
    for (const int substeps : {1, 4, 8}) {
      CHECK_THAT(hanging_with_weight(weight, substeps, 1),
                 WithinRel(stretch(weight, substeps, 1), 1e-3));
    }
    for (const int iterations : {2, 4, 8}) {
      CHECK_THAT(hanging_with_weight(weight, 1, iterations),
                 WithinRel(stretch(weight, 1, iterations), 1.0 / 7));
    }
  }
}

TEST_CASE("With a weight at its end, too, eight substeps stretch a rope an eighth as far") {
  for (const double weight : {2.0, 10.0, 20.0}) {
    CHECK_THAT(hanging_with_weight(weight, 1, 8) / hanging_with_weight(weight, 8, 1),
               WithinAbs(8, 0.3));
  }
}

TEST_CASE(
    "A weight that falls over a peg stretches a rope three times as far in eight iterations as in "
    "eight substeps") {
  const auto most = [](double weight, int substeps, int iterations) {
    RopeWithWeight rope = level_rope(weight);
    double farthest = 0;
    for (int n = 0; n < 120; ++n) {
      rope.frame_of(rope.x[0], substeps, iterations);
      farthest = std::max(farthest, rope.stretch());
    }
    return farthest;
  };
  for (const double weight : {2.0, 5.0, 10.0, 20.0}) {
    CAPTURE(weight);
    CHECK_THAT(most(weight, 1, 8) / most(weight, 8, 1), WithinAbs(3.3, 0.5));
  }
}

TEST_CASE(
    "In six substeps a rope of links is as stiff as the springs that need six, within a third") {
  // By the weights below each: 1 + 2 + ... + 20 of them in all.
  const double stretch_of_springs =
      210 * rope_of_springs.mass * rope_of_springs.g / rope_of_springs.k / rope_of_springs.length;
  CHECK_THAT(stretch_of_springs, WithinRel(0.01, 1e-12));
  CHECK_THAT(hanging(20, frame / 6, 1), WithinRel(stretch_of_springs, 1.0 / 3));
  const auto at = [](int substeps) {
    const auto s = measure::after(stormer_verlet, rope_of_springs, rope_of_springs.start(),
                                  frame / substeps, 600);
    return length_of(s.x);
  };
  CHECK(at(6) < 2.2);
  CHECK(!(at(5) < 1e6));
}

TEST_CASE("A curtain of 30 links needs ten substeps at 30 frames a second, or 86 iterations") {
  CHECK(2 * hanging(30, 1.0 / 30 / 9, 1) > 0.05);
  CHECK_THAT(2 * hanging(30, 1.0 / 30 / 10, 1), WithinAbs(0.0474, 0.0001));
  const double one_iteration = 30 * 29 * 9.81 / (2 * 30.0 * 30);
  CHECK(std::ceil(one_iteration / 0.05) == 95);
  CHECK(2 * hanging(30, 1.0 / 30, 86 - 1) > 0.05);
  CHECK(2 * hanging(30, 1.0 / 30, 86) < 0.05);
}

TEST_CASE("Half the frame rate stretches a rope four times as far") {
  CHECK_THAT(hanging(20, 2 * frame, 8) / hanging(20, frame, 8), WithinAbs(4, 0.05));
}

TEST_CASE("A weight on a link loses seven tenths of its height in ten seconds") {
  const auto rises_again = [](int substeps) {
    Rope rope = two_metres(1, {1, 0});
    std::vector<double> heights;
    for (int n = 0; n <= 600; ++n) {
      heights.push_back(rope.x[1].y());
      for (int substep = 0; substep < substeps; ++substep) rope.step(frame / substeps, 1);
    }
    return 2 + last_rise(heights);
  };
  CHECK_THAT(rises_again(1) / 2, WithinAbs(0.3, 0.005));
  CHECK_THAT(rises_again(8), WithinAbs(1.647, 0.001));
}

TEST_CASE("A spoke that turns once a second is more than six times too long after a second") {
  Spoke spoke{frame};
  for (int n = 0; n < 60; ++n) spoke.step();
  // A straight line along the first step, whose length is the chord of that angle.
  CHECK_THAT(
      spoke.x.norm(),
      WithinAbs(std::sqrt(1 + 60.0 * 61 * std::pow(2 * std::sin(spin * frame / 2), 2)), 1e-9));
  CHECK(spoke.x.norm() > 6);
}

TEST_CASE("Normalised, a spoke keeps two thirds of its spin for a second and a quarter for ten") {
  Spoke spoke{frame};
  for (int n = 0; n < 60; ++n) spoke.step_and_normalize();
  CHECK_THAT(spoke.speed() / spin, WithinAbs(0.66, 0.01));
  for (int n = 0; n < 540; ++n) spoke.step_and_normalize();
  CHECK_THAT(spoke.speed() / spin, WithinAbs(0.266, 0.005));
  CHECK_THAT(spoke.x.norm(), WithinRel(1, 1e-15));
}

TEST_CASE("A normalised spoke slows down as 1 / sqrt(1 / spin^2 + 2 h t)") {
  Spoke spoke{frame / 8};
  for (int n = 0; n < 8 * 300; ++n) spoke.step_and_normalize();
  CHECK_THAT(spoke.speed(), WithinRel(1 / std::sqrt(1 / (spin * spin) + 2 * frame / 8 * 5), 0.005));
}

TEST_CASE("A quaternion loses its length by position Verlet, and normalised its spin") {
  Eigen::Vector4d q{1, 0, 0, 0};
  Eigen::Vector4d before{std::cos(spin * frame / 2), 0, 0, -std::sin(spin * frame / 2)};
  Eigen::Vector4d kept = q, kept_before = before;
  for (int n = 0; n < 60; ++n) {
    integrate::stormer_verlet(q, before, 0.0, frame, nothing);
    integrate::stormer_verlet(kept, kept_before, 0.0, frame, nothing);
    kept.normalize();
  }
  CHECK(q.norm() > 3);
  const double speed = 2 * std::acos(kept.dot(kept_before)) / frame;
  CHECK(speed < 0.9 * spin);
  CHECK(speed > 0.8 * spin);
}

TEST_CASE("An angle turns freely at one speed by position Verlet") {
  double angle = 0, before = -spin * frame;
  for (int n = 0; n < 600; ++n) integrate::stormer_verlet(angle, before, 0.0, frame, nothing);
  CHECK_THAT(angle, WithinRel(spin * 10, 1e-11));
}

TEST_CASE("A box of four points keeps its sides to a ten-thousandth and loses its spin") {
  Box box(frame);
  double off = 0;
  for (int n = 0; n < 600; ++n) {
    box.step(4);
    for (std::size_t i = 0; i < 4; ++i) {
      off = std::max(off, std::abs((box.x[(i + 1) % 4] - box.x[i]).norm() - 1));
    }
  }
  CHECK(off < 1e-4);
  CHECK(off > 1e-5);
  CHECK_THAT(box.speed() / spin, WithinAbs(0.264, 0.01));
  Box often(frame / 8);
  for (int n = 0; n < 4800; ++n) often.step(1);
  CHECK_THAT(often.speed() / spin, WithinAbs(0.61, 0.01));
}

TEST_CASE("Pushed back along its old direction, a spoke keeps its length and its spin") {
  OldDirection spoke{{frame}};
  for (int n = 0; n < 600; ++n) spoke.step_along_the_old();
  CHECK_THAT(spoke.x.norm(), WithinRel(1, 1e-12));
  CHECK_THAT(spoke.speed(), WithinRel(spin, 1e-10));
}
