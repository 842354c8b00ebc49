// SPDX-License-Identifier: MIT-0
#include "shelf/smooth_damp.h"

#include <Eigen/Core>
#include <algorithm>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <limits>

#include "frames/recorded.h"

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using Eigen::Vector2d;

namespace {

using Exact = long double;
using Matrix = Eigen::Matrix<Exact, 2, 2>;

// The exponential of a matrix, less one: by its series, after so many halvings that it converges at
// once, and doublings without a loss of what is small.
Matrix exponential_less_one(Matrix m) {
  int halvings = 0;
  for (; m.norm() > 0.25L; ++halvings) m /= 2;
  Matrix sum = Matrix::Zero(), term = Matrix::Identity();
  for (int n = 1; n < 20; ++n) sum += term = term * m / Exact(n);
  for (; halvings > 0; --halvings) sum = 2 * sum + sum * sum;
  return sum;
}

struct State {
  Exact x, v;
};

// By how much x'' = -omega^2 x - 2 omega x' changes x and v in a time.
State change(State s, Exact omega, Exact time) {
  // In units in which omega is 1, or the entries are of all sizes.
  const Matrix step = exponential_less_one(omega * time * Matrix{{0, 1}, {-1, -2}});
  const Exact v = s.v / omega;
  return {step(0, 0) * s.x + step(0, 1) * v, omega * (step(1, 0) * s.x + step(1, 1) * v)};
}

template <class Real>
constexpr double epsilon = double(std::numeric_limits<Real>::epsilon());

const auto dot_of_numbers = [](auto p, auto q) { return p * q; };
const auto dot = [](const Vector2d& p, const Vector2d& q) { return p.dot(q); };

constexpr double sizes[] = {1e-6, 1e-5, 1e-4, 1e-3, 0.01, 0.1, 0.5, 1, 3, 10, 30};

}  // namespace

TEMPLATE_TEST_CASE("A damped step solves the spring's equation, whatever omega h", "", float,
                   double) {
  for (const double size : sizes) {
    for (const double speed : {0.0, 3.0, -20.0}) {
      CAPTURE(size, speed);
      const TestType omega = 4, h = TestType(size) / omega;
      TestType x = 0, v = TestType(speed);
      shelf::smooth_damp(x, v, TestType(-1), TestType(0), omega, h);
      const State truth = change({1, Exact(speed)}, omega, h);
      // What rounds is a share of the way, of what the speed adds, and of what comes out.
      const double scale = std::min(size, 1.0) * (1 + std::abs(speed) / 4);
      CHECK_THAT(x, WithinAbs(double(truth.x), 8 * epsilon<TestType> * scale));
      const double speeds = 4 * std::min(size, 1.0) + std::abs(speed);
      CHECK_THAT(v - TestType(speed), WithinAbs(double(truth.v), 8 * epsilon<TestType> * speeds));
    }
  }
}

TEST_CASE(
    "In float a thousand damped steps from rest are right to a thousandth of what they moved") {
  for (const float size : {1e-6f, 1e-5f, 1e-4f, 1e-3f, 1e-2f}) {
    CAPTURE(size);
    const float omega = 2, h = size / omega;
    float x = 0, v = 0;
    for (int n = 0; n < 1000; ++n) shelf::smooth_damp(x, v, 1.0f, 0.0f, omega, h);
    const State truth = change({-1, 0}, omega, 1000 * Exact(h));
    CHECK_THAT(x, WithinRel(double(truth.x), 1e-3));
    CHECK_THAT(v, WithinRel(double(truth.v), 1e-3));
  }
}

TEST_CASE(
    "In float a thousand smoothed steps are right to a hundred-thousandth of what they moved") {
  for (const float size : {1e-6f, 1e-5f, 1e-4f, 1e-3f}) {
    CAPTURE(size);
    const float rate = 2, h = size / rate;
    float x = 0;
    for (int n = 0; n < 1000; ++n) shelf::smooth(x, 1.0f, 0.0f, rate, h);
    CHECK_THAT(x, WithinRel(double(1 - std::exp(-1000 * Exact(rate) * Exact(h))), 1e-5));
  }
}

