// SPDX-License-Identifier: MIT-0
// Where games live, for every explicit method: steps of a 15th to a 240th of a second, forth and
// back, on springs and dampers of which a step sees little or much: c h and h omega from a
// millionth to one. Beside the textbook's step in long double there may be nothing but rounding.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "measure/methods.h"
#include "measure/run.h"
#include "textbook/euler.h"
#include "textbook/runge_kutta.h"
#include "textbook/verlet.h"

namespace {

constexpr auto is_explicit = [](auto method) {
  return list::is_in<decltype(method)>(list::EveryExplicit()) &&
         requires { textbook::steps(method, textbook::Force(), textbook::State(), 0.3L, 1); };
};
using AllExplicit = list::Where<is_explicit>;

// What comes back as a velocity is a difference of positions over a step.
template <class Method>
constexpr bool keeps_two_positions = std::string_view(Method::header) == "stormer_verlet.h";

// A spring with a damper, and a push that grows with time.
template <class Real>
struct Damped {
  Real k, c;

  template <class Time>
  Real operator()(Real x, Real v, Time t) const {
    return -k * x - c * v + Real(t);
  }
};

// The same numbers from every standard library, which a distribution would not give.
class Drawn {
 public:
  explicit Drawn(unsigned seed) : engine_(seed) {}
  double between(double least, double most) {
    return least + (most - least) * double(engine_()) / double(std::mt19937::max());
  }
  double power(double least, double most) {
    return std::pow(10.0, between(std::log10(least), std::log10(most)));
  }

 private:
  std::mt19937 engine_;
};

template <class Method, class Real>
void steps_are_right(Drawn& drawn) {
  const double length = 1 / drawn.between(15, 240), omega = drawn.power(1e-6, 1) / length;
  const auto h = Real(drawn.between(0, 1) < 0.5 ? -length : length);
  const Damped<Real> spring{Real(omega * omega), Real(drawn.power(1e-6, 1) / length)};
  const scenes::State<Real> start{Real(drawn.between(-2, 2)), Real(drawn.between(-2, 2))};

  auto memory = measure::start(Method(), start, h, spring);
  measure::advance(Method(), memory, Real(0), h, spring);
  const auto found = measure::to_state(Method(), memory, h, h, spring);

  const Damped<long double> same{spring.k, spring.c};
  const auto expected = textbook::steps(Method(), same, {start.x, start.v}, h, 1).back();

  // In sizes of what is added up; half of the roundings would be enough.
  const double x = std::abs(double(start.x)), v = std::abs(double(start.v)),
               step = std::abs(double(h));
  const double a = double(spring.k) * x + double(spring.c) * v + step;
  const double roundings =
      8 * double(Method::evaluations + 1) * double(std::numeric_limits<Real>::epsilon());
  const double of_x = roundings * (x + step * v + step * step * a);
  const double of_v = roundings * (v + step * a) + (keeps_two_positions<Method> ? of_x / step : 0);
  CAPTURE(Method::header, h, h * omega, double(h) * double(spring.c), start.x, start.v);
  CHECK(std::abs(double(found.x - expected.x)) <= of_x);
  CHECK(std::abs(double(found.v - expected.v)) <= of_v);
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("At the small steps of games every method is right to rounding", "",
                        AllExplicit) {
  Drawn drawn(20261122);
  for (int n = 0; n < 500; ++n) {
    steps_are_right<TestType, float>(drawn);
    steps_are_right<TestType, double>(drawn);
  }
}
