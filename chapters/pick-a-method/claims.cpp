// SPDX-License-Identifier: MIT-0
// The claims of the page to pick a method. Each name is a sentence that the page says.
#include <Eigen/Core>
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <iterator>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "../cast.h"
#include "calls.h"
#include "measure/methods.h"
#include "measure/run.h"
#include "rates.h"
#include "rope.h"

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using measure::always;
using scenes::Spring;

namespace {

/// A vector as a game has it.
struct Vec {
  double x = 0, y = 0;

  friend Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y}; }
  friend Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y}; }
  friend Vec operator*(double s, Vec a) { return {s * a.x, s * a.y}; }
  friend double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y; }
  friend double length(Vec a) { return std::hypot(a.x, a.y); }
};

constexpr double tick = 1.0 / 60;

/// A spring that swings so often in a second, let go at some place of its swing.
Spring<> spring_of(double swings, double zeta, double phase) {
  const double omega = 2 * std::numbers::pi * swings;
  return {.omega = omega, .zeta = zeta, .x0 = std::cos(phase), .v0 = -omega * std::sin(phase)};
}

/// How far ten swings are off at most, as a share of the swing, from a handful of starts.
double farthest_off(const measure::Method& method, double swings, double zeta, double h) {
  const long steps = std::lround(std::floor(10 / swings / h));
  double most = 0;
  for (const double phase : {0.0, 0.7, 1.6, 2.4}) {
    const Spring<> spring = spring_of(swings, zeta, phase);
    auto s = spring.start();
    measure::run(method, spring, s, h, steps, [&](double t, const auto& now) {
      const double error = std::abs(now.x - spring.exact(t).x);
      if (!(error <= most)) most = error;
    });
  }
  return most;
}

/// What the page says of every answer.
const std::vector<Rates>& all_rates() {
  static const std::vector<Rates> all = [] {
    std::vector<Rates> found;
    for (const Answer& answer : answers) found.push_back(rates_of(answer));
    return found;
  }();
  return all;
}

/// How far an orbit is off within so many turns, from a place of its own, as a share of half its
/// long axis.
double off_orbit_from(const measure::Method& method, double eccentricity, double steps_a_turn,
                      double turns, double place) {
  const scenes::Orbit<> orbit{.eccentricity = eccentricity, .semi_major = 7, .mu = 3};
  const double since = place * orbit.period();
  auto s = orbit.exact(since);
  double most = 0;
  measure::run(method, orbit, s, orbit.period() / steps_a_turn, std::lround(turns * steps_a_turn),
               [&](double t, const auto& now) {
                 const double error = (now.x - orbit.exact(since + t).x).norm() / orbit.semi_major;
                 if (!(error <= most)) most = error;
               });
  return most;
}

/// A spring on every axis.
auto pull(double omega) {
  return [omega](Vec x, Vec, double) { return (-omega * omega) * x; };
}

/// How far something is from where a spring without a damper would be, let go at (1, 0).
double off_after(double seconds, double omega, Vec x) {
  return length(x - Vec{std::cos(omega * seconds), 0});
}

}  // namespace

TEST_CASE(
    "With the steps that the page asks for springs of 0.3 to 25 swings a second are as near as it "
    "says",
    "[long]") {
  for (std::size_t which = 0; which < std::size(answers); ++which) {
    const Answer& answer = answers[which];
    const Rates& rates = all_rates()[which];
    for (std::size_t i = 0; i < rates.within.size(); ++i) {
      for (const double swings : {0.3, 1.0, 2.7, 9.0, 25.0}) {
        for (const double ticks : {30.0, 60.0, 144.0}) {
          const double steps = steps_a_tick(rates.within[i], swings, ticks);
          const double h = 1 / (ticks * steps);
          // Where that takes long, one spring in one game is enough.
          if (rates.within[i] > 5000 && (ticks != 60 || swings != 2.7)) continue;
          for (const double zeta : dampings_of(answer)) {
            CAPTURE(answer.method.name, tolerances[i], swings, ticks, zeta, steps);
            CHECK(farthest_off(answer.method, swings, zeta, h) <= tolerances[i]);
          }
        }
      }
    }
  }
}

