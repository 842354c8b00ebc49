// SPDX-License-Identifier: MIT-0
// The matrix of a step, from the method applied to unit vectors, against theory.
#include "measure/stability.h"

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <limits>
#include <typeinfo>

#include "measure/methods.h"
#include "scenes/linear_drag.h"
#include "scenes/spring.h"
#include "theory_of_damping.h"

using Catch::Matchers::WithinAbs;

namespace {

constexpr double sizes[] = {0.05, 0.3, 0.75, 1.0, 1.5, 1.9, 2.0, 2.5, 5.0};
constexpr double quarter = 0.25;

// Some forty operations a step, and determinants, whose terms are larger than their sum.
void check_same(const theory::Polynomial& measured, const theory::Polynomial& paper) {
  double size = 1;
  for (const double p : paper) size += std::abs(p);
  const double rounding = 40 * std::numeric_limits<double>::epsilon() * size * size;
  for (std::size_t n = 0; n < paper.size(); ++n) {
    CHECK_THAT(measured[n], WithinAbs(paper[n], rounding));
  }
}

template <class Method>
void check_springs() {
  for (const double zeta : {0.0, 0.1, 0.5, 1.0, 2.0}) {
    for (const double angle : sizes) {
      CAPTURE(zeta, angle);
      const scenes::Spring<> spring{.omega = angle / quarter, .zeta = zeta};
      check_same(theory::characteristic(measure::step_matrix(Method(), spring, quarter)),
                 theory::characteristic(Method(), theory::spring(angle, zeta)));
    }
  }
}

template <class Method>
void check_drag() {
  for (const double ch : sizes) {
    CAPTURE(ch);
    const scenes::LinearDrag<> drag{.c = ch / quarter, .g = 0};
    check_same(theory::characteristic(measure::step_matrix(Method(), drag, quarter)),
               theory::characteristic(Method(), theory::drag(ch)));
  }
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("On springs a step has the characteristic polynomial of theory", "",
                        theory::WithPolynomial) {
  INFO(typeid(TestType).name());
  check_springs<TestType>();
}

TEMPLATE_LIST_TEST_CASE(
    "A step of a method made for springs has the characteristic polynomial of theory", "",
    list::OnSprings) {
  INFO(typeid(TestType).name());
  check_springs<TestType>();
}

TEMPLATE_LIST_TEST_CASE("On drag a step has the characteristic polynomial of theory", "",
                        theory::WithPolynomial) {
  INFO(typeid(TestType).name());
  check_drag<TestType>();
}

TEMPLATE_LIST_TEST_CASE(
    "On drag symplectic Euler with damping of its own has the characteristic polynomial of theory",
    "", list::Damping) {
  INFO(typeid(TestType).name());
  check_springs<TestType>();
  check_drag<TestType>();
}
