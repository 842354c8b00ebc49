// SPDX-License-Identifier: MIT-0
// Halving the step divides both errors by 2 to the order: not by less, and not by more.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include "measure/methods.h"
#include "slopes.h"

TEMPLATE_LIST_TEST_CASE("On a pendulum that swings far, every method has its orders", "",
                        list::General) {
  INFO(TestType::header);
  order::check(TestType(), order::pendulum<order::Number<TestType>>(), TestType::order,
               TestType::velocity_order);
}

TEMPLATE_LIST_TEST_CASE("On an ellipse of eccentricity 0.6, every method has its orders", "",
                        list::General) {
  INFO(TestType::header);
  order::check(TestType(), order::kepler<order::Number<TestType>>(), TestType::order,
               TestType::velocity_order);
}

TEMPLATE_LIST_TEST_CASE("On a driven oscillator, every method has its orders", "", list::General) {
  INFO(TestType::header);
  order::check(TestType(), order::driven<order::Number<TestType>>(0.45), TestType::order,
               TestType::velocity_order);
}

TEMPLATE_LIST_TEST_CASE("Under a force with drag in it, every method has its orders for drag", "",
                        list::General) {
  INFO(TestType::header);
  order::check(TestType(), order::pushed<order::Number<TestType>>(), TestType::drag_order,
               TestType::drag_velocity_order);
}

TEMPLATE_LIST_TEST_CASE("Back in time, every method that may go there has the same orders", "",
                        list::General) {
  INFO(TestType::header);
  if (!TestType::allows_negative_step) return;
  order::check(TestType(), order::driven<order::Number<TestType>>(-0.45), TestType::order,
               TestType::velocity_order);
}

TEST_CASE("The reference is exact to 1e-16 where there is an exact solution") {
  SECTION("a planet on an ellipse") {
    const auto problem = order::kepler<long double>();
    scenes::State<scenes::Orbit<long double>::Vec> s = problem.start;
    for (int n = 0; n < 8; ++n) {
      s = reference::after(problem.scene, s, n * problem.part, (n + 1) * problem.part);
      CHECK((s.x - problem.truth[std::size_t(n)].x).norm() < 1e-16);
      CHECK((s.v - problem.truth[std::size_t(n)].v).norm() < 1e-16);
    }
  }
  SECTION("a driven oscillator") {
    const auto problem = order::driven<long double>(0.45);
    const auto found = order::by_reference(problem.scene, problem.start, problem.part);
    for (std::size_t n = 0; n < 8; ++n) {
      CHECK(std::abs(found[n].x - problem.truth[n].x) < 1e-16);
      CHECK(std::abs(found[n].v - problem.truth[n].v) < 1e-16);
    }
  }
}
