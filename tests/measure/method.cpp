// SPDX-License-Identifier: MIT-0
// A method behind one type takes the very steps of its header.
#include "measure/method.h"

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <stdexcept>

#include "measure/compiled.h"
#include "measure/method_of.h"
#include "measure/methods.h"
#include "scenes/orbit.h"
#include "scenes/spring.h"

namespace {

using Special = list::Joined<list::Damping, list::OnSprings>;

// Neither has a Jacobian or a damping to hand on.
const auto bare = [](double x, double, double) { return -x; };

template <class Listed, class Scene>
void check_same_steps(const Scene& scene) {
  const auto by_header = measure::after(Listed(), scene, scene.start(), 0.01, 100);
  const auto behind = measure::after(measure::method_of<Listed>(), scene, scene.start(), 0.01, 100);
  CHECK(by_header.x == behind.x);
  CHECK(by_header.v == behind.v);
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("A method behind one type has the bits of its header", "", list::General) {
  INFO(TestType::name);
  check_same_steps<TestType>(scenes::Spring<>{.omega = 3, .zeta = 0.2});
  check_same_steps<TestType>(scenes::Orbit<>());
}

TEMPLATE_LIST_TEST_CASE(
    "A method for damping or springs alone behind one type has the bits of its header", "",
    Special) {
  INFO(TestType::name);
  check_same_steps<TestType>(scenes::Spring<>{.omega = 3, .zeta = 0.2});
}

TEST_CASE("The registry's methods bear the names of the list") {
  CHECK(method::rk4.name == "RK4");
  CHECK(method::linear_damping_exact.header == "linear_damping.h");
}

TEST_CASE("A method that asks a scene for what it has not says so") {
  const auto step = [](const measure::Method& method) {
    measure::after(method, bare, scenes::State<double>{1, 0}, 0.1, 1);
  };
  CHECK_NOTHROW(step(method::rk4));
  CHECK_THROWS_AS(step(method::backward_euler), std::logic_error);
  CHECK_THROWS_AS(step(method::linear_damping_exact), std::logic_error);
}

TEST_CASE("A method that doesn't move such vectors says so") {
  const auto on_a_line =
      measure::method_of([](double& x, double& v, double, double h, const auto&) { x += h * v; });
  const scenes::Orbit<> orbit;
  CHECK_THROWS_AS(measure::after(on_a_line, orbit, orbit.start(), 0.1, 1), std::logic_error);
}
