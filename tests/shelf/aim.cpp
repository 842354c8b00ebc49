// SPDX-License-Identifier: MIT-0
#include "shelf/aim.h"

#include <Eigen/Core>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <utility>

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

template <class Real>
using Vector = Eigen::Matrix<Real, 3, 1>;
using Vec = Vector<double>;

const auto dot = [](const auto& a, const auto& b) { return a.dot(b); };

// A tick of a shell that linear drag slows down, c being up to 3 1/s.
template <class Real>
struct Shell {
  Real c, h;

  void operator()(Vector<Real>& x, Vector<Real>& v) const {
    v = (v + h * Vector<Real>(0, 0, Real(-9.81))) / (1 + c * h);
    x = x + h * v;
  }
};

template <class Real>
Vector<Real> flown(const Shell<Real>& shell, Vector<Real> x, Vector<Real> v, Real time) {
  const Real ticks = time / shell.h;
  Vector<Real> before = x;
  for (int n = 0; n <= int(ticks); ++n) before = x, shell(x, v);
  return before + (ticks - std::floor(ticks)) * (x - before);
}

}  // namespace

TEMPLATE_TEST_CASE("A shell hits what stands and what moves, in ticks of any length", "", float,
                   double) {
  using V = Vector<TestType>;
  const V from(1, 2, 3);
  for (const int rate : {15, 60, 240}) {
    for (const double c : {0.0, 0.3, 3.0}) {
      for (const V& moves : {V(0, 0, 0), V(-3, 4, 1)}) {
        CAPTURE(rate, c, moves);
        const Shell<TestType> shell{TestType(c), 1 / TestType(rate)};
        const auto target = [&](TestType t) -> V { return V(7, -3, 0) + t * moves; };
        const shelf::Gun<TestType> gun{30, shell.h, 20, TestType(0.005)};
        const auto found = shelf::aim(from, target, shell, dot, gun);
        REQUIRE(found.found);
        CHECK_THAT(double(found.velocity.norm()), WithinRel(30.0, 1e-6));
        const V there = flown<TestType>(shell, from, found.velocity, found.time);
        CHECK((there - target(found.time)).norm() < TestType(0.00501));
      }
    }
  }
}

TEST_CASE("The first throw is the flat one, the next the high one, and a third there is none") {
  const Shell<double> shell{0.1, 1 / 60.0};
  const auto target = [](double) -> Vec { return {30, 0, 0}; };
  const shelf::Gun<double> gun{25, 1 / 60.0, 30, 1e-3};
  const auto flat = shelf::aim(Vec(0, 0, 0), target, shell, dot, gun);
  const auto high = shelf::aim(Vec(0, 0, 0), target, shell, dot, gun, flat.time + gun.h);
  REQUIRE((flat.found && high.found));
  CHECK(flat.velocity.z() < flat.velocity.x());
  CHECK(high.velocity.z() > high.velocity.x());
  CHECK(high.time > flat.time);
  CHECK_FALSE(shelf::aim(Vec(0, 0, 0), target, shell, dot, gun, high.time + gun.h).found);
}

TEMPLATE_TEST_CASE("What is nearer than a tick's flight is hit straight", "", float, double) {
  using V = Vector<TestType>;
  const V from(1, 2, 3);
  for (const auto& [speed, distance] :
       {std::pair{60, 0.5}, {60, 0.01}, {300, 4.9}, {900, 14.0}, {900, 0.2}}) {
    for (const V& way : {V(1, 0, 0), V(0, -0.6f, 0.8f)}) {
      CAPTURE(speed, distance, way);
      const Shell<TestType> shell{0, 1 / TestType(60)};
      const auto target = [&](TestType) -> V { return from + TestType(distance) * way; };
      const shelf::Gun<TestType> gun{TestType(speed), shell.h, 20, TestType(0.005)};
      const auto found = shelf::aim(from, target, shell, dot, gun);
      REQUIRE(found.found);
      CHECK((found.velocity - TestType(speed) * way).norm() < TestType(0.01 * speed + 0.5));
      CHECK_THAT(double(found.time), WithinAbs(distance / speed, 0.01 / speed));
    }
  }
}

