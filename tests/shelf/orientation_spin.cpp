// SPDX-License-Identifier: MIT-0
// Bodies that spin freely.
#include <algorithm>
#include <array>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "orientation_try.h"

using Catch::Matchers::WithinAbs;

namespace {

// How far from the truth a body's orientation gets in a second, at most [rad].
template <class Step>
Long worst(Step step, const EulerTop& top, int steps) {
  Body<double> body(top.inertia, top.w);
  Long found = 0;
  for (int n = 1; n <= steps; ++n) {
    step(body, 1.0 / steps);
    if (n % (steps / 10) == 0) {
      found = std::max(found,
                       EulerTop::angle_between(matrix(body.q), top.orientation(Long(n) / steps)));
    }
  }
  return found;
}

template <class Step>
void check_order(Step step, double order) {
  // A box of three lengths, in a spin that no axis is near.
  const EulerTop top{V(1.3L, 2, 2.9L), V(2, 3, -2.5L)};
  double before = 0;
  for (const int steps : {320, 640, 1280}) {
    const double slope = double(std::log2(worst(step, top, steps) / worst(step, top, 2 * steps)));
    CHECK_THAT(slope, WithinAbs(order, 0.1));
    if (before > 0) CHECK_THAT(slope, WithinAbs(before, 0.05));
    before = slope;
  }
}

}  // namespace

TEST_CASE("A free body's spin by rotations is of order two") {
  check_order(by_rotations, 2);
}

TEST_CASE("A free body's spin by the midpoint rule is of order two") {
  check_order(by_midpoint, 2);
}

TEST_CASE("A free body's spin by Bullet's step is of order one") {
  check_order(by_bullet, 1);
}

TEST_CASE("A spin by rotations is a ball's turn and those about the axes, one after the other") {
  for (const V& I : bodies()) {
    Body<double> body(I, 5 * direction());
    M R = M::Identity();
    for (int n = 0; n < 5; ++n) {
      const Long h = 0.1L * n - 0.15L;
      const V L = exact(body.L);
      const Long ball = I.x() + I.y() + I.z() - I.maxCoeff() - I.minCoeff();  // the middle one
      R = about(L, h / ball) * R;
      for (const int axis : {0, 1, 2, 1, 0}) {
        const Long spin = (R.transpose() * L)[axis];
        const Long time = axis == 2 ? h : h / 2;
        R = R * about(V::Unit(axis), time * spin * (1 / I[axis] - 1 / ball));
      }
      by_rotations(body, double(h));
      CHECK(EulerTop::angle_between(matrix(body.q), R) < 10 * roundings<double>(I, L, 0.2L));
    }
  }
}

TEST_CASE("A spin by the midpoint rule solves its equation, and turns as it says") {
  for (const V& I : bodies()) {
    Body<double> body(I, 5 * direction());
    for (const double h : {0.1, -0.05, 0.3}) {
      const V before = body.momentum();
      const M R = matrix(body.q);
      by_midpoint(body, h);
      const V after = body.momentum();
      const V L = (before + after) / 2, w = L.cwiseQuotient(I);
      const Long slack = roundings<double>(I, L, h);
      CHECK((after - before - h * L.cross(w)).norm() < slack * L.norm());
      const M half = h / 2 * EulerTop::crossing(w);
      const M one = M::Identity();
      CHECK(EulerTop::angle_between(matrix(body.q), R * ((one - half).inverse() * (one + half))) <
            slack);
    }
  }
}

TEST_CASE("A spin by Bullet's step is the one in Bullet's source") {
  for (const V& I : bodies()) {
    Body<double> body(I, 5 * direction());
    for (const double h : {0.02, 0.1}) {
      const auto cross = EulerTop::crossing;
      const M tensor = I.asDiagonal(), R = matrix(body.q);
      const V w = body.spin();
      const V residual = h * w.cross(tensor * w);
      const M jacobian = tensor + h * (cross(w) * tensor - cross(tensor * w));
      const V end = w - jacobian.inverse() * residual;
      by_bullet(body, h);
      CHECK((body.spin() - end).norm() < 1e-11L * end.norm());
      CHECK(EulerTop::angle_between(matrix(body.q), R * about(end, h)) < 1e-12L);
    }
  }
}

