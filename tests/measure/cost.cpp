// SPDX-License-Identifier: MIT-0
#include "measure/cost.h"

#include <catch2/catch_test_macros.hpp>

#include "measure/run.h"
#include "scenes/pendulum.h"

namespace {

template <int Evaluations>
constexpr auto asking = [](double& x, double& v, double t, double h, const auto& acceleration) {
  double sum = 0;
  for (int n = 0; n < Evaluations; ++n) sum += acceleration(x, v + n, t);
  v = v + h * sum / Evaluations;
  x = x + h * v;
};

}  // namespace

TEST_CASE("Evaluations are counted, in any method") {
  const scenes::Pendulum<> pendulum;
  CHECK(measure::evaluations_per_step(measure::euler, pendulum, 0.1) == 1);
  CHECK(measure::evaluations_per_step(asking<4>, pendulum, 0.1) == 4);
  CHECK(measure::evaluations_per_step(asking<0>, pendulum, 0.1) == 0);
}

TEST_CASE("Counting does not change the answer") {
  const scenes::Pendulum<> pendulum;
  const measure::Counted<scenes::Pendulum<>> counted{pendulum};
  CHECK(counted(0.5, 1.0, 2.0) == pendulum(0.5, 1.0, 2.0));
  CHECK(counted.evaluations == 1);
}

TEST_CASE("A step takes time, and a step of thirty evaluations takes more than one of one") {
  const scenes::Pendulum<> pendulum;
  const double once = measure::seconds_per_step(asking<1>, pendulum, 0.01);
  CHECK(once > 1e-10);
  CHECK(once < 1e-3);
  CHECK(measure::seconds_per_step(asking<30>, pendulum, 0.01) > 3 * once);
}
