// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <complex>

#include "format_values.h"
#include "harness.h"
#include "judge/describe.h"
#include "judge/diagnose.h"
#include "judge/random.h"
#include "judge/session.h"
#include "judge/tests.h"

using namespace judge;
using grade::number;
using Complex = std::complex<double>;

namespace {

constexpr double furthest = 10;  // of h omega, as the task says

Complex polynomial(Complex z, int terms) {
  Complex sum = 1;
  for (int n = terms; n > 0; --n) sum = 1.0 + z / double(n) * sum;
  return sum;
}

// Exact where it has only one part, which not every library's is.
Complex root_of(double number) {
  return number < 0 ? Complex(0, std::sqrt(-number)) : Complex(std::sqrt(number));
}

double stretch(Complex z, int terms) {
  return std::abs(polynomial(z, terms));
}

// The stretch in a step of that motion of a spring's two which grows more.
double worst(double homega, double zeta, int terms, double shrinking) {
  const Complex root = root_of(zeta * zeta - 1);
  return std::max(stretch(homega * (-shrinking + root), terms),
                  stretch(homega * (-shrinking - root), terms));
}

double worst(double homega, double zeta, int terms) {
  return worst(homega, zeta, terms, zeta);
}

// The limit of h omega. A midpoint step has two terms, Euler's one.
double limit(double zeta, int terms, double shrinking) {
  double stable = 0, unstable = furthest;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = (stable + unstable) / 2;
    (worst(middle, zeta, terms, shrinking) > 1 ? unstable : stable) = middle;
  }
  return stable;
}

double limit(double zeta, int terms) {
  return limit(zeta, terms, zeta);
}

bool near(double a, double b, double off = 1e-6) {
  return std::abs(a - b) <= off * std::abs(b);
}

std::vector<std::string> what_is_wrong(double got, double omega, double zeta) {
  const double off = std::abs(got * omega / limit(zeta, 4) - 1);
  if (off > 1e-6 && off < 1e-3)
    return {"right to " + number(std::floor(-std::log10(off))) +
            " digits, and six are asked for: does a search end too soon?"};
  if (near(got, furthest / omega))
    return {"no step of your search grew; is something in it not a number?"};
  return diagnose(got, limit(zeta, 4) / omega);
}

grade::Plot plot(double got, double omega, double zeta) {
  grade::Curve yours{"your longest step", {got, got}, {0, 1.5}};
  grade::Curve size{"what a step of RK4 does", {}, {}}, one{"neither more nor less", {}, {}};
  const double end = 1.2 * limit(zeta, 4);
  for (int n = 0; n <= 240; ++n) {
    const double homega = end * n / 240;
    size.x.push_back(homega / omega);
    size.y.push_back(worst(homega, zeta, 4));
    one.x.push_back(homega / omega);
    one.y.push_back(1);
  }
  return {"The motion that grows most", "step [s]", "size after a step", {yours, size, one}};
}

void check_limit(Student& student, double omega, double zeta, const std::string& hint) {
  const double expected = limit(zeta, 4) / omega;
  const double got = student.call(1, {omega, zeta}, 1).front();
  grade::Finding finding;
  finding.held = near(got, expected);
  finding.asked = "the longest step of RK4 on a spring";
  finding.input = "omega = " + number(omega, 17) + "/s, " + named("zeta", zeta);
  finding.expected = number(expected, 9) + " s";
  finding.got = number(got, 9) + " s";
  finding.error = number(std::abs(got - expected), 3) + " s";
  finding.tolerance = number(1e-6 * expected, 2) + " s";
  finding.tolerance_from = "six digits, as the task asks; 27 halvings of 10/omega give them";
  if (!finding.held) {
    finding.hint = hint;
    finding.diagnoses = what_is_wrong(got, omega, zeta);
    if (std::isfinite(got)) finding.plot = plot(got, omega, zeta);
  }
  check(finding);
}

void check_stretch(Student& student, Complex z) {
  is_exact("what a step of RK4 does to the size of a motion", named("re", z.real(), "im", z.imag()),
           student.call(0, {z.real(), z.imag()}, 1).front(), stretch(z, 4),
           rounding(polynomial(std::abs(z), 4).real()),
           "RK4 keeps the terms of e^z up to the fourth power. The size of a complex number is "
           "the root of the sum of its parts squared.");
}

// A damping of any size, one in four times nearly critical.
double any_zeta(Random& random) {
  if (random.whole(0, 3) > 0) return random.anywhere(harness_bounds::zeta);
  const double away = random.octaves(1e-9, 0.2);
  return random.whole(0, 1) == 1 ? 1 + away : 1 - away;
}

}  // namespace

TEST_CASE("a step stretches every motion as the polynomial of RK4 does",
          "[3-runge-kutta/edge-of-stability][3 points]") {
  Student student;
  Random random;
  std::vector<Complex> motions;
  for (int n = 0; n < 8; ++n) {
    const double size = random.between(0.5, 4), angle = random.between(1.7, 3);
    motions.push_back(std::polar(size, n % 2 == 0 ? angle : -angle));
  }
  for (const Complex& z : motions) {
    check_stretch(student, z);
  }
}

TEST_CASE("without damping the step may be as long as the chapter says",
          "[3-runge-kutta/edge-of-stability][2 points]") {
  Student student;
  Random random;
  for (int n = 0; n < 2; ++n) {
    check_limit(student, random.between(2, 60), 0,
                "Without damping h lambda is imaginary. Does your search start where the step is "
                "stable and end where it is not?");
  }
}

TEST_CASE("below critical damping the limit is where the swing neither grows nor shrinks",
          "[3-runge-kutta/edge-of-stability][2 points]") {
  Student student;
  Random random;
  for (int n = 0; n < 6; ++n) {
    const double zeta = (n + random.between(0.1, 0.9)) / 6;
    check_limit(student, random.between(2, 60), zeta,
                "The two answers for lambda are a pair: the same real part, and imaginary parts of "
                "opposite sign. Both have the size omega.");
  }
}

TEST_CASE("from critical damping on the faster of two motions sets the limit",
          "[3-runge-kutta/edge-of-stability][2 points]") {
  Student student;
  Random random;
  // With less than 1.9 the slower motion has a limit that is seen, too.
  for (const double zeta : {1.0, random.between(1.2, 1.9), random.between(1, 4)}) {
    check_limit(student, random.between(2, 60), zeta,
                "Both answers for lambda are real now. Neither motion may grow, and one of them is "
                "much faster than omega.");
  }
}

TEST_CASE(
    "any motion has its stretch and any spring its limit, however small, large or nearly critical",
    "[3-runge-kutta/edge-of-stability][1 point]") {
  Student student;
  Random random;
  constexpr int motions = 200, springs = 200;
  for (int n = 0; n < motions; ++n)
    check_stretch(student,
                  {random.anywhere(harness_bounds::re), random.anywhere(harness_bounds::im)});
  constexpr double longest = 0.139;  // about the zeta at which h omega may be largest
  for (int n = 0; n < springs; ++n) {
    const double zeta = n == 0 ? longest : any_zeta(random);
    const double omega =
        n == 0 ? harness_bounds::omega.smallest() : random.anywhere(harness_bounds::omega);
    check_limit(student, omega, zeta,
                "Is omega or zeta so small, so large or so near to another here that a line of "
                "yours does something of its own? Or is something remembered of the last spring?");
  }
}