TEMPLATE_TEST_CASE("A body with two equal moments spins without error, at any step", "", float,
                   double) {
  for (const V& I : {V(1, 1, 2), V(2, 2, 1), V(1, 2, 1), V(2, 1, 2), V(1, 2, 2), V(2, 1, 1),
                     V(1, 1, 0.01L), V(1, 0.01L, 1), V(0.01L, 1, 1)}) {
    const V w = V(1, -2, 3);
    for (const Long h : {1e-3L, 1 / 60.0L, 0.3L, 2.0L, -1.0L}) {
      Body<TestType> body(I, w);
      const EulerTop top{exact(body.inertia), exact(body.L).cwiseQuotient(exact(body.inertia))};
      for (int n = 0; n < 10; ++n) by_rotations(body, TestType(h));
      const Long off =
          EulerTop::angle_between(matrix(body.q), top.orientation(10 * Long(TestType(h))));
      CHECK(off < 10 * roundings<TestType>(I, exact(body.L), h));
    }
  }
  Body<TestType> ball(V(2, 2, 2), V(1, -2, 3));
  by_rotations(ball, TestType(0.7L));
  CHECK(EulerTop::angle_between(matrix(ball.q), about(V(1, -2, 3), Long(TestType(0.7L)))) <
        8 * rounding<TestType>);
}

TEST_CASE("A long thin body spins as truly as a thick one") {
  // A pencil of 180 by 7 by 7.5 mm, which rolls fast.
  const V I = exact(shelf::inertia_of_box(0.005, {0.007, 0.18, 0.0075}));
  const EulerTop pencil{I, V(3, 40, -2)};
  const auto worst_in_two_seconds = [&](int rate) {
    Body<double> body(I, pencil.w);
    const Long first = body.energy();
    Long angle = 0, energy = 0;
    for (int n = 1; n <= 2 * rate; ++n) {
      by_rotations(body, 1.0 / rate);
      angle = std::max(angle,
                       EulerTop::angle_between(matrix(body.q), pencil.orientation(n / Long(rate))));
      energy = std::max(energy, std::abs(body.energy() / first - 1));
    }
    return std::pair(angle, energy);
  };
  const auto [angle, energy] = worst_in_two_seconds(60);
  CHECK(angle < 1e-3L);
  CHECK(energy < 2e-5L);
  const auto [fine_angle, fine_energy] = worst_in_two_seconds(240);
  CHECK_THAT(double(angle / fine_angle), WithinAbs(16, 1));
  CHECK_THAT(double(energy / fine_energy), WithinAbs(16, 1));
}

TEST_CASE("A step back undoes a step of a spin by rotations or by the midpoint rule") {
  for (const V& I : bodies()) {
    const V w = 10 * direction();
    const auto there_and_back = [&](auto step) {
      Body<double> body(I, w);
      const std::vector<double> frames = {1 / 60.0, 0.03, 1 / 144.0, 0.1, 0.001};
      for (const double h : frames) step(body, h);
      for (std::size_t n = frames.size(); n > 0; --n) step(body, -frames[n - 1]);
      return EulerTop::angle_between(matrix(body.q), M::Identity());
    };
    const Long bound = 10 * roundings<double>(I, I.cwiseProduct(w), 0.1L);
    CHECK(there_and_back(by_rotations) < bound);
    CHECK(there_and_back(by_midpoint) < bound);
    const Long differs = I.maxCoeff() / I.minCoeff();
    if (differs > 1) CHECK(there_and_back(by_bullet) > 1e-5L);
  }
}