TEST_CASE("With a fifth fewer steps than the page asks for a spring is farther off than it says",
          "[long]") {
  for (std::size_t which = 0; which < std::size(answers); ++which) {
    const Answer& answer = answers[which];
    const Rates& rates = all_rates()[which];
    for (std::size_t i = 0; i < rates.within.size(); ++i) {
      if (rates.within[i] == rates.stands) continue;  // asked for only so as not to explode
      double most = 0;
      for (const double zeta : dampings_of(answer)) {
        const double h = 1 / (0.8 * rates.within[i]);
        most = std::max(most, farthest_off(answer.method, 1, zeta, h));
      }
      CAPTURE(answer.method.name, tolerances[i], rates.within[i]);
      CHECK(most > tolerances[i]);
    }
  }
}

TEST_CASE(
    "With the steps to stand every spring stands, and with under half of them not every one") {
  const auto farthest = [](const measure::Method& method, double steps_a_swing, double zeta) {
    const Spring<> spring = spring_of(1, zeta, 0.3);
    auto s = spring.start();
    double most = 0;
    measure::run(method, spring, s, 1 / steps_a_swing, 20'000, [&](double, const auto& now) {
      most = std::isfinite(now.x) ? std::max(most, std::abs(now.x)) : INFINITY;
    });
    return most;
  };
  for (std::size_t which = 0; which < std::size(answers); ++which) {
    const Answer& answer = answers[which];
    const double stands = all_rates()[which].stands;
    CAPTURE(answer.method.name, stands);
    double most = 0;
    for (int percent = 0; percent <= (answer.damped ? 100 : 0); percent += 5) {
      const double zeta = percent / 100.0;
      CAPTURE(zeta);
      CHECK(farthest(answer.method, stands > 0 ? stands : 0.01, zeta) < 2);
      if (stands > 0) most = std::max(most, farthest(answer.method, 0.48 * stands, zeta));
    }
    if (stands > 0) CHECK(most > 1e6);
  }
}

TEST_CASE("What the page lets run for ever keeps areas and can be run back") {
  CHECK(measure::VelocityVerlet::symplectic);
  CHECK(measure::VelocityVerlet::reversible);
  CHECK(measure::Yoshida4::symplectic);
  CHECK(measure::Yoshida4::reversible);
  CHECK(measure::Yoshida4::order > measure::VelocityVerlet::order);
  CHECK(measure::VelocityVerlet::evaluations == 1);
}

TEST_CASE("What the page takes where forces switch asks once in a step and is of low order") {
  CHECK(measure::SymplecticEuler::evaluations == 1);
  CHECK(measure::SymplecticEuler::order == 1);
  CHECK(measure::SymplecticEuler::symplectic);
  CHECK(measure::StormerVerlet::evaluations == 1);
}

TEST_CASE("What the page takes for stiff springs has no limit on springs or on drag") {
  CHECK(measure::BackwardEuler::spring_limit == always);
  CHECK(measure::BackwardEuler::drag_limit == always);
  CHECK(measure::Bdf2::spring_limit == always);
  CHECK(measure::Bdf2::drag_limit == always);
  for (const measure::Method* method :
       {&method::backward_euler, &method::backward_euler_spring, &method::bdf2}) {
    for (const double h : {0.01, 1.0, 100.0, 1e4}) {
      for (const double zeta : {0.0, 0.1, 1.0, 10.0}) {
        CAPTURE(method->name, h, zeta);
        CHECK(measure::spectral_radius(*method, Spring<>{.zeta = zeta}, h) < 1);
      }
    }
  }
}

TEST_CASE("What the page takes to watch closely has order four under drag, and Yoshida has not") {
  CHECK(measure::Rk4::order == 4);
  CHECK(measure::Rk4::drag_order == 4);
  CHECK(measure::Yoshida4::drag_order == 2);
}

