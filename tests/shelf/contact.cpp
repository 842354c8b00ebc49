// SPDX-License-Identifier: MIT-0
#include "shelf/contact.h"

#include <algorithm>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <random>

#include "measure/crate.h"

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using measure::Crate;

namespace {

constexpr double g = 9.81;
using Vec = shelf::Vec3<double>;
using Flat = std::complex<double>;

constexpr auto dot_of = [](const Vec& p, const Vec& r) { return dot(p, r); };
constexpr auto cross_of = [](const Vec& p, const Vec& r) { return cross(p, r); };

template <class Real>
Real load(const Crate<Real>& crate, Real h) {
  Real sum = 0;
  for (int i = 0; i < crate.corners; ++i) sum += crate.contacts[i].push / h;
  return sum;
}

// A crate in a plane, with its place, its velocity and its angle.
struct FlatCrate {
  Flat x{0, 1}, v{1, 0};
  double angle = 0.5, L = 3;
  shelf::Contact<Flat, double> contacts[4];

  void step(double h, const shelf::Surface<double>& surface) {
    const auto spin = [](double now) { return now / (Crate<double>::mass / 12); };
    for (int i = 0; i < 4; ++i) {
      contacts[i].r = std::polar(1.0, angle) * Flat(i & 1 ? 0.4 : -0.4, i & 2 ? 0.3 : -0.3);
      contacts[i].normal = Flat(0, 1);
      contacts[i].gap = (x + contacts[i].r).imag();
    }
    const auto way =
        shelf::contact_step(v, L, Flat(0, -g), h, contacts, 4, surface, 1 / Crate<double>::mass,
                            spin, measure::FlatProducts::dot, measure::FlatProducts());
    x = x + h * way.v;
    angle = angle + h * spin(way.L);
  }
};

}  // namespace

TEMPLATE_TEST_CASE("A crate that falls onto a corner comes to rest on its four and stays", "",
                   float, double) {
  const TestType rounding = std::numeric_limits<TestType>::epsilon();
  for (const int rate : {30, 60, 144}) {
    for (const double restitution : {0.0, 0.3}) {
      CAPTURE(rate, restitution);
      const TestType h = TestType(1) / TestType(rate);
      const shelf::Surface<TestType> floor{TestType(0.5), TestType(restitution), TestType(0.5)};
      Crate<TestType> crate;
      shelf::turn_exact(crate.q, {0.3f, 1, -0.2f}, 1);
      crate.spin_with({1, -1, 1});
      crate.lift_to(TestType(0.5));
      for (int n = 0; n < 3 * rate; ++n) crate.step(h, floor);
      const auto place = crate.x;
      for (int n = 0; n < 10 * rate; ++n) crate.step(h, floor);
      CHECK(crate.speed() < 40 * rounding);
      CHECK(std::abs(crate.lowest()) < 4 * rounding);
      CHECK(std::abs(crate.x.x - place.x) + std::abs(crate.x.z - place.z) < 100 * rounding);
      CHECK_THAT(double(load(crate, h)), WithinRel(20 * g, 1e-5));
    }
  }
}

TEST_CASE("What touches nothing flies as it would without a floor") {
  Crate<double> crate;
  crate.x = {0, 50, 0}, crate.v = {2, 3, 0};
  crate.spin_with({1, 2, 3});
  const Vec L = crate.L;
  for (int n = 0; n < 30; ++n) crate.step(1 / 30.0, {0.5, 0.3, 0.5});
  CHECK_THAT(crate.x.x, WithinAbs(2, 1e-12));
  CHECK_THAT(crate.x.y, WithinAbs(53 - g / 2, 1e-12));
  CHECK_THAT(crate.v.y, WithinAbs(3 - g, 1e-12));
  CHECK((crate.L.x == L.x && crate.L.y == L.y && crate.L.z == L.z));
}

TEST_CASE("A box that lands flat goes to the floor, and comes back with its share of the speed") {
  Crate<double> crate;
  crate.x = {0, 0.32, 0}, crate.v = {0, -3, 0};
  crate.step(1 / 60.0, {0.5, 0.4, 0.5});
  CHECK_THAT(crate.lowest(), WithinAbs(0, 1e-12));
  CHECK_THAT(crate.v.y, WithinAbs(0.4 * 3, 1e-12));
  CHECK(crate.speed() - std::abs(crate.v.y) < 1e-12);
  for (int i = 0; i < 4; ++i)
    CHECK_THAT(crate.contacts[i].push, WithinRel(crate.contacts[0].push, 1e-12));
  for (int i = 4; i < 8; ++i) CHECK(crate.contacts[i].push == 0);
}