TEST_CASE("A thrown book keeps its energy by rotations within 0.0014, however its axes are named") {
  for (const auto& [x, y, z] : {std::array{0, 1, 2}, std::array{0, 2, 1}, std::array{1, 0, 2},
                                std::array{1, 2, 0}, std::array{2, 0, 1}, std::array{2, 1, 0}}) {
    const V I(thrown_inertia[x], thrown_inertia[y], thrown_inertia[z]);
    Body<double> body(I, V(thrown_w[x], thrown_w[y], thrown_w[z]));
    const Long first = body.energy();
    Long early = 0, late = 0;
    for (int n = 0; n < 6000; ++n) {
      by_rotations(body, 1 / 60.0);
      Long& largest = n < 600 ? early : late;
      largest = std::max(largest, std::abs(body.energy() / first - 1));
    }
    CHECK(early < 0.0014L);
    CHECK(early > 0.0005L);
    CHECK(late < 1.1L * early);  // nor does it drift, in a hundred seconds
  }
}

TEMPLATE_TEST_CASE("The midpoint rule keeps energy to rounding while a step turns by two at most",
                   "", float, double) {
  for (int n = 0; n < 20'000; ++n) {
    const V size(number(0.02L, 1), number(0.02L, 1), number(0.02L, 1));
    const V I = exact(shelf::inertia_of_box(TestType(1), vec<TestType>(size)));
    Body<TestType> body(I, direction());
    const Long first = body.energy();
    by_midpoint(body, TestType(n % 2 ? number(-2, 2) : 2 * (n % 4 - 1)));
    CHECK(std::abs(body.energy() / first - 1) < 16 * rounding<TestType>);
  }
  Body<TestType> book;
  const Long first = book.energy();
  for (int n = 0; n < 600; ++n) by_midpoint(book, TestType(1 / 60.0L));
  CHECK(std::abs(book.energy() / first - 1) < 200 * rounding<TestType>);
}

TEST_CASE("Bullet's step takes 88 per cent of a thrown book's energy in ten seconds") {
  Body<double> body;
  const Long first = body.energy();
  Long before = first;
  for (int n = 0; n < 600; ++n) {
    by_bullet(body, 1 / 60.0);
    CHECK(body.energy() < before * (1 + 4 * rounding<double>));
    before = body.energy();
  }
  CHECK_THAT(double(before / first), WithinAbs(0.1153, 0.0001));
}

TEST_CASE(
    "Turned by the angular velocity at each start, a thrown book spins up to twice its energy") {
  // About the axis with the least moment L^2 / 2 I is the most that there can be.
  Body<double> body;
  const Long first = body.energy(), most = exact(body.L).squaredNorm() / 2 / 1;
  for (int n = 0; n < 600; ++n) {
    shelf::turn_exact(body.q, angular_velocity(body.q, body.L, body.inertia), 1 / 60.0);
  }
  CHECK(body.energy() > 1.9999L * first);
  CHECK(body.energy() <= most * (1 + 4 * rounding<double>));
}

TEST_CASE("A book that is thrown about its middle axis turns over when it should") {
  const EulerTop top;
  Body<double> rotations, midpoint;
  int overs = 0, by_r = 0, by_m = 0;
  Long truth = 20, r = 20, m = 20;
  const auto count = [](Long& before, Long now, int& turned_over) {
    turned_over += before * now < 0;
    before = now;
  };
  for (int n = 1; n <= 1200; ++n) {
    by_rotations(rotations, 1 / 240.0), by_midpoint(midpoint, 1 / 240.0);
    count(truth, top.spin(n / 240.0L).y(), overs);
    count(r, rotations.spin().y(), by_r);
    count(m, midpoint.spin().y(), by_m);
    if (n == 120) CHECK(overs + by_r + by_m == 0);
    if (n == 144) CHECK((overs == 1 && by_r == 1 && by_m == 1));
  }
  CHECK(overs >= 4);
  CHECK(by_r == overs);
  CHECK(by_m == overs);
}

TEMPLATE_TEST_CASE("Whatever the step, a spin's energy stays where its momentum allows", "", float,
                   double) {
  for (const V& I : bodies()) {
    for (const Long h : {0.1L, 10.0L, 1e4L}) {
      Body<TestType> body(I, 10 * direction());
      const Long square = exact(body.L).squaredNorm() / 2, much = 1 + 16 * rounding<TestType>;
      for (int n = 0; n < 50; ++n) {
        by_rotations(body, TestType(h));
        CHECK(body.energy() < square / I.minCoeff() * much);
        CHECK(body.energy() * much > square / I.maxCoeff());
        CHECK(std::abs(length(body.q) - 1) < 2 * rounding<TestType>);
      }
    }
  }
}

