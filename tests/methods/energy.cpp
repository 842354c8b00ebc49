// SPDX-License-Identifier: MIT-0
// What a step does to the energy of an undamped spring.
#include "measure/energy.h"

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <limits>
#include <tuple>
#include <type_traits>
#include <typeinfo>

#include "measure/methods.h"
#include "measure/stability.h"
#include "scenes/spring.h"
#include "theory.h"

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using scenes::Spring;

namespace {

// These turn and stretch every state alike: the energy is multiplied by the square of |R(i w)|,
// where w = h omega.
double closed_gain(measure::Euler, double w) {
  return 1 + w * w;
}
double closed_gain(theory::OneOf<measure::Midpoint, measure::Heun> auto, double w) {
  return 1 + std::pow(w, 4) / 4;
}
double closed_gain(theory::OneOf<measure::Rk4, measure::Rk4Linear> auto, double w) {
  return 1 - std::pow(w, 6) / 72 + std::pow(w, 8) / 576;
}
double closed_gain(measure::Dopri5, double w) {
  return 1 - std::pow(w, 6) / 1800 + std::pow(w, 8) / 1600 - std::pow(w, 10) / 14400 +
         std::pow(w, 12) / 360000;
}
double closed_gain(measure::PredictedEuler, double w) {
  return 1 - w * w + std::pow(w, 4);
}
double closed_gain(theory::OneOf<measure::BackwardEuler, measure::BackwardEulerNewton,
                                 measure::BackwardEulerSpring> auto,
                   double w) {
  return 1 / (1 + w * w);
}
double closed_gain(theory::OneOf<measure::Trapezoid, measure::TrapezoidNewton, measure::SpringExact,
                                 measure::SpringFolded> auto,
                   double) {
  return 1;
}

// Without a closed form here, it is that of the factor.
template <class Method>
double gain(Method method, double w) {
  if constexpr (requires { closed_gain(method, w); }) {
    return closed_gain(method, w);
  } else {
    return std::norm(theory::factor(method, theory::Complex(0, w)));
  }
}

constexpr auto stretches = [](auto method) { return theory::HasFactor<decltype(method)>; };
using Stretching = list::Joined<list::Where<stretches>, list::OnSprings>;

// These tilt what they turn, and so keep an ellipse of their own: an energy of x, v and h that is
// close to the true one. Here omega is 1.
double kept(theory::OneOf<measure::SymplecticEuler, measure::StormerVerlet,
                          measure::StormerVerletDistance, measure::StormerVerletUneven> auto,
            double x, double v, double w) {
  return v * v + x * x - w * x * v;
}
double kept(measure::SymplecticEulerPositionFirst, double x, double v, double w) {
  return v * v + x * x + w * x * v;
}
double kept(theory::OneOf<measure::Leapfrog, measure::VelocityVerlet> auto, double x, double v,
            double w) {
  return v * v + (1 - w * w / 4) * x * x;
}
double kept(measure::LeapfrogDrift, double x, double v, double w) {
  return (1 - w * w / 4) * v * v + x * x;
}
double kept(measure::StormerVerletCarried, double x, double v, double w) {
  const double half_step_ago = (v + w / 2 * x) / (1 + w * w / 2);
  return kept(measure::StormerVerlet(), x, half_step_ago, w);
}
double kept(measure::Yoshida4, double x, double v, double w) {
  // Of a matrix [p, q; r, p] with p^2 - q r = 1, on x and h v.
  const Eigen::Matrix3d step = theory::yoshida4({w * w, 0});
  const double q = step(0, 1), r = step(1, 0) - w * w * step(1, 2);
  return q * v * v - r / (w * w) * x * x;
}

constexpr auto tilts = [](auto method) { return requires { kept(method, 0.0, 0.0, 0.0); }; };
using Tilting = list::Where<tilts>;

// BDF2 has two factors for each of a spring's two motions; tests/methods/bdf2.cpp has what they
// leave.
constexpr auto has_its_own = [](auto method) {
  return std::is_base_of_v<measure::KeepsLastState, decltype(method)> ||
         std::is_same_v<measure::ConstantAcceleration, decltype(method)>;
};
constexpr auto has_no_formula = [](auto method) {
  return !stretches(method) && !tilts(method) && !has_its_own(method);
};
static_assert(std::is_same_v<list::Among<list::EveryGeneral, has_no_formula>, std::tuple<>>,
              "tests/methods/energy.cpp: a method without a formula for what it does to the energy "
              "of a spring");

}  // namespace

TEMPLATE_LIST_TEST_CASE("On an undamped spring each step multiplies the energy by its formula", "",
                        Stretching) {
  INFO(typeid(TestType).name());
  for (const double w : {0.01, 0.1, 0.5, 1.0, 2.5, 5.0}) {
    const double omega = 7, h = w / omega;
    const Spring<> spring{.omega = omega, .x0 = 0.3, .v0 = -2};
    double before = 0;
    scenes::State<double> s = spring.start();
    measure::run(TestType(), spring, s, h, 100, [&](double t, const auto& now) {
      const double energy = spring.energy(now.x, now.v);
      // Room for the sum of a method's stages, which may be ten times as large as what it comes to.
      if (t > 0) CHECK_THAT(energy / before, WithinRel(gain(TestType(), w), 1e-13));
      before = energy;
    });
  }
}

TEMPLATE_LIST_TEST_CASE("On an undamped spring each keeps an energy of its own, for ever", "",
                        Tilting) {
  INFO(typeid(TestType).name());
  for (const double w : {0.01, 0.5, 1.5}) {
    const double omega = 7;
    const Spring<> spring{.omega = omega, .x0 = 0.3, .v0 = -2};
    const auto own = [&](double x, double v) { return kept(TestType(), x, v / omega, w); };
    double first = 0, last = 0;
    scenes::State<double> s = spring.start();
    measure::run(TestType(), spring, s, w / omega, 10'001, [&](double t, const auto& now) {
      // The velocity of position Verlet is not the one that it was started with.
      if (t > 0 && first == 0) first = own(now.x, now.v);
      last = own(now.x, now.v);
    });
    const double rounding = 10'000 * 4 * std::numeric_limits<double>::epsilon();
    CHECK_THAT(last, WithinRel(first, rounding));
  }
}

TEST_CASE("A constant acceleration per step makes an undamped spring grow with every step, too") {
  for (const double w : {0.01, 0.1, 1.0}) {
    const Spring<> spring{.omega = 7};
    // It tilts and stretches: the square of the growth is the determinant.
    const double radius = measure::spectral_radius(measure::constant_acceleration, spring, w / 7);
    CHECK_THAT(radius * radius, WithinRel(1 + w * w / 2, 1e-13));
    const long steps = 1000;
    const auto end =
        measure::after(measure::constant_acceleration, spring, spring.start(), w / 7, steps);
    const double growth = spring.energy(end.x, end.v) / spring.energy(spring.x0, spring.v0);
    // Apart from the tilt, which takes or gives a part of the energy that does not grow.
    CHECK_THAT(std::log(growth), WithinAbs(double(steps) * std::log1p(w * w / 2), 1));
  }
}
