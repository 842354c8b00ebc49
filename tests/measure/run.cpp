// SPDX-License-Identifier: MIT-0
#include "measure/run.h"

#include <catch2/catch_test_macros.hpp>
#include <vector>

#include "made_up.h"
#include "measure/methods/euler.h"

TEST_CASE("A run shows the start and the state after each step, at times that are multiples of h") {
  std::vector<double> begun, seen, positions;
  const auto step = [&begun](double& x, double& v, double t, double h, const auto&) {
    begun.push_back(t);
    x = x + h * v;
  };
  scenes::State<double> s{5, 10};
  measure::run(step, made_up::Drifter(), s, 0.1, 3, [&](double t, const auto& now) {
    seen.push_back(t);
    positions.push_back(now.x);
  });
  CHECK(begun == std::vector<double>{0, 0.1, 2 * 0.1});
  CHECK(seen == std::vector<double>{0, 0.1, 2 * 0.1, 3 * 0.1});
  CHECK(positions == std::vector<double>{5, 6, 7, 8});
  CHECK(s.x == 8);
}

TEST_CASE("A long run does not sum its time up: its last time is right to the last bit") {
  double last = 0;
  const auto rest = [](double&, double&, double, double, const auto&) {};
  scenes::State<double> s{0, 0};
  measure::run(rest, made_up::Drifter(), s, 0.1, 1'000'000,
               [&last](double t, const auto&) { last = t; });
  CHECK(last == 100'000);
}

TEST_CASE("after() ends where run() ends and leaves the start alone") {
  const scenes::State<double> start{5, 10};
  const auto end = measure::after(measure::euler, made_up::Drifter(), start, 0.5, 4);
  CHECK(end.x == 25);
  CHECK(start.x == 5);
}
