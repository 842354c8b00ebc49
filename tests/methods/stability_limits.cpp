// SPDX-License-Identifier: MIT-0
// How large a step may be, from the matrix of the step, against theory.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <limits>
#include <typeinfo>

#include "measure/methods.h"
#include "measure/stability.h"
#include "scenes/linear_drag.h"
#include "scenes/spring.h"
#include "theory_of_limits.h"

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using scenes::LinearDrag;
using scenes::Spring;

namespace {

// A double root, as there is on a spring with zeta = 1, splits by the square root of rounding.
const double split = 8 * std::sqrt(std::numeric_limits<double>::epsilon());

// Six decimals, rounded or cut off.
constexpr double listed = 1e-6;

// The method's limit on a spring of omega = 2 is `paper`, in h omega.
template <class Step>
void check_limit(Step step, double zeta, double paper) {
  const Spring<> spring{.omega = 2, .zeta = zeta};
  if (paper == measure::always) {
    for (const double h : {0.01, 1.0, 1e3}) {
      CHECK(measure::is_stable(step, spring, h));
    }
  } else if (paper == 0) {
    for (const double h : {0.01, 0.1, 1.0}) CHECK(measure::spectral_radius(step, spring, h) > 1);
  } else {
    const double measured =
        2 * measure::stability_limit(step, spring, 0.9 * paper / 2, 1.1 * paper / 2);
    CHECK_THAT(measured, WithinRel(paper, split));
  }
}

// With more corrections the factor is a longer geometric sum.
template <int Corrections>
struct Corrected : measure::Corrected<Corrections> {};
template <int Corrections>
theory::Complex closed_factor(Corrected<Corrections>, theory::Complex z) {
  return theory::geometric<Corrections + 1>(z);
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("On drag the limit is the listed one, and theory's", "",
                        theory::WithPolynomial) {
  INFO(typeid(TestType).name());
  const LinearDrag<> drag{.c = 2, .g = 0};
  const double paper = theory::drag_limit(TestType());
  if (paper == measure::always) {
    CHECK(TestType::drag_limit == paper);
    for (const double h : {0.01, 1.0, 1e3}) {
      CHECK(measure::is_stable(TestType(), drag, h));
    }
  } else {
    CHECK_THAT(TestType::drag_limit, WithinAbs(paper, listed));
    const double measured =
        2 * measure::stability_limit(TestType(), drag, 0.9 * paper / 2, 1.1 * paper / 2);
    CHECK_THAT(measured, WithinRel(paper, split));
  }
}

TEMPLATE_LIST_TEST_CASE("On springs the limit is theory's, on undamped ones the listed one", "",
                        theory::WithPolynomial) {
  INFO(typeid(TestType).name());
  for (const double zeta : {0.0, 0.1, 0.5, 1.0, 2.0}) {
    CAPTURE(zeta);
    check_limit(TestType(), zeta, theory::spring_limit(TestType(), zeta));
  }
  const double undamped = theory::spring_limit(TestType(), 0);
  if (undamped == 0 || undamped == measure::always) {
    CHECK(TestType::spring_limit == undamped);
  } else {
    CHECK_THAT(TestType::spring_limit, WithinAbs(undamped, listed));
  }
}

TEMPLATE_LIST_TEST_CASE("A closed form of a limit is where the polynomial has it", "",
                        theory::WithPolynomial) {
  INFO(typeid(TestType).name());
  for (const double zeta : {0.1, 0.5, 1.0, 2.0}) {
    CAPTURE(zeta);
    const double closed = theory::spring_limit(TestType(), zeta);
    const double found = theory::spring_limit_of_polynomial(TestType(), zeta);
    if (closed == measure::always) {
      CHECK(found == closed);
    } else {
      CHECK_THAT(found, WithinRel(closed, split));
    }
  }
}

TEMPLATE_TEST_CASE("More corrections do not free implicit Euler from a limit near one", "",
                   Corrected<1>, Corrected<2>, Corrected<3>, Corrected<10>) {
  for (const double zeta : {0.0, 0.1, 0.5, 1.0, 2.0}) {
    CAPTURE(zeta);
    const double paper = theory::spring_limit_of_polynomial(TestType(), zeta);
    check_limit(TestType(), zeta, paper);
    CHECK(paper < 1.5);
  }
}
