// SPDX-License-Identifier: MIT-0
#include "measure/time_of.h"

#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <chrono>
#include <cmath>

#include "measure/evaluations.h"
#include "measure/methods.h"
#include "measure/run.h"
#include "scenes/pendulum.h"
#include "scenes/spring.h"

using Catch::Matchers::WithinRel;

namespace {

template <int Evaluations>
constexpr auto asking = [](double& x, double& v, double t, double h, const auto& acceleration) {
  double sum = 0;
  for (int n = 0; n < Evaluations; ++n) sum += acceleration(x, v + n, t);
  v = v + h * sum / Evaluations;
  x = x + h * v;
};

// A clock that stands still but for a nanosecond at each evaluation of the scene below.
struct Ticking {
  static inline long ticks = 0;

  static std::chrono::time_point<std::chrono::steady_clock> now() {
    return std::chrono::time_point<std::chrono::steady_clock>(std::chrono::nanoseconds(ticks));
  }
};

struct TickingPendulum : scenes::Pendulum<> {
  double operator()(double x, double v, double t) const {
    ++Ticking::ticks;
    return Pendulum::operator()(x, v, t);
  }
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

TEST_CASE("By a clock that ticks at each evaluation, a step takes as many ticks as it evaluates") {
  const TickingPendulum pendulum;
  for (const std::size_t bodies : {1u, 2u, 7u, 512u, 100'000u}) {
    const auto ticks = [&](auto step) {
      return 1e9 * measure::time_of<Ticking>(step, pendulum, pendulum.start(), 0.01, bodies);
    };
    CAPTURE(bodies);
    CHECK_THAT(ticks(asking<1>), WithinRel(1.0, 1e-12));
    CHECK_THAT(ticks(asking<3>), WithinRel(3.0, 1e-12));
  }
}

namespace {

/// Counts how often its force is asked for at a denormal place.
struct Watched : scenes::Spring<> {
  static inline long denormal = 0;

  double operator()(double x, double v, double t) const {
    denormal += std::fpclassify(x) == FP_SUBNORMAL;
    return Spring::operator()(x, v, t);
  }
};

/// Counts how often its force is asked for where it starts, and anywhere else.
struct Noted : scenes::Spring<> {
  static inline std::array<long, 2> asked{};

  double operator()(double x, double v, double t) const {
    ++asked[x != x0];
    return Spring::operator()(x, v, t);
  }
};

}  // namespace

TEST_CASE("No step whose time is taken meets a denormal number, on a spring that dies away") {
  const Watched suspension{{.omega = 20, .zeta = 0.1, .x0 = 0.1}};
  for (const std::size_t bodies : {1u, 5u}) {
    measure::time_of(measure::rk4, suspension, suspension.start(), 1 / 60.0, bodies);
  }
  CHECK(Watched::denormal == 0);
  auto s = suspension.start();
  s = measure::after(measure::rk4, suspension, s, 1 / 60.0, 25'000);  // all in one go it would
  CHECK(Watched::denormal > 0);
}

TEST_CASE("Each body whose time is taken moves, and none moves on where another stopped") {
  const Noted spring{{.omega = 20, .zeta = 0.1, .x0 = 0.1}};
  measure::time_of(measure::symplectic_euler, spring, spring.start(), 1 / 60.0, 100'000);
  CHECK(Noted::asked == std::array{100'000L, 100'000L});  // two steps of each
}