TEST_CASE("With the lines of the page a leaf and a pellet are where drag and gravity take them") {
  for (const double h : {0.001, tick, 0.25}) {
    for (const double c : {0.02, leaf.c, 40.0}) {
      for (const double start : {0.0, 800.0}) {
        CAPTURE(h, c, start);
        Vec x{}, v{start, 0};
        const int ticks = int(std::lround(2 / h));
        for (int n = 0; n < ticks; ++n) move_in_air(x, v, h, Vec{0, -leaf.g}, c);
        // From Newton's law in the form of d/dt (v e^(ct)) = g e^(ct)
        const double seconds = ticks * h, left = std::exp(-c * seconds), last = leaf.g / c;
        CHECK_THAT(v.x, WithinAbs(start * left, 1e-10));
        CHECK_THAT(v.y, WithinAbs(-last * (1 - left), 1e-10));
        CHECK_THAT(x.x, WithinAbs(start * (1 - left) / c, 1e-9));
        CHECK_THAT(x.y, WithinAbs(-last * (seconds - (1 - left) / c), 1e-9));
      }
    }
  }
}

TEST_CASE(
    "Against drag by the square of the speed RK4 is 1 % off at most below h k v = 1/2, and "
    "explodes "
    "from 2.5") {
  // Slower and slower for a second: how far it is off at most, as a share of the way and the speed
  const auto worst_off = [](double hkv) {
    const double fast = 300, k = hkv / (tick * fast);
    const auto drag = [k](Vec, Vec v, double) { return (-k * length(v)) * v; };
    Vec x{}, v{fast, 0};
    double worst = 0;
    for (int n = 1; n <= 60; ++n) {
      move_closely(x, v, (n - 1) * tick, tick, 1, drag);
      const double true_x = std::log1p(n * hkv) / k, true_v = fast / (1 + n * hkv);
      for (const double off : {length(x - Vec{true_x, 0}) / true_x, std::abs(v.x / true_v - 1)}) {
        if (!(off <= worst)) worst = off;
      }
    }
    return worst;
  };
  for (const double below : {0.01, 0.1, 0.3, 0.5}) CHECK(worst_off(below) < 0.01);
  CHECK(worst_off(0.75) > 0.01);
  CHECK(worst_off(2.4) < 10);
  for (const double beyond : {2.5, 3.0, 7.0, 50.0}) CHECK(!(worst_off(beyond) < 1e10));
}

TEST_CASE(
    "Divided by 1 + h k v, drag by the square of the speed brakes right from h k v = 0.01 to 50, "
    "and the last speed is right") {
  const double fast = 300;
  for (const double hkv : {0.01, 0.5, 2.5, 7.0, 50.0}) {
    const double k = hkv / (tick * fast);
    CAPTURE(hkv);
    const auto nothing = [](Vec, Vec, double) { return Vec{}; };
    Vec x{}, v{fast, 0};
    for (int n = 1; n <= 60; ++n) {
      move_with_drag(x, v, 0.0, tick, 1, k * length(v), nothing);
      CHECK_THAT(v.x, WithinRel(fast / (1 + n * hkv), 1e-12));
    }
    const auto gravity = [](Vec, Vec, double) { return Vec{0, -9.81}; };
    v = {0, -fast};
    for (int n = 0; n < 6000; ++n) move_with_drag(x, v, 0.0, tick, 1, k * length(v), gravity);
    CHECK_THAT(v.y, WithinRel(-std::sqrt(9.81 / k), 1e-6));
  }
}

TEST_CASE("A camera behind a runner is where a spring with a moving target takes it") {
  for (const double zeta : {0.2, 1.0, 3.0}) {
    for (const double h : {0.003, tick, 0.2}) {
      CAPTURE(zeta, h);
      const double omega = 40;
      const Vec start{5, -3}, u{10, 2};
      Vec x{1, 0}, v{0, 4}, target = start;
      // The same in many steps of RK4, which knows nothing of a lag
      Vec x_true = x, v_true = v;
      const auto spring = [&](Vec at, Vec speed, double t) {
        return (-omega * omega) * (at - start - t * u) + (-2 * zeta * omega) * speed;
      };
      const int ticks = int(std::lround(1 / h));
      for (int n = 0; n < ticks; ++n) {
        move_on_spring(x, v, h, target, u, omega, zeta);
        target = target + h * u;
        for (int i = 0; i < 4000 / ticks; ++i) {
          const double small = h / (4000 / ticks);
          integrate::rk4(x_true, v_true, n * h + i * small, small, spring);
        }
        CHECK(length(x - x_true) < 1e-6);
        CHECK(length(v - v_true) < 1e-4);
      }
    }
  }
}

