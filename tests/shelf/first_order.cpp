// SPDX-License-Identifier: MIT-0
#include "shelf/first_order.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <vector>

#include "integrate/rk4.h"

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using Eigen::Vector2d;

namespace {

// Each with its order and its table, as textbooks print it: what is asked at which share of the
// step, from which slopes, and with which weight.
struct Row {
  long double at;
  std::vector<long double> of;
  long double weight;
};

struct Euler {
  static constexpr int order = 1;
  constexpr void operator()(auto& x, auto t, auto h, const auto& u) const {
    shelf::first_order_euler(x, t, h, u);
  }
  static std::vector<Row> table() { return {{0, {}, 1}}; }
};
struct Midpoint {
  static constexpr int order = 2;
  constexpr void operator()(auto& x, auto t, auto h, const auto& u) const {
    shelf::first_order_midpoint(x, t, h, u);
  }
  static std::vector<Row> table() { return {{0, {}, 0}, {0.5L, {0.5L}, 1}}; }
};
struct Rk4 {
  static constexpr int order = 4;
  constexpr void operator()(auto& x, auto t, auto h, const auto& u) const {
    shelf::first_order_rk4(x, t, h, u);
  }
  static std::vector<Row> table() {
    return {{0, {}, 1 / 6.0L},
            {0.5L, {0.5L}, 1 / 3.0L},
            {0.5L, {0, 0.5L}, 1 / 3.0L},
            {1, {0, 0, 1}, 1 / 6.0L}};
  }
};
using All = std::tuple<Euler, Midpoint, Rk4>;

template <class Velocity>
long double by_table(const std::vector<Row>& table, long double x, long double t, long double h,
                     const Velocity& u) {
  std::vector<long double> slopes;
  long double end = x;
  for (const Row& row : table) {
    long double stage = x;
    for (std::size_t i = 0; i < row.of.size(); ++i) stage += h * row.of[i] * slopes[i];
    slopes.push_back(u(stage, t + row.at * h));
    end += h * row.weight * slopes.back();
  }
  return end;
}

const auto bent = [](auto x, auto t) { return decltype(x)(x * x - 2 * x + x / (1 + t * t)); };

// Flows with a known end. Of each the error at eight places on the way.
template <class Step, class Vec, class Velocity, class Exact>
double largest_error(Step step, Vec x, int steps, const Velocity& u, const Exact& exact) {
  const double h = 2.0 / steps;
  double largest = 0;
  for (int n = 0; n < steps; ++n) {
    step(x, n * h, h, u);
    if ((n + 1) % (steps / 8) != 0) continue;
    const Vec off = x - exact((n + 1) * h);
    if constexpr (std::is_same_v<Vec, double>)
      largest = std::max(largest, std::abs(off));
    else
      largest = std::max(largest, off.norm());
  }
  return largest;
}

template <class Step, class Vec, class Velocity, class Exact>
void check_order(Step step, const Vec& start, const Velocity& u, const Exact& exact) {
  for (const int steps : {160, 320}) {
    const double coarse = largest_error(step, start, steps, u, exact);
    const double fine = largest_error(step, start, 2 * steps, u, exact);
    CAPTURE(steps, coarse, fine);
    CHECK_THAT(std::log2(coarse / fine), WithinAbs(Step::order, 0.1));
  }
}

struct Pair {
  double x, v;
};
constexpr Pair operator+(Pair p, Pair q) {
  return {p.x + q.x, p.v + q.v};
}
constexpr Pair operator*(double s, Pair p) {
  return {s * p.x, s * p.v};
}

constexpr Pair pushed(const Pair& now, double t) {
  return {now.v, -4 * now.x - now.v + t};
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("Coarse steps for one unknown are those of the table", "", All) {
  for (const double h : {0.3, -0.2}) {
    double x = 0.7;
    float single = 0.7f;
    long double truth = x, truth_of_single = single;
    for (int n = 0; n < 8; ++n) {
      CAPTURE(h, n);
      truth = by_table(TestType::table(), truth, n * h, h, bent);
      TestType()(x, n * h, h, bent);
      CHECK_THAT(x, WithinRel(double(truth), 1e-14));
      truth_of_single = by_table(TestType::table(), truth_of_single, n * h, float(h), bent);
      TestType()(single, n * h, float(h), bent);
      CHECK_THAT(single, WithinRel(double(truth_of_single), 1e-5));
    }
  }
}

TEMPLATE_LIST_TEST_CASE("In flows whose end is known, each has its order", "", All) {
  SECTION("growth in gusts, by the square of what is there") {
    check_order(
        TestType(), 0.5, [](double x, double t) { return x * x * std::cos(t); },
        [](double t) { return 0.5 / (1 - 0.5 * std::sin(t)); });
  }
  SECTION("a saddle that freshens") {
    check_order(
        TestType(), Vector2d(0.3, 2),
        [](const Vector2d& x, double t) { return Vector2d((1 + t) * x.x(), -(1 + t) * x.y()); },
        [](double t) {
          return Vector2d(0.3 * std::exp(t + t * t / 2), 2 * std::exp(-t - t * t / 2));
        });
  }
  SECTION("a river that turns with the hour") {
    check_order(
        TestType(), Vector2d(1, 0),
        [](const Vector2d& x, double t) { return Vector2d(-2 * t * x.y(), 2 * t * x.x()); },
        [](double t) { return Vector2d(std::cos(t * t), std::sin(t * t)); });
  }
}

TEST_CASE("A flow is asked at the start, twice in the middle and at the end, as the method needs") {
  std::vector<double> times;
  const auto noting = [&times](double x, double t) { return times.push_back(t), x; };
  double x = 1;
  shelf::first_order_euler(x, 4.0, 0.5, noting);
  CHECK(times == std::vector<double>{4});
  times.clear();
  shelf::first_order_midpoint(x, 4.0, 0.5, noting);
  CHECK(times == std::vector<double>{4, 4.25});
  times.clear();
  shelf::first_order_rk4(x, 4.0, 0.5, noting);
  CHECK(times == std::vector<double>{4, 4.25, 4.25, 4.5});
}

TEMPLATE_LIST_TEST_CASE("Of small steps in float, a thousand move by what they should", "", All) {
  for (const float size : {1e-6f, 1e-5f, 1e-4f, 1e-3f, 1e-2f, 0.1f, 1.0f}) {
    CAPTURE(size);
    float x = 0;
    long double truth = 0;
    const auto towards_one = [](auto now, auto) { return decltype(now)(2 * (1 - now)); };
    for (int n = 0; n < 1000; ++n) {
      TestType()(x, 0.0, size / 2, towards_one);
      truth = by_table(TestType::table(), truth, 0, size / 2, towards_one);
    }
    CHECK_THAT(x, WithinRel(double(truth), 1e-4));
  }
}

TEST_CASE("After a day a flow in float still knows the time, from a clock of doubles") {
  const double day = 86'400, h = 1 / 240.0;
  float x = 0;
  for (int n = 0; n < 240; ++n) {
    shelf::first_order_rk4(x, day + n * h, float(h),
                           [](float, double t) { return float(std::cos(t)); });
  }
  CHECK_THAT(x, WithinAbs(std::sin(day + 1) - std::sin(day), 1e-6));
}

TEST_CASE("On position and velocity together it is the RK4 for accelerations") {
  Pair both{1, 0};
  double x = 1, v = 0;
  for (int n = 0; n < 100; ++n) {
    shelf::first_order_rk4(both, n * 0.1, 0.1, pushed);
    integrate::rk4(x, v, n * 0.1, 0.1,
                   [](double place, double speed, double t) { return -4 * place - speed + t; });
  }
  CHECK_THAT(both.x, WithinRel(x, 1e-13));
  CHECK_THAT(both.v, WithinRel(v, 1e-13));
}

TEST_CASE("Towards a wind that drags, each is bounded below its limit and not above") {
  const auto end = [](auto step, double ch) {
    double x = 1;
    for (int n = 0; n < 1000; ++n) {
      step(x, 0.0, ch, [](double now, double) { return -now; });
    }
    return std::abs(x);
  };
  CHECK(end(Euler(), 1.99) < 1);
  CHECK(end(Euler(), 2.01) > 1);
  CHECK(end(Midpoint(), 1.99) < 1);
  CHECK(end(Midpoint(), 2.01) > 1);
  CHECK(end(Rk4(), 2.78) < 1);
  CHECK(end(Rk4(), 2.79) > 1);
}

TEST_CASE("In a still wind nothing moves, and in an even one all go straight, to the bit") {
  for (const double blows : {0.0, 0.75}) {
    double euler = 1, midpoint = 1, rk4 = 1;
    const auto wind = [blows](double, double) { return blows; };
    for (int n = 0; n < 64; ++n) {
      shelf::first_order_euler(euler, 0.0, 0.125, wind);
      shelf::first_order_midpoint(midpoint, 0.0, 0.125, wind);
      shelf::first_order_rk4(rk4, 0.0, 0.125, wind);
    }
    CHECK(euler == 1 + 8 * blows);
    CHECK(midpoint == euler);
    CHECK_THAT(rk4, WithinRel(euler, 1e-14));
  }
}

TEST_CASE("A wind that is not a number carries to nowhere, and asks no more often") {
  int asked = 0;
  double x = 1;
  shelf::first_order_rk4(x, 0.0, 0.1, [&asked](double, double) {
    ++asked;
    return std::numeric_limits<double>::quiet_NaN();
  });
  CHECK(std::isnan(x));
  CHECK(asked == 4);
}

TEST_CASE("A compiler can take the steps") {
  constexpr auto moved = [](auto step) {
    Pair now{1, 0};
    for (int n = 0; n < 60; ++n) step(now, n / 64.0, 1 / 64.0, pushed);
    return now;
  };
  constexpr Pair euler = moved(Euler()), midpoint = moved(Midpoint()), rk4 = moved(Rk4());
  CHECK(rk4.x == moved(Rk4()).x);
  CHECK(midpoint.x == moved(Midpoint()).x);
  CHECK(euler.x == moved(Euler()).x);
}