TEST_CASE("In float a thrown book goes the way that it goes in double") {
  Body<float> body(thrown_inertia, V(3, 20, 4));
  Body<double> truth(thrown_inertia, V(3, 20, 4));
  for (int n = 0; n < 600; ++n) by_rotations(body, 1 / 60.0f), by_rotations(truth, 1 / 60.0);
  CHECK(EulerTop::angle_between(matrix(body.q), matrix(truth.q)) < 2e-3L);
}

TEMPLATE_TEST_CASE("A damped spin is right in its direction and its speed, at any frame rate", "",
                   float, double) {
  // The truth by Runge and Kutta: the body is braked by -c L.
  const V I(1, 1, 1.7L);
  for (const Long c : {1e-6L, 0.5L, 4.0L}) {
    V w(1, -2, 3);
    M R = M::Identity();
    const auto slope = [&](const V& now) -> V {
      return (-now.cross(I.cwiseProduct(now))).cwiseQuotient(I) - c * now;
    };
    const auto cross = EulerTop::crossing;
    const Long dt = 1e-3L;
    for (int n = 0; n < 1500; ++n) {
      const V k1 = slope(w), w2 = w + dt / 2 * k1, k2 = slope(w2), w3 = w + dt / 2 * k2;
      const V k3 = slope(w3), w4 = w + dt * k3, k4 = slope(w4);
      const M r1 = R * cross(w), r2 = (R + dt / 2 * r1) * cross(w2);
      const M r3 = (R + dt / 2 * r2) * cross(w3), r4 = (R + dt * r3) * cross(w4);
      w += dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
      R += dt / 6 * (r1 + 2 * r2 + 2 * r3 + r4);
    }
    for (const int steps : {1, 15, 90, 360}) {
      Body<TestType> body(I, V(1, -2, 3));
      for (int n = 0; n < steps; ++n) {
        shelf::spin_damped(body.q, body.L, body.inertia, TestType(1.5L / steps), TestType(c));
      }
      const Long bound = 1e-10L + 30 * (1 + steps) * rounding<TestType>;
      CHECK(EulerTop::angle_between(matrix(body.q), R) < bound);
      CHECK((body.spin() - w).norm() < 4 * bound);
    }
  }
  Body<TestType> none, free;
  shelf::spin_damped(none.q, none.L, none.inertia, TestType(0.1L), TestType(0));
  by_rotations(free, TestType(0.1L));
  CHECK((none.q.w == free.q.w && none.q.x == free.q.x && none.q.y == free.q.y));
  CHECK((none.L.x == free.L.x && none.L.y == free.L.y && none.L.z == free.L.z));
}

TEMPLATE_TEST_CASE("What does not spin does not turn, and what is not a number stays none", "",
                   float, double) {
  const auto same = [](const auto& a, const auto& b) {
    return a.w == b.w && a.x == b.x && a.y == b.y && a.z == b.z;
  };
  for (const V& I : bodies()) {
    Body<TestType> body(I, V::Zero());
    by_rotations(body, TestType(1)), by_midpoint(body, TestType(1)), by_bullet(body, TestType(1));
    CHECK(same(body.q, shelf::Quaternion<TestType>{}));
  }
  Body<TestType> book;
  by_rotations(book, TestType(0)), by_midpoint(book, TestType(0)), by_bullet(book, TestType(0));
  CHECK(same(book.q, shelf::Quaternion<TestType>{}));
  const TestType nan = std::numeric_limits<TestType>::quiet_NaN();
  shelf::Quaternion<TestType> q, exactly;
  shelf::turn(q, {nan, 0, 0}, TestType(1)), shelf::turn_exact(exactly, {0, nan, 0}, TestType(1));
  CHECK((std::isnan(q.w) && std::isnan(exactly.w)));
  by_rotations(book, nan);
  CHECK(std::isnan(book.q.w));
}