TEST_CASE("On a spring gravity moves the place of rest by g / omega^2, and nothing else") {
  const double omega = 12, g = 9.81;
  Vec x{0, 0.3}, v{1, 0}, x_true = x, v_true = v;
  const auto both = [&](Vec at, Vec speed, double) {
    return (-omega * omega) * at + (-2 * 0.3 * omega) * speed + Vec{0, -g};
  };
  for (int n = 0; n < 60; ++n) {
    move_on_spring(x, v, tick, Vec{0, -g / (omega * omega)}, Vec{}, omega, 0.3);
    for (int i = 0; i < 50; ++i) integrate::rk4(x_true, v_true, 0.0, tick / 50, both);
    CHECK(length(x - x_true) < 1e-7);
  }
}

TEST_CASE("Steps that are uneven by half about double RK4's error") {
  const double omega = 2 * std::numbers::pi, even_h = 1.0 / 20;
  const auto off_with = [&](double share, unsigned seed) {
    std::mt19937 random(seed);
    Vec x{1, 0}, v{};
    double t = 0, most = 0;
    while (t < 10) {
      const double h = even_h * (1 + share * (double(random()) / 2147483648.0 - 1));
      integrate::rk4(x, v, t, h, pull(omega));
      t += h;
      most = std::max(most, off_after(t, omega, x));
    }
    return most;
  };
  const double even = off_with(0, 1);
  for (unsigned seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    CHECK(off_with(0.5, seed) < 2.2 * even);
    CHECK(off_with(0.5, seed) > 1.6 * even);
  }
}

TEST_CASE("A push and a step of backward Euler on the spring are backward Euler under both") {
  const Vec wind{3, -2}, anchor{1, 4};
  const double omega = 80, zeta = 0.3, h = tick;
  Vec x{2, 2}, v{-1, 5};
  // Backward Euler, by the equation that its end has to meet
  Vec x_end = x, v_end = v;
  move_stiff(x_end, v_end, 0, h, 1, anchor, omega, zeta, [&](Vec, Vec, double) { return wind; });
  const Vec a = wind + (-omega * omega) * (x_end - anchor) + (-2 * zeta * omega) * v_end;
  CHECK(length(x_end - (x + h * v_end)) < 1e-12);
  CHECK(length(v_end - (v + h * a)) < 1e-10);
}

namespace {

struct Body {
  double m;
  Vec x, v;
};

constexpr Vec axis{0.6, 0.8};

/// The forces of a spring a metre long between two bodies, over their masses.
auto spring_between(double k) {
  return [k](const Body& one, const Body& two) {
    const double force = k * (dot(two.x - one.x, axis) - 1);
    return std::pair{(force / one.m) * axis, (-force / two.m) * axis};
  };
}

}  // namespace

TEST_CASE("Between two bodies the lines of the page brake how fast they part, and nothing else") {
  const double k = 50, d = 5;
  for (const int steps : {1, 7}) {
    Body one{1, {0, 0}, {10, -3}}, two{3, {0.6, 0.8}, {10.6, -2.2}};
    const double light = 1 / one.m + 1 / two.m, omega = std::sqrt(k * light);
    const Spring<> relative{.omega = omega, .zeta = d * light / (2 * omega)};
    double apart = 0, parting = 1;  // how much longer the spring is than at rest
    const Vec momentum = one.m * one.v + two.m * two.v;
    for (int n = 0; n < 60; ++n) {
      move_pair(one, two, axis, d, tick, steps, spring_between(k));
      for (int i = 0; i < steps; ++i) {
        measure::linear_damping_implicit_last(apart, parting, 0.0, tick / steps, relative);
      }
      CHECK_THAT(dot(two.x - one.x, axis) - 1, WithinAbs(apart, 1e-12));
      CHECK_THAT(dot(two.v - one.v, axis), WithinAbs(parting, 1e-11));
    }
    CHECK(length(one.m * one.v + two.m * two.v - momentum) < 1e-11);
  }
}

