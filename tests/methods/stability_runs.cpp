// SPDX-License-Identifier: MIT-0
// Just inside its limit a long run stays bounded; just outside it passes any bound.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <typeinfo>

#include "measure/methods.h"
#include "measure/run.h"
#include "scenes/linear_drag.h"
#include "scenes/spring.h"
#include "theory_of_limits.h"

using Catch::Matchers::WithinRel;
using scenes::LinearDrag;
using scenes::Spring;

namespace {

constexpr double zetas[] = {0, 0.1, 0.5, 1, 2};

// The fastest that a run gets.
template <class Step, class Scene>
double fastest(const Step& step, const Scene& scene, double h, long steps) {
  double most = 0;
  scenes::State<double> s = scene.start();
  measure::run(step, scene, s, h, steps, [&most](double, const scenes::State<double>& now) {
    if (!(std::abs(now.v) <= most)) most = std::abs(now.v);
  });
  return most;
}

// In the long run not twice as fast as ever in the first thousand steps: a growth of one part in
// 25,000 a step would show.
template <class Step, class Scene>
void check_bounded(const Step& step, const Scene& scene, double h) {
  CHECK(fastest(step, scene, h, 20'000) < 2 * fastest(step, scene, h, 1000));
}

// For as long as growing by `radius` a step takes to reach a million, twice over.
template <class Step, class Scene>
void check_blows_up(const Step& step, const Scene& scene, double h, double radius) {
  CAPTURE(h, radius);
  REQUIRE(radius > 1);
  const long steps = 1 + std::lround(2 * std::log(1e6) / std::log(radius));
  CHECK_FALSE(fastest(step, scene, h, steps) < 1e6);
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("On drag a run ends where c h passes the limit", "", list::General) {
  INFO(typeid(TestType).name());
  for (const double c : {0.5, 20.0}) {
    const LinearDrag<> drag{.c = c, .g = 0, .v0 = 3};
    const double limit = theory::drag_limit(TestType());
    if (limit == measure::always) {
      for (const double ch : {0.5, 5.0, 1e3}) check_bounded(TestType(), drag, ch / c);
      continue;
    }
    const auto polynomial = theory::characteristic(TestType(), theory::drag(1.03 * limit));
    check_bounded(TestType(), drag, 0.97 * limit / c);
    check_blows_up(TestType(), drag, 1.03 * limit / c, theory::radius_of_velocity(polynomial));
  }
}

TEMPLATE_LIST_TEST_CASE("On springs a run ends where h omega passes the limit", "", list::General) {
  INFO(typeid(TestType).name());
  for (const double zeta : zetas) {
    CAPTURE(zeta);
    const Spring<> spring{.omega = 30, .zeta = zeta, .x0 = 0.5, .v0 = -0.3};
    const double limit = theory::spring_limit(TestType(), zeta);
    if (limit == measure::always) {
      for (const double angle : {0.5, 5.0, 1e3}) check_bounded(TestType(), spring, angle / 30);
      continue;
    }
    const double outside = limit == 0 ? 0.2 : 1.03 * limit;
    const auto polynomial = theory::characteristic(TestType(), theory::spring(outside, zeta));
    if (limit > 0) check_bounded(TestType(), spring, 0.97 * limit / 30);
    check_blows_up(TestType(), spring, outside / 30, theory::radius(polynomial));
  }
}

TEMPLATE_LIST_TEST_CASE("Inside its limit a run on drag and gravity finds the terminal speed", "",
                        list::General) {
  INFO(typeid(TestType).name());
  // All methods but those with damping of their own take the drag from the force, so at the
  // terminal speed nothing changes any more.
  const LinearDrag<> leaf{.c = 20, .v0 = 3};
  const double ch = std::min(0.9 * theory::drag_limit(TestType()), 2.0);
  const auto end = measure::after(TestType(), leaf, leaf.start(), ch / leaf.c, 1000);
  CHECK_THAT(end.v, WithinRel(-leaf.terminal_speed(), 1e-12));
}

TEST_CASE("Euler on drag alternates around the terminal speed when c h is between 1 and 2") {
  const LinearDrag<> leaf{.c = 2};
  double x = 0, v = 0;
  for (int n = 0; n < 10; ++n) {
    integrate::euler(x, v, 0.0, 0.75, leaf);
    CHECK((v < -leaf.terminal_speed()) == (n % 2 == 0));
  }
}