// In a vacuum 25 m/s carry a little further than 63.7 m.
TEST_CASE("Just within reach there is a throw, and just out of it none") {
  const auto fall = [](Vec& x, Vec& v) {
    x = x + 0.01 * v - 0.01 * 0.01 / 2 * Vec(0, 0, 9.81);
    v = v - 0.01 * Vec(0, 0, 9.81);
  };
  const double range = 25 * 25 / 9.81;
  const shelf::Gun<double> gun{25, 0.01, 30, 1e-3};
  for (const double off : {-0.02, 0.02}) {
    const auto target = [&](double) -> Vec { return {range + off, 0, 0}; };
    CHECK(shelf::aim(Vec(0, 0, 0), target, fall, dot, gun).found == (off < 0));
  }
}

TEST_CASE("What runs away faster than the shell is not hit, and in too short a time nothing is") {
  const Shell<double> shell{0, 1 / 60.0};
  const auto away = [](double t) -> Vec { return {10 + 40 * t, 0, 0}; };
  CHECK_FALSE(
      shelf::aim(Vec(0, 0, 0), away, shell, dot, shelf::Gun<double>{30, 1 / 60.0, 20, 1e-3}).found);
  const auto far = [](double) -> Vec { return {60, 0, 0}; };
  CHECK_FALSE(
      shelf::aim(Vec(0, 0, 0), far, shell, dot, shelf::Gun<double>{30, 1 / 60.0, 1, 1e-3}).found);
}

TEST_CASE("A throw lands where it crosses the ground between two ticks") {
  const Shell<double> shell{0.5, 1 / 15.0};
  const auto height = [](const Vec& x) { return x.z(); };
  const auto found = shelf::landing(Vec(0, 0, 2), Vec(9, 1, 8), 1 / 15.0, 20.0, shell, height);
  REQUIRE(found.found);
  CHECK_THAT(found.place.z(), WithinAbs(0, 1e-14));
  const Vec there = flown<double>(shell, Vec(0, 0, 2), Vec(9, 1, 8), found.time);
  CHECK((there - found.place).norm() < 1e-12);
}

TEST_CASE("What never comes down is where it is when the time is over") {
  const auto floats = [](Vec& x, Vec& v) { x = x + 0.25 * v; };
  const auto height = [](const Vec& x) { return x.z(); };
  const auto found = shelf::landing(Vec(0, 0, 2), Vec(1, 0, 1), 0.25, 4.0, floats, height);
  CHECK_FALSE(found.found);
  CHECK(found.place == Vec(4, 0, 6));
  // From below it has to come up first.
  const Shell<double> shell{0, 0.25};
  const auto through = shelf::landing(Vec(0, 0, -30), Vec(1, 0, 40), 0.25, 20.0, shell, height);
  CHECK(through.found);
  CHECK(through.time > 3);
}

TEST_CASE("A gun that makes no sense finds nothing") {
  const Shell<double> shell{0, 1 / 60.0};
  const auto target = [](double) -> Vec { return {10, 0, 0}; };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const shelf::Gun<double>& gun : {shelf::Gun<double>{0, 1 / 60.0, 20, 1e-3},
                                        {30, 0, 20, 1e-3},
                                        {30, nan, 20, 1e-3},
                                        {nan, 1 / 60.0, 20, 1e-3},
                                        {30, 1 / 60.0, nan, 1e-3},
                                        {30, 1 / 60.0, 20, nan}}) {
    CHECK_FALSE(shelf::aim(Vec(0, 0, 0), target, shell, dot, gun).found);
  }
  const auto nowhere = [&](double) -> Vec { return {nan, 0, 0}; };
  CHECK_FALSE(
      shelf::aim(Vec(0, 0, 0), nowhere, shell, dot, shelf::Gun<double>{30, 1 / 60.0, 20, 1e-3})
          .found);
  const auto height = [](const Vec& x) { return x.z(); };
  CHECK_FALSE(shelf::landing(Vec(0, 0, 2), Vec(1, 0, 1), nan, 20.0, shell, height).found);
}
