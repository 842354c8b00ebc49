// SPDX-License-Identifier: MIT-0
// Each method against its textbook formula, on coarse steps, where no two methods look alike.
#include <algorithm>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <limits>
#include <tuple>
#include <type_traits>
#include <vector>

#include "measure/evaluations.h"
#include "measure/methods.h"
#include "measure/run.h"
#include "scenes/pendulum.h"
#include "textbook/euler.h"
#include "textbook/newton.h"
#include "textbook/runge_kutta.h"
#include "textbook/verlet.h"

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using scenes::State;

namespace {

template <int Corrections>
struct MoreCorrected : measure::Corrected<Corrections> {
  static constexpr std::string_view header = "predicted_euler.h";
  static constexpr long evaluations = 1 + Corrections;
};

template <int Corrections>
textbook::Table table(MoreCorrected<Corrections>) {
  return textbook::predicted_euler(Corrections);
}

constexpr auto has_formula = [](auto method) {
  return requires { textbook::steps(method, textbook::Force(), textbook::State(), 0.3L, 1); };
};
static_assert(std::is_same_v<list::Where<has_formula>, list::General>,
              "tests/methods/textbook has no formula of a method in code/measure/methods");

using MoreCorrections = std::tuple<MoreCorrected<2>, MoreCorrected<3>>;
using AllMethods = list::Joined<list::Where<has_formula>, MoreCorrections>;
constexpr auto is_explicit = [](auto method) {
  return has_formula(method) && list::is_in<decltype(method)>(list::EveryExplicit());
};
using AllExplicit = list::Joined<list::Where<is_explicit>, MoreCorrections>;

template <class Method, class Real, class Force>
std::vector<State<Real>> steps_of_header(const Force& force, const State<Real>& start, Real h,
                                         int count) {
  std::vector<State<Real>> states;
  auto memory = measure::start(Method(), start, h, force);
  for (int n = 0; n < count; ++n) {
    measure::advance(Method(), memory, Real(n) * h, h, force);
    states.push_back(measure::to_state(Method(), memory, Real(n + 1) * h, h, force));
  }
  return states;
}

// What rounding may do in four of these steps. An evaluation of the acceleration and the sums that
// use it round some 20 times, by half an epsilon of a number below 2, and of those a third arrives;
// a velocity that is a difference of positions rounds three more times and divides by h, above 1/6.
// That is fewer than 32 half epsilons, and in four steps no error grows by more than a factor of 3.
template <class Method>
double rounding_in_float() {
  const double evaluations = 4.0 * std::max(Method::evaluations, 2L);
  return evaluations * 32 * (std::numeric_limits<float>::epsilon() / 2) * 3;
}

struct Asked {
  double x, v, t;
};

bool same(const Asked& a, const Asked& b) {
  return std::abs(a.x - b.x) + std::abs(a.v - b.v) + std::abs(a.t - b.t) < 1e-12;
}

// Pushed, and everything that it was asked, but for what it was asked twice in a row: a method that
// keeps the last acceleration need not ask again, its textbook formula may.
struct Remembering : textbook::Pushed {
  std::vector<Asked>* asked;

  template <class Real, class Time>
  Real operator()(const Real& x, const Real& v, Time t) const {
    const Asked now{double(x), double(v), double(t)};
    if (asked->empty() || !same(asked->back(), now)) asked->push_back(now);
    return textbook::Pushed::operator()(x, v, t);
  }
};

}  // namespace

TEMPLATE_LIST_TEST_CASE("Coarse steps are those of the textbook", "", AllMethods) {
  INFO(TestType::header);
  for (const double h : {0.3, -0.2}) {
    const auto expected = textbook::steps(TestType(), textbook::Pushed(), {0.7, -1.1}, h, 8);
    const auto found =
        steps_of_header<TestType>(textbook::Pushed(), State<double>{0.7, -1.1}, h, 8);
    for (std::size_t n = 0; n < 8; ++n) {
      CAPTURE(h, n);
      CHECK_THAT(found[n].x, WithinRel(double(expected[n].x), 1e-12));
      CHECK_THAT(found[n].v, WithinRel(double(expected[n].v), 1e-12));
    }
  }
}

TEMPLATE_LIST_TEST_CASE("In float, coarse steps are those of the textbook but for rounding", "",
                        AllMethods) {
  INFO(TestType::header);
  for (const float h : {0.3f, -0.2f}) {
    const auto expected = textbook::steps(TestType(), textbook::Pushed(), {0.7f, -1.1f}, h, 4);
    const auto found =
        steps_of_header<TestType>(textbook::Pushed(), State<float>{0.7f, -1.1f}, h, 4);
    for (std::size_t n = 0; n < 4; ++n) {
      CAPTURE(h, n);
      CHECK_THAT(found[n].x, WithinAbs(double(expected[n].x), rounding_in_float<TestType>()));
      CHECK_THAT(found[n].v, WithinAbs(double(expected[n].v), rounding_in_float<TestType>()));
    }
  }
}

TEMPLATE_LIST_TEST_CASE("The acceleration is asked for where the textbook asks", "", AllExplicit) {
  INFO(TestType::header);
  std::vector<Asked> by_textbook, by_header;
  textbook::steps(TestType(), Remembering{{}, &by_textbook}, {0.7, -1.1}, 0.3, 3);
  steps_of_header<TestType>(Remembering{{}, &by_header}, State<double>{0.7, -1.1}, 0.3, 3);
  REQUIRE(by_header.size() == by_textbook.size());
  for (std::size_t n = 0; n < by_header.size(); ++n) {
    CAPTURE(n, by_header[n].x, by_textbook[n].x, by_header[n].t, by_textbook[n].t);
    CHECK(same(by_header[n], by_textbook[n]));
  }
}

TEST_CASE("Predicted Euler corrects once, unless it is told to do more") {
  State<double> told{0.7, -1.1}, untold = told;
  int asked = 0;
  const auto force = [&asked](double x, double v, double t) {
    ++asked;
    return textbook::Pushed()(x, v, t);
  };
  integrate::predicted_euler(told.x, told.v, 0.2, 0.3, force, 1);
  asked = 0;
  integrate::predicted_euler(untold.x, untold.v, 0.2, 0.3, force);
  CHECK(asked == 2);
  CHECK(untold.x == told.x);
  CHECK(untold.v == told.v);
}

TEMPLATE_LIST_TEST_CASE("The acceleration is asked for as often as the list says", "", AllMethods) {
  INFO(TestType::header);
  const long evaluations = measure::evaluations_per_step(TestType(), scenes::Pendulum<>(), 0.3);
  if (TestType::evaluations == measure::as_needed) {
    CHECK(evaluations > 1);
  } else {
    CHECK(evaluations == TestType::evaluations);
  }
}