TEST_CASE(
    "Two bodies on a spring swing as near the truth as the steps that the page asks for say") {
  const double omega = 20;
  const auto& within = all_rates()[1].within;
  REQUIRE(answers[1].method.function == "linear_damping_implicit_last");
  for (std::size_t i = 0; i < within.size(); ++i) {
    for (const double zeta : {0.0, 0.1, 1.0}) {
      Body one{1, {0, 0}, {}}, two{3, {1.2, 1.6}, {}};  // stretched by a metre
      const double light = 1 / one.m + 1 / two.m;
      const Spring<> truth{.omega = omega, .zeta = zeta, .x0 = 1, .v0 = 0};
      const int steps = int(steps_a_tick(within[i], omega / (2 * std::numbers::pi), 60));
      for (int n = 1; n <= 180; ++n) {
        move_pair(one, two, axis, 2 * zeta * omega / light, tick, steps,
                  spring_between(omega * omega / light));
        CAPTURE(tolerances[i], zeta, steps, n);
        CHECK_THAT(dot(two.x - one.x, axis) - 1, WithinAbs(truth.exact(n * tick).x, tolerances[i]));
      }
    }
  }
}

TEST_CASE("By the lines of the page a weight on a link let go level falls as a pendulum does") {
  const auto gravity = [](Vec, Vec, double) { return Vec{0, -9.81}; };
  const auto pull_link = [](Vec& place) { place = (1 / length(place)) * place; };
  for (const int steps : {1, 8}) {
    Vec x{1, 0}, v{};
    double angle = std::numbers::pi / 2, turning = 0;
    Vec last = start_linked(x, v, 0.0, tick, steps, gravity);
    for (int n = 0; n < 30; ++n) {
      move_linked(x, v, last, n * tick, tick / steps, steps, gravity, pull_link);
      for (int i = 0; i < 50; ++i) {
        integrate::rk4(angle, turning, 0.0, tick / 50,
                       [](double at, double, double) { return -9.81 * std::sin(at); });
      }
      const Vec truth{std::sin(angle), -std::cos(angle)};
      const Vec speed = turning * Vec{std::cos(angle), std::sin(angle)};
      CAPTURE(steps, n);
      CHECK(length(x - truth) < 0.04 / steps);
      // the velocity of half a step ago
      CHECK(length(v - speed) < 0.5 / steps);
    }
  }
}

TEST_CASE("The hanging rope of the page is stretched as far as one worked out along a line") {
  for (const int links : {10, 50}) {
    for (const int steps : {1, 4, 16}) {
      const double h = tick / steps, link = 2.0 / links;
      std::vector<double> down, before;
      for (int i = 0; i <= links; ++i) down.push_back(i * link);
      before = down;
      for (int n = 0; n < ticks_to_rest * steps; ++n) {
        for (std::size_t i = 1; i < down.size(); ++i) {
          const double next = 2 * down[i] - before[i] + 9.81 * h * h;
          before[i] = std::exchange(down[i], next);
        }
        for (std::size_t i = 1; i < down.size(); ++i) {
          const double too_far = down[i] - down[i - 1] - link;
          down[i - 1] += i > 1 ? too_far / 2 : 0;
          down[i] -= i > 1 ? too_far / 2 : too_far;
        }
      }
      CAPTURE(links, steps);
      CHECK_THAT(stretched(links, steps), WithinRel(down.back() / 2 - 1, 1e-6));
    }
  }
}