TEST_CASE("Slower than the threshold nothing comes back") {
  for (const double speed : {0.49, 0.51}) {
    Crate<double> crate;
    crate.x = {0, 0.301, 0}, crate.v = {0, -speed, 0};
    crate.step(1 / 60.0, {0.5, 0.4, 0.5});
    CHECK_THAT(crate.v.y, WithinAbs(speed < 0.5 ? 0 : 0.4 * speed, 1e-12));
  }
}

TEST_CASE("What begins within the floor is put onto it, and gets no speed by that") {
  Crate<double> crate;
  crate.x = {0, 0.2, 0};
  crate.step(1 / 60.0, {0.5, 0.3, 0.5});
  CHECK(std::abs(crate.lowest()) < 1e-12);
  CHECK(crate.speed() < 1e-12);
}

TEST_CASE("In a plane a box moves as a thin one does in the room") {
  FlatCrate flat;
  Crate<double> thin;
  thin.size.z = 0;
  thin.corners = 2;  // the two below, of the front
  shelf::turn_exact(thin.q, {0, 0, 0.5}, 1);
  thin.x = {0, 1, 0}, thin.v = {1, 0, 0}, thin.L = {0, 0, 3};
  for (int n = 0; n < 30; ++n) {
    flat.step(1 / 60.0, {0.5, 0.3, 0.5});
    thin.step(1 / 60.0, {0.5, 0.3, 0.5});
    CHECK_THAT(thin.x.x, WithinAbs(flat.x.real(), 1e-9));
    CHECK_THAT(thin.x.y, WithinAbs(flat.x.imag(), 1e-9));
    CHECK_THAT(thin.L.z, WithinAbs(flat.L, 1e-9));
  }
  for (int n = 0; n < 90; ++n) flat.step(1 / 60.0, {0.5, 0.3, 0.5});
  CHECK_THAT(flat.x.imag(), WithinAbs(0.4, 1e-12));  // on its side
  CHECK_THAT(flat.angle, WithinAbs(std::acos(0.0), 1e-12));
}

TEST_CASE("Where it slides it is braked against its way by mu g, and then it stands") {
  for (const double mu : {0.1, 0.4}) {
    for (const int rate : {30, 60, 240}) {
      CAPTURE(mu, rate);
      Crate<double> crate;
      crate.lift_to(0);
      crate.v = {1.8, 0, -2.4};
      for (int n = 0; n < rate / 2; ++n) crate.step(1.0 / rate, {mu, 0, 0.5});
      const double left = 3 - mu * g / 2;
      CHECK_THAT(crate.v.x, WithinAbs(0.6 * left, 1e-4));
      CHECK_THAT(crate.v.z, WithinAbs(-0.8 * left, 1e-4));
      for (int n = 0; n < 4 * rate; ++n) crate.step(1.0 / rate, {mu, 0, 0.5});
      CHECK(crate.speed() < 1e-12);
      const double way = 9 / (2 * mu * g);
      CHECK_THAT(crate.x.x, WithinAbs(0.6 * way, mu * g / rate / rate));
      CHECK_THAT(crate.x.z, WithinAbs(-0.8 * way, mu * g / rate / rate));
    }
  }
}

TEST_CASE("A plate that slides and spins weighs alike on its four corners") {
  Crate<double> plate;
  plate.size = {2, 1e-6, 2};
  plate.corners = 4;
  plate.lift_to(0);
  plate.v = {1, 0, 0};
  plate.spin_with({0, 3, 0});
  for (int n = 0; n < 30; ++n) {
    plate.step(1 / 60.0, {0.3, 0, 0.5});
    for (int i = 0; i < 4; ++i)
      REQUIRE_THAT(plate.contacts[i].push, WithinRel(20 * g / 60 / 4, 1e-3));
  }
}

TEST_CASE("A car at rest on four wheels doesn't shake, on a road that leans across and down") {
  // A metre and a half high, which leans over its lower wheels and would slide from a friction of
  // 0.32 on.
  const double h = 1 / 60.0;
  Crate<double> car;
  car.size = {1.8, 1.2, 4};
  car.corners = 4;
  car.up = (1 / std::sqrt(1.1)) * Vec{0.3, 1, 0.1};
  shelf::turn_exact(car.q, {0.1, 0, 0}, 1);
  shelf::turn_exact(car.q, {0, 0, -0.29}, 1);
  car.lift_to(0);
  for (int n = 0; n < 120; ++n) car.step(h, {0.8, 0, 0.5});
  const Vec place = car.x;
  for (int n = 0; n < 3600; ++n) {
    car.step(h, {0.8, 0, 0.5});
    REQUIRE(car.speed() < 1e-12);
  }
  const Vec way = car.x + -1.0 * place;
  CHECK(std::sqrt(dot(way, way)) < 1e-10);
  CHECK_THAT(load(car, h), WithinRel(20 * g / std::sqrt(1.1), 1e-9));
  for (int i = 0; i < 4; ++i) CHECK(car.contacts[i].push > 0);
}

