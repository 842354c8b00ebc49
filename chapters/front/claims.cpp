// SPDX-License-Identifier: MIT-0
// The claims of the front page. Each name is a sentence that the page says.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <vector>

#include "measure/methods.h"
#include "race.h"

using Catch::Matchers::WithinAbs;

namespace {

struct Seen {
  double nearest = INFINITY, farthest = 0;  // m
  double last = 0;                          // s
  std::vector<Eigen::Vector2d> places;
  double largest_miss = 0;  // m
};

template <class Step>
Seen seen(const Step& step, double rate = price) {
  Seen found;
  race(step, rate, [&](double t, const auto& s) {
    found.nearest = std::min(found.nearest, s.x.norm());
    found.farthest = std::max(found.farthest, s.x.norm());
    found.last = t;
    found.places.push_back(s.x);
    found.largest_miss = std::max(found.largest_miss, (s.x - race_shuttle.exact(t).x).norm());
  });
  return found;
}

double largest_difference(const std::vector<Eigen::Vector2d>& a,
                          const std::vector<Eigen::Vector2d>& b) {
  REQUIRE(a.size() == b.size());
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a[i] - b[i]).norm());
  return largest;
}

constexpr int last = turns - 1;

}  // namespace

TEST_CASE("For 15 evaluations a second Euler has left the picture before half a turn is over") {
  double left = INFINITY;
  race(measure::euler, price, [&](double t, const auto& s) {
    if (s.x.norm() > picture) left = std::min(left, t);
  });
  CHECK(left < shuttle_turn / 2);
  CHECK(left > shuttle_turn / 4);
}

TEST_CASE("For 15 evaluations a second backward Euler and its prediction crash in half a turn") {
  CHECK(seen(measure::backward_euler).nearest < planet);
  CHECK(seen(measure::backward_euler).last < shuttle_turn / 2);
  CHECK(seen(measure::predicted_euler<1>).nearest < planet);
  CHECK(seen(measure::predicted_euler<1>).last < shuttle_turn / 2);
}

TEST_CASE(
    "For 15 evaluations a second midpoint doubles the orbit, Heun makes it 2.7 times as long") {
  CHECK_THAT(ellipse_of(measure::midpoint, last).semi_major / 10, WithinAbs(2, 0.1));
  CHECK_THAT(ellipse_of(measure::heun, last).semi_major / 10, WithinAbs(2.7, 0.1));
}

TEST_CASE("For 15 evaluations a second RK4 sinks by a fifth in twenty turns") {
  CHECK_THAT(ellipse_of(measure::rk4, last).semi_major / 10, WithinAbs(0.8, 0.01));
}

TEST_CASE("For twenty turns Verlet and symplectic Euler stay between 4.9 and 15.5 metres") {
  for (const Seen& found : {seen(measure::velocity_verlet), seen(measure::symplectic_euler)}) {
    CHECK(found.last > 0.99 * turns * shuttle_turn);
    CHECK(found.nearest > 4.9);
    CHECK(found.farthest < 15.5);
    CHECK(found.farthest > 15);  // at its farthest it is where it should be, and beyond
  }
}

TEST_CASE(
    "In twenty turns Verlet and symplectic Euler turn the orbit by eleven to twelve degrees") {
  const auto turned = [](auto step) {
    return ellipse_of(step, last).direction() - ellipse_of(step, 0).direction();
  };
  CHECK_THAT(turned(measure::velocity_verlet), WithinAbs(-11.5, 0.5));
  CHECK_THAT(turned(measure::symplectic_euler), WithinAbs(-11.5, 0.5));
}

TEST_CASE("The three forms of Verlet's method go through the same places") {
  const auto verlet = seen(measure::velocity_verlet).places;
  // Rounding of 20 m, a hundred times over in each of 2400 steps.
  CHECK(largest_difference(verlet, seen(measure::stormer_verlet).places) < 1e-9);
  CHECK(largest_difference(verlet, seen(measure::leapfrog).places) < 1e-9);
  CHECK(largest_difference(verlet, seen(measure::symplectic_euler).places) > 1);
}

TEST_CASE("For 60 evaluations a second RK4 is nearer to the true shuttle than the other seven") {
  const double rk4 = seen(measure::rk4, 60).largest_miss;
  CHECK(rk4 < 0.5);
  for (const Seen& other :
       {seen(measure::euler, 60), seen(measure::midpoint, 60), seen(measure::heun, 60),
        seen(measure::backward_euler, 60), seen(measure::predicted_euler<1>, 60),
        seen(measure::velocity_verlet, 60), seen(measure::symplectic_euler, 60)}) {
    CHECK(other.largest_miss > 2 * rk4);
  }
}