TEST_CASE("With the steps that the page asks for an orbit is as near as it says") {
  for (const measure::Method* method : of_orbits) {
    for (const Shape& shape : shapes) {
      for (const double tolerance : tolerances) {
        const double steps = steps_on_orbit(*method, shape.eccentricity, tolerance);
        // Other places to start at, other lengths, and less long an ellipse.
        for (const double more : {1.0, 1.137, 1.71}) {
          for (const double eccentricity : {shape.eccentricity, 0.6 * shape.eccentricity}) {
            CAPTURE(method->name, shape.name, tolerance, steps, more, eccentricity);
            CHECK(off_orbit_from(*method, eccentricity, more * steps, 10, 0.19) <= tolerance);
            CHECK(off_orbit_from(*method, eccentricity, more * steps, 10, 0.47) <= tolerance);
          }
        }
        CAPTURE(method->name, shape.name, tolerance, steps);
        CHECK(off_orbit_from(*method, shape.eccentricity, 0.8 * steps, 10, 0) > tolerance);
      }
    }
  }
}

TEST_CASE(
    "For a hundred times the turns Yoshida needs three times the steps, velocity Verlet ten") {
  for (const auto& [method, times] :
       {std::pair{&method::yoshida4, 3.2}, std::pair{&method::velocity_verlet, 10.0}}) {
    const double steps = steps_on_orbit(*method, 0, 0.01);
    CAPTURE(method->name, steps);
    CHECK(off_orbit_from(*method, 0, times * steps, 1000, 0) <= 0.01);
    CHECK(off_orbit_from(*method, 0, 0.8 * times * steps, 1000, 0) > 0.01);
  }
}

TEST_CASE("In float more than 150 steps of RK4 a swing bring a spring no nearer") {
  const auto off_with = [](double omega, double steps_a_swing) {
    const double h = 2 * std::numbers::pi / omega / steps_a_swing;
    const auto force = [stiff = float(omega * omega)](float x, float, double) {
      return -stiff * x;
    };
    double most = 0;
    for (const double phase : {0.0, 0.7, 1.6, 2.4}) {
      float x = float(std::cos(phase)), v = float(-omega * std::sin(phase));
      for (int n = 1; n <= 10 * steps_a_swing; ++n) {
        integrate::rk4(x, v, n * h, float(h), force);
        const double truth = std::cos(omega * double(float(h)) * n + phase);
        most = std::max(most, std::abs(double(x) - truth));
      }
    }
    return most;
  };
  for (const double omega : {0.785, 20.0, 500.0}) {
    CAPTURE(omega);
    // As near as in double with every step that the page asks for.
    const double steps = all_rates()[4].within[2];
    CHECK(off_with(omega, steps) <= 0.001);
    CHECK(off_with(omega, 150) < 0.5 * off_with(omega, 100));
    for (const double more : {250.0, 500.0, 1000.0, 4000.0}) {
      CHECK(off_with(omega, more) > off_with(omega, 150));
    }
  }
}

