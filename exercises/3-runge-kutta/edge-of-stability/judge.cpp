// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <complex>

#include "format_values.h"
#include "harness.h"
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

double stretch(Complex z, int terms) {
  return std::abs(polynomial(z, terms));
}

// What the two motions of a spring make of a step; the one that grows more.
double worst(double homega, double zeta, int terms, double shrinking) {
  const Complex root = std::sqrt(Complex(zeta * zeta - 1));
  return std::max(stretch(homega * (-shrinking + root), terms),
                  stretch(homega * (-shrinking - root), terms));
}

double worst(double homega, double zeta, int terms) {
  return worst(homega, zeta, terms, zeta);
}

// Of h omega. A midpoint step has two terms, Euler's one.
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

bool near(double a, double b) {
  return std::abs(a - b) <= 1e-6 * std::abs(b);
}

std::vector<std::string> looks_like(double got, double omega, double zeta) {
  const double off = std::abs(got * omega / limit(zeta, 4) - 1);
  if (off > 1e-6 && off < 1e-3)
    return {"right to " + number(std::floor(-std::log10(off))) +
            " digits, and six are asked for: does a search end too soon?"};
  std::vector<std::string> found = diagnose(got, limit(zeta, 4) / omega);
  const auto add_if = [&](double value, const std::string& says) {
    if (near(got, value)) found.push_back(says);
  };
  add_if(limit(zeta, 4), "this is h omega, and the step is asked for, in seconds");
  add_if(furthest / omega, "no step of your search grew; is something in it not a number?");
  add_if(limit(zeta, 1) / omega, "this is the limit of Euler's method");
  add_if(limit(zeta, 2) / omega, "this is the limit of the midpoint method");
  add_if(limit(zeta, 3) / omega, "a term of the polynomial is missing: the fourth power");
  if (zeta > 0)
    add_if(limit(zeta, 4, 2 * zeta) / omega,
           "the motions shrink with zeta omega; yours do with 2 zeta omega");
  if (zeta > 0) add_if(std::sqrt(8) / omega, "this is the limit without damping");
  if (zeta > 1) {
    const double slow = zeta - std::sqrt(zeta * zeta - 1);
    add_if(limit(1, 4) / slow / omega, "this is the limit of the slower of the two motions");
  }
  return found;
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
  finding.input = "omega = " + number(omega, 17) + "/s, zeta = " + number(zeta, 17);
  finding.expected = number(expected, 9) + " s";
  finding.got = number(got, 9) + " s";
  finding.error = number(std::abs(got - expected), 3) + " s";
  finding.tolerance = number(1e-6 * expected, 2) + " s";
  finding.tolerance_from = "six digits, as the task asks; 27 halvings of 10/omega give them";
  if (!finding.held) {
    finding.hint = hint;
    finding.diagnoses = looks_like(got, omega, zeta);
    if (std::isfinite(got)) finding.plot = plot(got, omega, zeta);
  }
  check(finding);
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
  for (const double re : harness_bounds::re.asked())
    for (const double im : harness_bounds::im.asked()) motions.emplace_back(re, im);
  for (const Complex& z : motions) {
    const double size = std::abs(z);
    is_exact("what a step of RK4 does to the size of a motion",
             "re = " + number(z.real(), 17) + ", im = " + number(z.imag(), 17),
             student.call(0, {z.real(), z.imag()}, 1).front(), stretch(z, 4),
             rounding(std::exp(size)),
             "RK4 keeps the terms of e^z up to the fourth power. The size of a complex number is "
             "the root of the sum of its parts squared.",
             {{stretch(z, 1), "this is what a step of Euler's method does"},
              {stretch(z, 2), "this is what a step of the midpoint method does"},
              {stretch(z, 3), "a term of the polynomial is missing: the fourth power"},
              {std::exp(z.real()), "this is what the motion itself does in the time"},
              {std::pow(stretch(z, 4), 2), "this is the square of the size"},
              {polynomial(z, 4).real(), "this is the real part of the polynomial, not its size"},
              {std::abs(polynomial(z, 4).real()),
               "this is the real part of the polynomial, not its size"}});
  }
}

TEST_CASE("without damping the step may be as long as the chapter says",
          "[3-runge-kutta/edge-of-stability][2 points]") {
  Student student;
  Random random;
  std::vector<double> omegas{random.between(2, 60), random.between(2, 60)};
  for (const double omega : harness_bounds::omega.asked()) omegas.push_back(omega);
  for (const double omega : omegas) {
    check_limit(student, omega, harness_bounds::zeta.smallest(),
                "Without damping h lambda is imaginary. Does your search start where the step is "
                "stable and end where it is not?");
  }
}

TEST_CASE("below critical damping the limit is where the swing neither grows nor shrinks",
          "[3-runge-kutta/edge-of-stability][3 points]") {
  Student student;
  Random random;
  for (int n = 0; n < 6; ++n) {
    check_limit(student, random.between(2, 60), (n + random.between(0.1, 0.9)) / 6,
                "The two answers for lambda are a pair: the same real part, and imaginary parts of "
                "opposite sign. Both have the size omega.");
  }
}

TEST_CASE("from critical damping on the faster of two motions sets the limit",
          "[3-runge-kutta/edge-of-stability][2 points]") {
  Student student;
  Random random;
  // With less than 1.9 the slower motion has a limit that is seen, too.
  for (const double zeta :
       {1.0, random.between(1.2, 1.9), random.between(1, 4), harness_bounds::zeta.largest()}) {
    check_limit(student, random.between(2, 60), zeta,
                "Both answers for lambda are real now. Neither motion may grow, and one of them is "
                "much faster than omega.");
  }
}
