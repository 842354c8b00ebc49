// SPDX-License-Identifier: MIT-0
// Chapter 4: implicit methods, from a bar that cannot be held to a body thrown into the air.
#include <algorithm>
#include <cmath>
#include <string>

#include "bar.h"
#include "integrate/dense_system.h"
#include "measure/cost.h"
#include "measure/energy.h"
#include "measure/error.h"
#include "measure/implicit_methods.h"
#include "measure/linear_methods.h"
#include "measure/path.h"
#include "measure/record.h"
#include "measure/stability.h"
#include "parachute.h"
#include "slide.h"
#include "soft.h"
#include "struck.h"
#include "thrown.h"
#include "work.h"

using measure::backward_euler;
using measure::euler;
using measure::Record;
using measure::rk4;
using measure::symplectic_euler;
using measure::trapezoid;
using measure::whole;

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
               away(backward_euler, n)});
  }
  // [bar]
  constexpr double light_year = 9.4607e15;  // m
  record.number("bar-euler", away(euler, 10) / 1000, 2, "km");
  record.number("bar-symplectic", away(symplectic_euler, 10) / light_year, 2, "light-years");
  record.number("bar-rk4", away(rk4, 10) / light_year / 1e6, 2, "million light-years");
  record.number("bar-backward", 1e9 * away(backward_euler, 4), 2, "nm");
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
  table.add({s.x.x(), s.x.y()});
  integrate::backward_euler_spring(s.x, s.v, 1.0, drone.omega, 0.0);
  table.add({s.x.x(), s.x.y()});
  record.number("one-step", s.x.norm(), 3, "m");
  const auto out = [](auto step, long steps) {
    return measure::after(step, drone, drone.start(), frame, steps).x.norm();
  };
  record.number("drone-1", out(backward_euler, turn), 3, "m");
  record.number("drone-10", out(backward_euler, 10 * turn), 3, "m");
  record.number("naive-10", out(measure::predicted_euler<1>, 10 * turn), 3, "m");
}

void matrices(Record& record) {
  const auto pattern = [&](const char* name, const Sparse& matrix) {
    auto& table = record.table(name, {{"column", "", whole}, {"row", "", whole}});
    for (int j = 0; j < matrix.cols(); ++j) {
      for (Sparse::InnerIterator entry(matrix, j); entry; ++entry) {
        table.add({double(j), double(entry.row())});
      }
    }
    record.number(std::string(name) + "-entries", double(matrix.nonZeros()), whole);
  };
  pattern("chain", step_matrix_of(chain));
  pattern("rope", step_matrix_of(rope));
  pattern("cloth", step_matrix_of(cloth));
  pattern("factor", factor_of(step_matrix_of(cloth)));
  record.number("unknowns", double(chain.count), whole);
}