TEMPLATE_TEST_CASE("The share of the way is right to its last digits, from 1e-6 of it to all of it",
                   "", float, double) {
  for (const double size : sizes) {
    CAPTURE(size);
    const TestType h = TestType(size) / 4;
    const double truth = double(1 - std::exp(-4 * Exact(h)));
    CHECK_THAT(shelf::smoothing_share(TestType(4), h),
               WithinRel(truth, std::max(2 * epsilon<TestType>, 1e-13)));
  }
  CHECK(shelf::smoothing_share(TestType(4), TestType(1e6)) == 1);
  CHECK(shelf::smoothing_share(TestType(4), TestType(0)) == 0);
}

TEST_CASE("Uneven frames end where even ones do, behind a target that moves") {
  frames::Playback frame;
  double t = 0, damped = -2, v = 7, smoothed = -2;
  for (int n = 0; n < 600; ++n) {
    const double h = frame.next();
    t += h;
    shelf::smooth_damp(damped, v, 3 + 5 * t, 5.0, 4.0, h);
    shelf::smooth(smoothed, 3 + 5 * t, 5.0, 4.0, h);
    const State changed = change({-5, 2}, 4, t);
    CAPTURE(t);
    REQUIRE_THAT(damped, WithinAbs(double(changed.x) - 2 + 5 * t, 1e-12));
    REQUIRE_THAT(v, WithinAbs(double(changed.v) + 7, 1e-12));
    REQUIRE_THAT(smoothed, WithinAbs(-5 * std::exp(-4 * t) + 3 + 5 * t, 1e-12));
  }
}

TEMPLATE_TEST_CASE("What is on its target at rest stays there to the bit", "", float, double) {
  const TestType target = TestType(1) / 3;
  TestType x = target, v = 0, smoothed = target;
  for (int n = 0; n < 1000; ++n) {
    const TestType h = TestType(1) / TestType(n % 100 + 10);
    shelf::smooth_damp(x, v, target, TestType(0), TestType(3), h);
    shelf::smooth_damp_no_overshoot(x, v, target, TestType(0), TestType(3), h, dot_of_numbers);
    shelf::smooth(smoothed, target, TestType(0), TestType(3), h);
  }
  CHECK(x == target);
  CHECK(v == 0);
  CHECK(smoothed == target);
}

TEMPLATE_TEST_CASE("Of no length a step does nothing, and with no spring it goes straight on", "",
                   float, double) {
  TestType x = 1, v = 2;
  shelf::smooth_damp(x, v, TestType(7), TestType(3), TestType(5), TestType(0));
  shelf::smooth_damp_no_overshoot(x, v, TestType(7), TestType(3), TestType(5), TestType(0),
                                  dot_of_numbers);
  shelf::smooth(x, TestType(7), TestType(3), TestType(5), TestType(0));
  CHECK(x == 1);
  CHECK(v == 2);
  shelf::smooth_damp(x, v, TestType(7), TestType(0), TestType(0), TestType(0.5));
  CHECK(x == 2);
  CHECK(v == 2);
  shelf::smooth(x, TestType(7), TestType(0), TestType(0), TestType(0.5));
  CHECK(x == 2);
}

TEST_CASE("What is not a number stays none, and stops nothing") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  double x = 1, v = 2, y = 1, w = 2, z = 1;
  shelf::smooth_damp(x, v, 3.0, 0.0, 4.0, nan);
  shelf::smooth_damp_no_overshoot(y, w, nan, 0.0, 4.0, 0.1, dot_of_numbers);
  shelf::smooth(z, nan, 0.0, 4.0, 0.1);
  for (const double lost : {x, v, y, w, z}) CHECK(std::isnan(lost));
}

TEMPLATE_TEST_CASE("What comes in too fast is slowed to omega times the way, once and for all", "",
                   float, double) {
  // At that speed the spring's way shrinks by exp(-omega t).
  for (const int rate : {15, 60, 240}) {
    for (const double times : {1.0, 1.5, 20.0}) {
      CAPTURE(rate, times);
      TestType x = -2, v = TestType(2 * 8 * times);
      const TestType h = TestType(1) / TestType(rate);
      for (int n = 1; n <= rate; ++n) {
        shelf::smooth_damp_no_overshoot(x, v, TestType(0), TestType(0), TestType(8), h,
                                        dot_of_numbers);
        const double truth = -2 * std::exp(-8 * double(n) * double(h));
        REQUIRE(x <= 0);
        REQUIRE_THAT(x, WithinAbs(truth, 300 * epsilon<TestType>));
      }
    }
  }
}