TEST_CASE("The lines of the page take what they are for to where it should be") {
  const double omega = 2 * std::numbers::pi;
  const auto forces = pull(omega);
  Vec x{1, 0}, v{};

  SECTION("a constant force") {
    x = {}, v = {3, 5};
    for (int n = 0; n < 60; ++n) move_by_constant(x, v, n * tick, tick, Vec{0, -9.81});
    CHECK(length(x - Vec{3, 5 - 9.81 / 2}) < 1e-12);
  }
  SECTION("the air") {
    x = {}, v = {};
    for (int n = 0; n < 120; ++n) move_in_air(x, v, tick, Vec{0, -leaf.g}, leaf.c);
    CHECK_THAT(v.y, WithinRel(leaf.exact(2).v, 1e-12));
    CHECK_THAT(x.y, WithinRel(leaf.exact(2).x, 1e-12));
  }
  SECTION("a spring") {
    const Vec target{7, 1};
    x = x + target;
    for (int n = 0; n < 75; ++n) move_on_spring(x, v, tick, target, Vec{}, omega, 0.0);
    CHECK(off_after(1.25, omega, x - target) < 1e-12);
  }
  SECTION("contacts") {
    for (int n = 0; n < 75; ++n) move_undamped(x, v, n * tick, tick, 6, forces);
    CHECK(off_after(1.25, omega, x) < 0.1);
  }
  SECTION("drag") {
    const Spring<> damped{.omega = omega, .zeta = 0.2};
    for (int n = 0; n < 75; ++n) {
      move_with_drag(x, v, n * tick, tick, 6, damped.damping(), forces);
    }
    CHECK_THAT(x.x, WithinAbs(damped.exact(1.25).x, 0.1));
  }
  SECTION("links") {
    const auto back_to_the_circle = [](Vec& place) { place = (1 / length(place)) * place; };
    x = {0, -1}, v = {0.1, 0};
    const auto gravity = [](Vec, Vec, double) { return Vec{0, -9.81}; };
    Vec last = start_linked(x, v, 0.0, tick, 8, gravity);
    for (int n = 0; n < 60; ++n) {
      move_linked(x, v, last, n * tick, tick / 8, 8, gravity, back_to_the_circle);
      CHECK_THAT(length(x), WithinAbs(1, 1e-12));
    }
    CHECK(std::abs(x.x) < 0.1 / std::sqrt(9.81));
  }
  SECTION("for ever, its place") {
    for (int n = 0; n < 75; ++n) move_for_ever(x, v, n * tick, tick, 1, forces);
    CHECK(off_after(1.25, omega, x) < 1e-3);
  }
  SECTION("for ever, its shape") {
    for (int n = 0; n < 75; ++n) move_in_shape(x, v, n * tick, tick, 1, forces);
    CHECK(off_after(1.25, omega, x) < 0.1);
  }
  SECTION("frames of any length") {
    std::vector<double> lengths;
    for (int n = 0; n < 50; ++n) lengths.push_back(n % 2 ? 0.04 : 0.01);
    const double reached = move_in_frames(x, v, tick, 4, lengths, forces);
    CHECK(off_after(reached, omega, x) < 0.01);
    CHECK_THAT(reached, WithinAbs(1.25, tick / 4));
  }
  SECTION("closely") {
    for (int n = 0; n < 75; ++n) move_closely(x, v, n * tick, tick, 1, forces);
    CHECK(off_after(1.25, omega, x) < 1e-4);
  }
  SECTION("to a tolerance") {
    move_within(x, v, 0, tick, 1.25, forces, 1e-9);
    CHECK(off_after(1.25, omega, x) < 1e-7);
  }
  SECTION("a stiff spring") {
    const auto nothing = [](Vec, Vec, double) { return Vec{}; };
    for (int n = 0; n < 60; ++n) move_stiff(x, v, n * tick, tick, 1, Vec{}, 600.0, 0.0, nothing);
    CHECK(length(x) < 1e-12);
  }
  SECTION("nets") {
    // Two masses between two walls.
    Eigen::VectorXd places = Eigen::Vector2d(1, -1), speeds = Eigen::Vector2d(0, 0);
    const double k = 1e6;
    const auto net = [k](const Eigen::VectorXd& at, const Eigen::VectorXd&, double) {
      return Eigen::VectorXd(-2 * k * at + k * at.reverse());
    };
    const auto jacobian = [k](const auto&, const auto&, double, auto&& add) {
      add(0, 0, -2 * k, 0.0), add(1, 1, -2 * k, 0.0);
      add(0, 1, k, 0.0), add(1, 0, k, 0.0);
    };
    for (int n = 0; n < 60; ++n) CHECK(move_net(places, speeds, n * tick, tick, net, jacobian));
    CHECK(places.norm() < 1e-12);
    // One that swings once a second, when both go the same way
    places = Eigen::Vector2d(2, 0), speeds = Eigen::Vector2d(0, 0);
    const double soft = omega * omega;
    const auto both = [&](const Eigen::VectorXd& at, const Eigen::VectorXd&, double) {
      return Eigen::VectorXd(-(k + soft) * at + k * at.reverse());
    };
    const auto slopes = [&](const auto&, const auto&, double, auto&& add) {
      add(0, 0, -(k + soft), 0.0), add(1, 1, -(k + soft), 0.0);
      add(0, 1, k, 0.0), add(1, 0, k, 0.0);
    };
    CHECK(move_slow(places, speeds, 0.0, tick, 60, both, slopes));
    CHECK((places - Eigen::Vector2d(1, 1)).norm() < 0.05);
  }
}
