// SPDX-License-Identifier: MIT-0
// What the first lines over each method promise is what is measured.
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>

#include "measure/cost.h"
#include "measure/order.h"
#include "measure/stability.h"
#include "scenes/circle.h"
#include "scenes/linear_drag.h"
#include "scenes/projectile.h"
#include "scenes/spring.h"

using Catch::Matchers::WithinRel;

namespace {

// The comment over a method as one line of words.
std::string card(const std::string& method) {
  std::ifstream file(INTEGRATE_FOLDER "/" + method + ".h");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  return std::regex_replace(text, std::regex("\\s*\n\\s*(///)?\\s*"), " ");
}

std::string promised(const std::string& method, const std::string& pattern) {
  std::smatch found;
  const std::string text = card(method);
  INFO("looking for \"" << pattern << "\" over " << method);
  REQUIRE(std::regex_search(text, found, std::regex(pattern)));
  return found[1];
}

template <class Step>
void check_order_and_cost(const std::string& method, Step step) {
  const scenes::Circle<> circle;
  const auto study = measure::halvings(step, circle, 0.01, 5.0, 4);
  const double order = std::stod(promised(method, "Order ([0-9]+)[ ,]"));
  CHECK(std::abs(study.back().position_order - order) < 0.1);
  const char* const counts[] = {"no", "one", "two", "three", "four"};
  const auto evaluations = measure::evaluations_per_step(step, circle, 0.1);
  CHECK(promised(method, ", ([a-z]+) evaluations? of the acceleration") == counts[evaluations]);
}

template <class Step>
void check_drag_limit(const std::string& method, Step step) {
  const double limit = std::stod(promised(method, "stable on drag while c\\*h < ([0-9.]+)"));
  const scenes::LinearDrag<> drag{.c = 5, .g = 0};
  CHECK(measure::spectral_radius(step, drag, 0.999 * limit / 5) <= 1);
  CHECK(measure::spectral_radius(step, drag, 1.001 * limit / 5) > 1.0005);
}

}  // namespace

TEST_CASE("The card of the exact step of a constant acceleration says what is measured") {
  const std::string method = "constant_acceleration";
  check_order_and_cost(method, measure::constant_acceleration);
  promised(method, "(Exact for any h under a constant force)");
  const scenes::Projectile<> ball;
  const auto end = measure::after(measure::constant_acceleration, ball, ball.start(), 7.0, 1);
  CHECK((end.x - ball.exact(7).x).norm() < 1e-12);
  check_drag_limit(method, measure::constant_acceleration);
}

TEST_CASE("Euler's card says what is measured") {
  check_order_and_cost("euler", measure::euler);
  check_drag_limit("euler", measure::euler);
  const double per_zeta = std::stod(promised("euler", "h\\*omega < ([0-9.]+)\\*zeta"));
  for (const double zeta : {0.1, 0.5, 1.0}) {
    const scenes::Spring<> spring{.omega = 3, .zeta = zeta};
    CHECK_THAT(3 * measure::stability_limit(measure::euler, spring, 1e-3, 10.0),
               WithinRel(per_zeta * zeta, 1e-6));
  }
  promised("euler", "(never on an undamped one)");
  for (const double h : {1e-3, 1.0}) {
    CHECK(measure::spectral_radius(measure::euler, scenes::Spring<>(), h) > 1);
  }
}

TEST_CASE("Symplectic Euler's card says what is measured") {
  check_order_and_cost("symplectic_euler", measure::symplectic_euler);
  const double limit = std::stod(
      promised("symplectic_euler", "stable on an undamped spring while h\\*omega < ([0-9.]+)"));
  const scenes::Spring<> spring{.omega = 3};
  CHECK(measure::spectral_radius(measure::symplectic_euler, spring, 0.999 * limit / 3) < 1 + 1e-12);
  CHECK(measure::spectral_radius(measure::symplectic_euler, spring, 1.001 * limit / 3) > 1.01);
}