void costs(Record& record) {
  auto& table = record.table("work", {{"scene"},
                                      {"unknowns", "", whole},
                                      {"entries of the factor, each", "", 2},
                                      {"solving", "", 2},
                                      {"substeps", "", whole},
                                      {"all substeps", "", 2}});
  const auto add = [&](const std::string& name, const auto& scene, const auto& tallied) {
    const double n = double(scene.start().x.size());
    const int substeps = substeps_for(scene);
    table.add({name, n, double(factor_of(step_matrix_of(scene)).nonZeros()) / n,
               work_of_step(tallied) / n, double(substeps),
               substeps * work_of_substep(tallied) / n});
  };
  for (const int count : {108, 972, 10'092}) {
    add("chain", chain_of(count), chain_of<Tallied>(count));
  }
  for (const int count : {36, 324, 3364}) {
    add("rope", rope_of(count), rope_of<Tallied>(count));
  }
  for (const int side : {6, 10, 18, 32, 58}) {
    const std::string sides = std::to_string(side);
    add("cloth " + sides + " × " + sides, cloth_of(side), cloth_of<Tallied>(side));
  }
  const auto ratio = [&](std::size_t row) {
    return table.rows[row][5].value / table.rows[row][3].value;
  };
  record.number("chain-wins", ratio(0), 2);
  record.number("rope-wins", ratio(3), 2);
  record.number("cloth-loses", 1 / ratio(10), 2);
  record.number("factor-small", table.rows[6][2].value, 2);
  record.number("factor-large", table.rows[10][2].value, 2);
}

void predictors(Record& record) {
  auto& table =
      record.table("corrections", {{"corrections", "", whole}, {"drag"}, {"undamped spring"}});
  // [corrections]
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
  // [corrections]
  record.number("limit-two", table.rows[1][1].value, 4);
  const auto off = [](auto step) {
    return measure::largest_error(step, drone, frame, turn).position;
  };
  record.number("slide-off", 1000 * off(slide), 2, "mm");
  record.number("backward-off", 100 * off(backward_euler), 3, "cm");
}

void a_second(Record& record) {
  auto& table = record.table("second", {{"t", "s"}, {"chain"}, {"rope"}, {"cloth"}, {"1 Hz"}});
  const auto c = shares(chain, gentle, 60, solved_once), r = shares(rope, gentle, 60, solved_once);
  const auto cl = shares(cloth, gentle, 60, solved_once);
  for (std::size_t n = 0; n <= 60; ++n) {
    const double left = std::pow(left_in_a_step(frame * swinging(1).omega), double(n));
    table.add({frame * double(n), c[n], r[n], cl[n], left});
  }
  record.number("second-chain", c[60], 1);
  record.number("first-chain", 100 * c[1], 2, "%");
  record.number("second-rope", 100 * r[60], 2, "%");
  record.number("second-cloth", 100 * cl[60], 2, "%");
  const auto left = [](const scenes::Spring<>& spring) {
    return 100 * std::pow(left_in_a_step(frame * spring.omega), 60);
  };
  record.number("second-1hz", left(swinging(1)), 2, "%");
  record.number("second-2hz", left(swinging(2)), 2, "%");
  record.number("second-suspension", left(suspension), 2, "%");
}

void newton(Record& record) {
  auto& blow = record.table(
      "blow", {{"t", "s"}, {"one solve"}, {"to the end"}, {"trapezoid"}, {"trapezoid end"}});
  const auto trapezoid_once = [](Struck& s, const auto& scene, auto& system) {
    return integrate::trapezoid(s.x, s.v, 0.0, frame, scene, system);
  };
  const auto trapezoid_end = [](Struck& s, const auto& scene, auto& system) {
    return integrate::trapezoid_newton(s.x, s.v, 0.0, frame, scene, system, largest, tolerance) > 0;
  };
  const auto once = shares(rope, hard, 60, solved_once), end = shares(rope, hard, 60, to_the_end);
  const auto trap = shares(rope, hard, 60, trapezoid_once);
  const auto trap_end = shares(rope, hard, 60, trapezoid_end);
  for (std::size_t n = 0; n <= 60; ++n) {
    blow.add({frame * double(n), once[n], end[n], trap[n], trap_end[n]});
  }
  record.number("blow-once", *std::max_element(once.begin(), once.end()), 3);
  record.number("blow-end", end[60], 2);
  record.number("blow-trapezoid", trap[60], 2);
  const auto cloth_trap = shares(cloth, hard, 60, trapezoid_once);
  record.number("blow-trapezoid-cloth", cloth_trap.back(), 2);

  auto& table = record.table("newton", {{"iteration", "", whole},
                                        {"parachute", "m/s", 2},
                                        {"rope, gentle", "m/s", 2},
                                        {"rope, hard", "m/s", 2},
                                        {"cloth, hard", "m/s", 2}});
  const std::vector<double> all[] = {changes_of_parachute(), changes(rope, gentle),
                                     changes(rope, hard), changes(cloth, hard)};
  for (std::size_t n = 0; n < all[3].size(); ++n) {
    std::vector<measure::Cell> row{double(n + 1)};
    for (const auto& one : all) row.push_back(n < one.size() ? one[n] : NAN);
    table.add(row);
  }
  const char* names[] = {"parachute", "rope-gentle", "rope-hard", "cloth-hard"};
  for (int i = 0; i < 4; ++i) {
    record.number(std::string("iterations-") + names[i], double(all[i].size()), whole);
  }
}

void where_it_pays(Record& record) {
  auto& soft = record.table("soft", {{"hω"}, {"asked 0"}, {"asked 0.2"}, {"asked 0.7"}});
  for (int tenths = 1; tenths <= 30; ++tenths) {
    const auto got = [&](double zeta) {
      return moved(soft_step, {.omega = tenths / 10.0 / frame, .zeta = zeta}, frame).zeta;
    };
    soft.add({tenths / 10.0, got(0), got(0.2), got(0.7)});
  }
  for (const int rate : {30, 60, 240}) {
    const auto got = moved(soft_step, swinging(5), 1.0 / rate);
    record.number("soft-" + std::to_string(rate), got.zeta, 2);
  }

  auto& spin = record.table("spin", {{"t", "s"},
                                     {"Euler"},
                                     {"backward Euler"},
                                     {"trapezoid"},
                                     {"backward Euler turns", "rad/s"},
                                     {"true", "rad/s"}});
  const Thrown body;
  auto e = body.start(), b = body.start(), tr = body.start(), fine = body.start();
  const double first = body.energy(e.v);
  for (int n = 0; n <= 600; ++n) {
    spin.add({n * frame, body.energy(e.v) / first, body.energy(b.v) / first,
              body.energy(tr.v) / first, b.v.y(), fine.v.y()});
    euler(e.x, e.v, 0.0, frame, body);
    backward_euler(b.x, b.v, 0.0, frame, body);
    trapezoid(tr.x, tr.v, 0.0, frame, body);
    fine = measure::after(rk4, body, fine, frame / 20, 20);
  }
  const auto blown = std::find_if(spin.rows.begin(), spin.rows.end(),
                                  [](const auto& row) { return !(row[1].value < 1e6); });
  record.number("spin-euler", blown->at(0).value, 2, "s");
  record.number("spin-second", 100 * spin.rows[60][2].value, 2, "%");
  record.number("spin-five", 100 * spin.rows[300][2].value, 2, "%");
  const auto over = std::find_if(spin.rows.begin(), spin.rows.end(),
                                 [](const auto& row) { return row[5].value < 0; });
  record.number("spin-over", over->at(0).value, 2, "s");
}

void ringing(Record& record) {
  measure::path(record, "ring-trapezoid", trapezoid, bar, frame, 0.6);
  measure::path(record, "ring-backward", backward_euler, bar, frame, 0.6);
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
    matrices(record);
    costs(record);
    predictors(record);
    a_second(record);
    newton(record);
    where_it_pays(record);
    ringing(record);
  });
}