TEST_CASE("What is slow enough is not braked at all") {
  for (const double speed : {-30.0, -1.0, 0.0, 7.9}) {
    double x = -1, v = speed, y = -1, w = speed;
    for (int n = 0; n < 100; ++n) {
      shelf::smooth_damp(x, v, 0.0, 0.0, 8.0, 0.02);
      shelf::smooth_damp_no_overshoot(y, w, 0.0, 0.0, 8.0, 0.02, dot_of_numbers);
    }
    CHECK(x == y);
    CHECK(v == w);
  }
}

TEST_CASE("In the plane only the speed towards the target is braked, and none of that across") {
  const Vector2d target(3, -1), wind(0.5, 2);
  for (const double h : {1e-6, 1 / 60.0, 1 / 15.0}) {
    Vector2d x = target - h * wind + Vector2d(-2, 0);  // at the start of the step two away
    Vector2d v = wind + Vector2d(100, 5), y = x, w = wind + Vector2d(2 * 8, 5);
    shelf::smooth_damp_no_overshoot(x, v, target, wind, 8.0, h, dot);
    shelf::smooth_damp(y, w, target, wind, 8.0, h);
    CHECK((x - y).norm() < 1e-14);
    CHECK((v - w).norm() < 1e-13);
  }
}

TEST_CASE("In the plane nothing crosses the line through its target, in steps of any length") {
  frames::Playback frame;
  const Vector2d way(-2, 1);
  Vector2d x = way, v(60, -70);
  for (int n = 0; n < 300; ++n) {
    shelf::smooth_damp_no_overshoot(x, v, Vector2d(0, 0), Vector2d(0, 0), 4.0, frame.next(), dot);
    REQUIRE(x.dot(way) > 0);
  }
  CHECK(x.norm() < 1e-3);
}

TEST_CASE("To trail, a target may be given as the sum that it is") {
  const Vector2d wind(3, -4);
  Vector2d x(0, 0), v(0, 0), smoothed = x;
  for (int n = 1; n <= 600; ++n) {
    const double t = n / 60.0;
    shelf::smooth_damp(x, v, t * wind + (-2 / 8.0) * wind, wind, 8.0, 1 / 60.0);
    shelf::smooth(smoothed, t * wind + (-1 / 8.0) * wind, wind, 8.0, 1 / 60.0);
  }
  CHECK((x - (10 - 0.25) * wind).norm() < 1e-12);
  CHECK((v - wind).norm() < 1e-12);
  CHECK((smoothed - (10 - 0.125) * wind).norm() < 1e-12);
}

// On a circle at omega_0 the spring's answer to the acceleration a is a/(omega^2 + omega_0^2).
TEST_CASE("Behind a target that circles it stays as far back as its acceleration asks for") {
  const auto behind = [](int rate) {
    Vector2d x(5, 0), v(0, 5), place;
    for (int n = 1; n <= 20 * rate; ++n) {
      const double t = double(n) / rate;
      place = 5 * Vector2d(std::cos(t), std::sin(t));
      const Vector2d along = 5 * Vector2d(-std::sin(t), std::cos(t));
      shelf::smooth_damp(x, v, place, along, 4.0, 1.0 / rate);
    }
    return (x - place).norm();
  };
  const double right = 5 / (4.0 * 4.0 + 1);
  CHECK_THAT(behind(1000), WithinRel(right, 0.005));
  CHECK_THAT(behind(240), WithinRel(right, 0.02));
  CHECK(behind(15) < 0.8 * right);
}

TEST_CASE("The same steps give the same bits") {
  const auto run = [] {
    double x = 0.1, v = 3;
    for (int n = 0; n < 1000; ++n) {
      shelf::smooth_damp_no_overshoot(x, v, 1.0 + n, 1.5, 3.0, 1 / 60.0, dot_of_numbers);
      shelf::smooth(x, 1.0, 0.5, 3.0, 1 / 60.0);
    }
    return x + v;
  };
  CHECK(run() == run());
}