TEST_CASE("At rest it stays at rest when the steps are uneven") {
  Crate<double> crate;
  crate.up = {std::sin(0.3), std::cos(0.3), 0};
  shelf::turn_exact(crate.q, {0, 0, -0.3}, 1);
  crate.lift_to(0);
  for (int n = 0; n < 120; ++n) crate.step(1 / 60.0, {0.5, 0, 0.5});
  std::mt19937 random(3);
  for (int n = 0; n < 600; ++n) {
    crate.step(std::uniform_real_distribution<double>(0.002, 0.1)(random), {0.5, 0, 0.5});
    REQUIRE(crate.speed() < 1e-12);
  }
}

TEST_CASE("Into a corner of the room it slides, and stops at the wall") {
  const double h = 1 / 60.0;
  Crate<double> crate;  // moved by hand: it meets a floor and a wall
  crate.x = {-1, 0.3, 0}, crate.v = {4, 0, 0};
  shelf::Contact<Vec, double> contacts[16];
  const auto spin = [&](const Vec& L) { return angular_velocity(crate.q, L, crate.inertia()); };
  for (int n = 0; n < 120; ++n) {
    crate.find_corners();
    for (int i = 0; i < 16; ++i) {
      contacts[i].r = crate.contacts[i % 8].r;
      contacts[i].normal = i < 8 ? Vec{0, 1, 0} : Vec{-1, 0, 0};
      const Vec corner = crate.x + contacts[i].r;
      contacts[i].gap = i < 8 ? corner.y : 0.4 - corner.x;
    }
    const auto way =
        shelf::contact_step(crate.v, crate.L, Vec{0, -g, 0}, h, contacts, 16,
                            shelf::Surface<double>{0.2, 0, 0.5}, 1 / 20.0, spin, dot_of, cross_of);
    crate.x = crate.x + h * way.v;
    spin_by_rotations(crate.q, way.L, crate.inertia(), h);
    for (const auto& contact : contacts) REQUIRE(contact.gap > -2e-3);
  }
  CHECK_THAT(crate.x.x, WithinAbs(0, 2e-2));
  CHECK_THAT(crate.x.y, WithinAbs(0.3, 1e-6));
  CHECK(crate.speed() < 1e-9);
}

TEST_CASE("Bounces of several corners with friction don't add to the energy") {
  std::mt19937 random(9);
  const auto number = [&](double most) {
    return std::uniform_real_distribution<double>(-most, most)(random);
  };
  for (int n = 0; n < 40; ++n) {
    Crate<double> crate;
    shelf::turn_exact(crate.q, {number(3), number(3), number(3)}, 1);
    crate.spin_with({number(8), number(8), number(8)});
    crate.v = {number(3), 0, number(3)};
    crate.lift_to(0.5);
    const double begun = crate.energy();
    double least = begun;
    for (int step = 0; step < 180; ++step) {
      crate.step(1 / 60.0, {0.5, 0.9, 0.5});
      REQUIRE(crate.energy() < least + 1e-2 * begun);
      least = std::min(least, crate.energy());
    }
  }
}

TEST_CASE("No time, or what is none, moves nothing") {
  for (const double h : {0.0, double(NAN), -1.0}) {
    Crate<double> crate;
    crate.x = {0, 0.2, 0}, crate.v = {1, -2, 0}, crate.L = {1, 2, 3};
    crate.find_corners();
    const auto spin = [&](const Vec& L) { return angular_velocity(crate.q, L, crate.inertia()); };
    const auto way =
        shelf::contact_step(crate.v, crate.L, Vec{0, -g, 0}, h, crate.contacts, 8,
                            shelf::Surface<double>{0.5, 0, 0.5}, 1 / 20.0, spin, dot_of, cross_of);
    CHECK((way.v.x == 1 && way.v.y == -2 && way.L.z == 3));
    CHECK((crate.v.x == 1 && crate.v.y == -2 && crate.L.z == 3));
  }
}
