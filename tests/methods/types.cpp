// SPDX-License-Identifier: MIT-0
// What a method may be called with: a clock of its own type, constants, steps back in time.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <vector>

#include "one_step.h"

using Catch::Matchers::WithinAbs;
using scenes::State;

namespace {

// x'' = t - x^3 - x'/2: not linear, with all arguments in it, and with nothing but + - * and /.
struct Cubic {
  template <class Vec, class Time>
  constexpr Vec operator()(const Vec& x, const Vec& v, Time t) const {
    return Vec(t) - x * x * x - v / Vec(2);
  }
  template <class Vec, class Time, class Add>
  constexpr void jacobian(const Vec& x, const Vec&, Time, Add&& add) const {
    add(0, 0, Vec(-3) * x * x, Vec(-0.5));
  }
};

// Remembers the times that it is asked for.
struct Timed {
  std::vector<double>* asked;
  template <class Vec, class Time>
  Vec operator()(const Vec&, const Vec&, Time t) const {
    asked->push_back(t);
    return Vec(4);
  }
  template <class Vec, class Time, class Add>
  void jacobian(const Vec&, const Vec&, Time t, Add&& add) const {
    asked->push_back(t);
    add(0, 0, Vec(0), Vec(0));
  }
};

// Played backwards, a motion passes the same places with the opposite velocities.
struct Backwards {
  Cubic scene;
  double operator()(double x, double v, double t) const { return scene(x, -v, -t); }
  template <class Add>
  void jacobian(double x, double v, double t, Add&& add) const {
    scene.jacobian(x, -v, -t,
                   [&](int i, int j, double dadx, double dadv) { add(i, j, dadx, -dadv); });
  }
};

}  // namespace

TEMPLATE_LIST_TEST_CASE("After a night the clock still counts, while everything else is a float",
                        "", list::General) {
  INFO(TestType::header);
  // A float cannot tell this time from the next frame's.
  const double night = 8 * 3600 + 1.0 / 1024;
  std::vector<double> at_once, after_night;
  one_step(TestType(), State<float>{1, 2}, 0.0, 0.5f, Timed{&at_once});
  one_step(TestType(), State<float>{1, 2}, night, 0.5f, Timed{&after_night});
  REQUIRE(after_night.size() == at_once.size());
  for (std::size_t n = 0; n < at_once.size(); ++n) {
    CHECK_THAT(after_night[n] - night, WithinAbs(at_once[n], 1e-10));
  }
}

TEMPLATE_LIST_TEST_CASE("The compiler can take the step itself, to the same bits", "",
                        list::General) {
  INFO(TestType::header);
  constexpr State<double> compiled = one_step(TestType(), State<double>{1, 2}, 0.3, 0.7, Cubic());
  const volatile double h = 0.7;
  const double step = h;
  const auto run = one_step(TestType(), State<double>{1, 2}, 0.3, step, Cubic());
  CHECK(compiled.x == run.x);
  CHECK(compiled.v == run.v);
  STATIC_CHECK(compiled.x != 1);
}

TEST_CASE("The compiler can take the step of a spring or a damping itself, to the same bits") {
  constexpr auto step = [](double h) {
    double x = 1, v = 2;
    integrate::backward_euler_spring(x, v, h, 3.0, 0.1);
    integrate::rk4_linear(x, v, integrate::rk4_linear_start(9.0, 0.6, h));
    integrate::linear_damping_explicit_first(x, v, 0.3, h, 0.7, Cubic());
    integrate::linear_damping_explicit_last(x, v, 0.3, h, 0.7, Cubic());
    integrate::linear_damping_implicit_first(x, v, 0.3, h, 0.7, Cubic());
    integrate::linear_damping_implicit_last(x, v, 0.3, h, 0.7, Cubic());
    return State<double>{x, v};
  };
  constexpr State<double> compiled = step(0.7);
  const volatile double h = 0.7;
  const auto run = step(h);
  CHECK(compiled.x == run.x);
  CHECK(compiled.v == run.v);
}

TEMPLATE_LIST_TEST_CASE("A negative step is a step of the same film played backwards", "",
                        list::General) {
  INFO(TestType::header);
  const auto back = one_step(TestType(), State<double>{0.7, -1.1}, 0.25, -0.3, Cubic());
  const auto film = one_step(TestType(), State<double>{0.7, 1.1}, -0.25, 0.3, Backwards());
  CHECK(back.x == film.x);
  CHECK(back.v == -film.v);
}
