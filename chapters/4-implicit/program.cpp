// SPDX-License-Identifier: MIT-0
// Chapter 4: implicit methods, from a bar that cannot be held to a soft constraint.
#include <cmath>
#include <stdexcept>

#include "../cast.h"
#include "blows.h"
#include "integrate/backward_euler.h"
#include "integrate/band_system.h"
#include "measure/error.h"
#include "measure/methods.h"
#include "measure/path.h"
#include "measure/record.h"
#include "measure/stability.h"
#include "net/conjugate_gradients.h"
#include "net/matrix_costs.h"
#include "net/struck_cloths.h"
#include "net/visible_error.h"
#include "parachute.h"
#include "scenes/linear_drag.h"
#include "scenes/rope.h"
#include "slide.h"
#include "soft.h"

using measure::backward_euler;
using measure::backward_euler_spring;
using measure::euler;
using measure::Record;
using measure::rk4;
using measure::symplectic_euler;
using measure::trapezoid;
using measure::whole;
using scenes::State;

namespace {

void opening(Record& record) {
  auto& table = record.table("bar", {{"frame", "", whole},
                                     {"Euler", "m"},
                                     {"symplectic Euler", "m"},
                                     {"RK4", "m"},
                                     {"backward Euler", "m"}});
  // [bar]
  const auto away = [](auto step, long frames) {
    return std::abs(measure::after(step, bar, bar.start(), frame, frames).x);
  };
  for (long n = 0; n <= 10; ++n) {
    table.add({double(n), away(euler, n), away(symplectic_euler, n), away(rk4, n),
               away(backward_euler_spring, n)});
  }
  // [bar]
  constexpr double light_year = 9.4607e15;  // m
  record.number("bar-euler", away(euler, 10) / 1000, 2, "km");
  record.number("bar-symplectic", away(symplectic_euler, 10) / light_year, 2, "light-years");
  record.number("bar-rk4", away(rk4, 10) / light_year / 1e6, 2, "million light-years");
  record.number("bar-backward", 1e9 * away(backward_euler_spring, 4), 2, "nm");
  record.number("bar-true", 1e6 * std::abs(bar.exact(4 * frame).x), 2, "µm");
  const auto rate = [](auto step) {
    return std::ceil(1 / measure::stability_limit(step, bar, 1e-5, 1));
  };
  record.number("rate-euler", rate(euler), whole);
  record.number("rate-symplectic", rate(symplectic_euler), whole);
  record.number("rate-rk4", rate(rk4), whole);
}

void from_the_end(Record& record) {
  auto& table = record.table("ends", {{"x", "m"}, {"y", "m"}});
  auto s = drone.start();
  record.number("tangent", s.v.norm(), 4, "m");  // in a step of a second
  table.add({s.x.x(), s.x.y()});
  integrate::backward_euler_spring(s.x, s.v, 1.0, drone.omega, 0.0);
  table.add({s.x.x(), s.x.y()});
  const auto home = measure::after(backward_euler, drone, drone.start(), frame, 10 * turn);
  record.number("drone-10", home.x.norm(), 3, "m");
}

void derived(Record& record) {
  record.number("parachute-once", -parachute_solved_once(diving, slow), 3, "m/s");
  record.number("parachute-derived", -derived_parachute(diving, slow), 3, "m/s");
  const State<double> opening{0, diving};
  record.number("parachute-true", -measure::after(rk4, parachute, opening, slow / 1000, 1000).v, 3,
                "m/s");
}

void called(Record& record) {
  // [rope]
  const scenes::Rope<> rope{.count = 20, .k = 1e4};
  const auto jacobian = [&](const auto& x, const auto& v, double t, auto add) {
    rope.jacobian(x, v, t, add);
  };
  integrate::BandSystem<5, decltype(jacobian)> system(jacobian);
  auto [x, v] = rope.start();
  const double h = 1 / 60.0;
  bool solved = true;
  for (int n = 0; n < 60 && solved; ++n) {
    solved = integrate::backward_euler(x, v, n * h, h, rope, system);
  }
  // [rope]
  if (!solved) throw std::runtime_error("the rope on its nail could not be solved");
  record.number("called-tip", -x[x.size() - 2], 2, "m");
  record.number("called-angle", frame * std::sqrt(rope.k / rope.mass), 2);
}

void predictors(Record& record) {
  auto& table =
      record.table("corrections", {{"corrections", "", whole}, {"drag"}, {"undamped spring"}});
  for (int corrections = 1; corrections <= 20; ++corrections) {
    const auto step = [corrections](auto& x, auto& v, auto t, auto h, auto&& a) {
      integrate::predicted_euler(x, v, t, h, a, corrections);
    };
    const auto limit = [&](const auto& scene) {
      return measure::stability_limit(step, scene, 1e-3, 10);
    };
    table.add({double(corrections), limit(scenes::LinearDrag<>{.c = 1, .g = 0}),
               limit(scenes::Spring<>{.omega = 1})});
  }
  record.number("limit-two", table.rows[1][1].value, 4);
  const auto largest_error = [](auto step) {
    return measure::largest_error(step, drone, frame, turn).position;
  };
  record.number("slide-off", 1000 * largest_error(slide), 2, "mm");
  record.number("backward-off", 100 * largest_error(backward_euler), 3, "cm");
}

void cloths(Record& record) {
  auto& table = record.table("cloths", {{"t", "s"}, {"backward Euler"}, {"BDF2"}, {"in substeps"}});
  StruckCloths struck(light_k, frame, Blow{});
  for (int n = 0; n <= 180; ++n) {
    const auto [solved, remembered, stepped] = struck.energies();
    table.add({n * frame, solved, remembered, stepped});
    struck.frame();
  }
  const auto left = [&](const char* name, double share) {
    record.number(name, 100 * share, 2, "%");
  };
  const auto half = cloths_after(30), second = cloths_after(60);
  left("cloths-half-backward", half[0]);
  left("cloths-half-bdf2", half[1]);
  left("cloths-second-backward", second[0]);
  left("cloths-second-bdf2", second[1]);
  left("cloths-second-twice", cloths_after(120, frame / 2)[0]);
  record.number("cloths-side", StruckCloths::side, whole);
  record.number("cloths-substeps", struck.substeps(), whole);
  record.number("cloths-speed", Blow{}.speed, whole, "m/s");
}

void ringing(Record& record) {
  measure::path(record, "ring-trapezoid", trapezoid, bar, frame, 1);
  measure::path(record, "ring-backward", backward_euler, bar, frame, 1);
  record.number("ring-left", 100 * measure::spectral_radius(trapezoid, bar, frame), 3, "%");
  record.number("ring-true", 100 * std::exp(-bar.zeta * bar.omega * frame), 2, "%");
  const double late = measure::spectral_radius(trapezoid, bar, frame);
  record.number("ring-tenth", std::log(0.1) / std::log(late) * frame, 2, "s");
}

}  // namespace

int main(int argc, char** argv) {
  return measure::record(argc, argv, [](Record& record) {
    opening(record);
    from_the_end(record);
    derived(record);
    called(record);
    matrices(record);
    costs(record);
    record_substeps_and_iterations(record);
    record_visible_errors(record);
    costs_on_a_nail(record);
    predictors(record);
    a_second(record);
    hard_blows(record);
    newton(record);
    cloths(record);
    ringing(record);
    soft_damping(record);
  });
}
