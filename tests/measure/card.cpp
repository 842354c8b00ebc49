// SPDX-License-Identifier: MIT-0
// The lines of a card, on methods whose answers are known.
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <stdexcept>

#include "measure/card_lines.h"
#include "measure/compiled.h"
#include "measure/method_of.h"
#include "measure/methods.h"

using Catch::Matchers::WithinRel;
using measure::Card;
using measure::Method;
using measure::method_of;
using namespace measure::card_lines;

namespace {

Card energy_of(const Method& step) {
  Card card;
  energy(card, step);
  return card;
}

// The exact spring, but a part of the energy, in billionths, is lost on every step.
template <long Billionths>
Method losing() {
  return method_of([](double& x, double& v, double t, double h, const auto& spring) {
    measure::spring_exact(x, v, t, h, spring);
    x = std::sqrt(1 - 1e-9 * Billionths) * x;
    v = std::sqrt(1 - 1e-9 * Billionths) * v;
  });
}

measure::Cell order_of(const Method& step, const std::string& line) {
  Card card;
  orders(card, step, damped, "order", "on a damped spring");
  return card.at(line);
}

}  // namespace

TEST_CASE("The order on a card is that of the method, and a method without error is exact") {
  CHECK(std::abs(order_of(method::midpoint, "order").value - 2) < 0.01);
  CHECK(std::abs(order_of(method::rk4, "order-velocity").value - 4) < 0.01);
  CHECK(order_of(method::spring_exact, "order").words == "exact");
}

TEST_CASE("Position and velocity have orders of their own on a card") {
  Card card;
  orders(card, method::stormer_verlet, undamped, "order", "on a spring");
  CHECK(std::abs(card.at("order").value - 2) < 0.01);
  CHECK(std::abs(card.at("order-velocity").value - 1) < 0.01);
}

TEST_CASE("A card says never, any step, or the limit") {
  const scenes::Spring<> spring;
  CHECK(limit(method::euler, spring).words == "never");
  CHECK(limit(method::midpoint, spring).words == "never");  // it grows by h^4 / 8 in a step
  CHECK(limit(method::backward_euler_spring, spring).words == "any step");
  CHECK(limit(method::spring_exact, spring).words == "any step");
  CHECK_THAT(limit(method::symplectic_euler, spring).value, WithinRel(2, 1e-6));
  CHECK_THAT(limit(method::euler, scenes::Spring<>{.zeta = 0.1}).value, WithinRel(0.2, 1e-6));
}

TEST_CASE("Energy that swings is kept, however far it swings") {
  const Card card = energy_of(method::symplectic_euler);
  CHECK(card.at("energy").words == "kept");
  // v^2 + x (x - h v) is kept at h omega = 0.1, and so the energy stays within 0.1 / (2 - 0.1).
  CHECK_THAT(card.at("energy-off").value, WithinRel(100 * 0.1 / 1.9, 1e-3));
}

TEST_CASE("Energy that only swings below the first is off by that much") {
  // The half steps of velocity Verlet keep v^2 + x^2 (1 - h^2 / 4).
  CHECK_THAT(energy_of(method::velocity_verlet).at("energy-off").value, WithinRel(0.25, 1e-3));
}

TEST_CASE("Energy that swings further and further down is not kept") {
  const auto fading = [](double& x, double& v, double t, double h, const auto&) {
    x = std::cos(t + h);
    v = -std::sin(t + h) * (1 - 5e-6 * (t + h));
  };
  CHECK(energy_of(method_of(fading)).at("energy").words != "kept");
}

TEST_CASE("Energy that is exact is off by rounding") {
  const Card card = energy_of(method::spring_exact);
  CHECK(card.at("energy").words == "kept");
  CHECK(card.at("energy-off").words == "rounding");
}

TEST_CASE("A loss of one part in a hundred million on each step is no energy kept") {
  const Card card = energy_of(losing<10>());
  CHECK(card.at("energy").words == "falls");
  CHECK_THAT(card.at("energy-step").value, WithinRel(-1e-6, 1e-6));
  CHECK_THAT(card.at("energy-thousand").value, WithinRel(-1e-3, 1e-4));
  CHECK(energy_of(losing<-10>()).at("energy").words == "grows");
}

TEST_CASE("Energy that is all gone, or infinite, is not kept") {
  CHECK(energy_of(losing<500'000'000>()).at("energy").words == "falls");
  const Card card = energy_of(method::euler);
  CHECK(card.at("energy").words == "grows");
  CHECK_THAT(card.at("energy-step").value, WithinRel(1, 1e-9));
  CHECK_THAT(card.at("energy-thousand").value, WithinRel(100 * (std::pow(1.01, 1000) - 1), 1e-9));
}

TEST_CASE("Ten steps of free fall tell the methods of engines apart") {
  const auto fallen = [](const Method& step) {
    Card card;
    fall(card, step);
    return card.at("fall").value;
  };
  CHECK_THAT(fallen(method::euler), WithinRel(45, 1e-12));
  CHECK_THAT(fallen(method::constant_acceleration), WithinRel(50, 1e-12));
  CHECK_THAT(fallen(method::symplectic_euler), WithinRel(55, 1e-12));
}

TEST_CASE("A card says from how many to how many solves and evaluations a step took") {
  const auto step = [](double& x, double& v, double t, double h, const auto& scene) {
    const int iterations = v < 0 ? 2 : 5;
    for (int n = 0; n < iterations; ++n) {
      scene.jacobian(x, v, t, [](int, int, double, double) {});
      scene(x, v, t);
    }
    scene(x, v, t);
    measure::symplectic_euler(x, v, t, h, [](double at, double, double) { return -9.81 * at; });
  };
  Card card;
  solves(card, method_of(step));
  CHECK(card.at("solves").words == "2 to 5");
  CHECK(card.at("evaluations").words == "3 to 6");
}

TEST_CASE("A line that is not on the card is told by its name") {
  CHECK_THROWS_AS(Card{}.at("order"), std::out_of_range);
}
