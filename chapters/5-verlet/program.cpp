// SPDX-License-Identifier: MIT-0
// Chapter 5: Verlet, one scene after the other.
#include <algorithm>
#include <cmath>
#include <string>

#include "float_digits.h"
#include "jitter_runs.h"
#include "measure/energy.h"
#include "measure/methods.h"
#include "measure/order.h"
#include "measure/path.h"
#include "measure/stability.h"
#include "rope_runs.h"
#include "toys.h"
#include "two_ropes.h"
#include "verlet_starts.h"
#include "wheel_runs.h"

using measure::leapfrog;
using measure::Record;
using measure::stormer_verlet;
using measure::velocity_verlet;
using measure::whole;

namespace {

void one_step(Record& record) {
  auto& dots = record.table("two-dots", {{"t", "s"}, {"x", "m"}, {"y", "m"}});
  const scenes::Projectile<> ball{.start_velocity = {4, 5}};
  auto s = ball.start();
  measure::run(stormer_verlet, ball, s, 0.25, 4,
               [&](double t, const auto& now) { dots.add({t, now.x.x(), now.x.y()}); });
}

void starts(Record& record) {
  auto& table = record.table("starts", {{"steps per second", "", whole},
                                        {"drone x", "m"},
                                        {"swing x", "m"},
                                        {"drone x − hv", "m"},
                                        {"drone x − hv + h²a/2", "m"}});
  for (int rate = 15; rate <= 960; rate *= 2) {
    const auto error = [&](auto step, const auto& scene, int seconds) {
      return measure::largest_error(step, scene, 1.0 / rate, rate * seconds).position;
    };
    table.add({double(rate), error(from_rest, drone, 8), error(from_rest, swing, 8),
               error(by_velocity, drone, 8), error(stormer_verlet, drone, 8)});
    if (rate != 60) continue;
    record.number("start-x", table.rows.back()[1].value, 3, "m");
    record.number("start-velocity", 100 * table.rows.back()[3].value, 3, "cm");
    record.number("start-right", 1000 * table.rows.back()[4].value, 3, "mm");
  }
}

void moments(Record& record) {
  measure::exact_path(record, "swing-exact", swing, 1.25);
  auto& table = record.table("moments", {{"t", "s"},
                                         {"half a step ago", "s"},
                                         {"last distance over h", "m/s"},
                                         {"velocity Verlet", "m/s"}});
  constexpr double h = 1.0 / 12;
  auto s = swing.start(), estimated = swing.start();
  std::vector<double> velocities;
  measure::run(velocity_verlet, swing, s, h, 15,
               [&](double, const auto& now) { velocities.push_back(now.v); });
  std::size_t n = 0;
  measure::run(stormer_verlet, swing, estimated, h, 15, [&](double t, const auto& now) {
    if (n > 0) table.add({t, t - h / 2, now.v, velocities[n]});
    ++n;
  });
  const scenes::LinearDrag<> fall{.c = 0};
  const auto late = measure::after(stormer_verlet, fall, fall.start(), frame, 60);
  record.number("late", 100 * (late.v - fall.exact(1).v), 2, "cm/s");
}

void orders(Record& record) {
  auto& table = record.table("orders", {{"method"},
                                        {"position"},
                                        {"velocity"},
                                        {"position with drag"},
                                        {"velocity with drag"},
                                        {"ch below"}});
  const auto row = [&](const char* name, auto step) {
    const auto spring = measure::halvings(step, scenes::Spring<>{.omega = 3, .x0 = 0.4, .v0 = 1.3},
                                          1.0 / 32, 4.0, 5);
    const auto drag = measure::halvings(step, leaf, 1.0 / 32, 4.0, 5);
    const scenes::LinearDrag<> linear{.c = 1, .g = 0};
    table.add({name, spring.back().position_order, spring.back().velocity_order,
               drag.back().position_order, drag.back().velocity_order,
               measure::stability_limit(step, linear, 0.1, 10.0)});
  };
  row("position Verlet", stormer_verlet);
  row("carrying a", measure::stormer_verlet_carried);
  row("leapfrog", leapfrog);
  row("velocity Verlet", velocity_verlet);
  record.number("float-swings", swings_tried, whole);
  record.number("float-position", 1e6 * lost_digits(stormer_verlet), 1, "µm");
  record.number("float-distance", 1e6 * lost_digits(measure::stormer_verlet_distance), 1, "µm");
  record.number("float-velocity", 1e6 * lost_digits(velocity_verlet), 1, "µm");
}

void price(Record& record) {
  auto& table = record.table("price", {{"method"},
                                       {"steps per second", "", whole},
                                       {"error of a turn", "m"},
                                       {"energy after an hour", "%", 6}});
  const auto row = [&](const char* name, auto step, int rate) {
    const auto energy = [](auto& x, auto& v) { return drone.energy(x, v); };
    table.add({name, double(rate),
               measure::largest_error(step, drone, 1.0 / rate, 8 * rate).position,
               100 + 100 * measure::drift(step, drone, 1.0 / rate, 3600 * rate, energy).last});
  };
  row("symplectic Euler", measure::symplectic_euler, 60);
  row("velocity Verlet", velocity_verlet, 60);
  row("midpoint", measure::midpoint, 30);
  row("RK4", measure::rk4, 15);
}

void drag(Record& record) {
  auto& table = record.table("limits", {{"zeta"}, {"position Verlet"}, {"velocity Verlet"}});
  for (int i = 0; i <= 20; ++i) {
    const scenes::Spring<> spring{.zeta = i / 10.0};
    table.add({i / 10.0, measure::stability_limit(stormer_verlet, spring, 1e-3, 4.0),
               measure::stability_limit(velocity_verlet, spring, 1e-3, 4.0)});
  }
  record.number("camera-position", table.rows[10][1].value, 3);
  record.number("camera-velocity", table.rows[10][2].value, 3);
  for (const int rate : {30, 60, 144}) {
    record.number("factor-" + std::to_string(rate), 100 * braked(rate), 3, "%");
  }
}

/// A rope with a weight of ten points falls over a peg: eight pulls a frame, spent in two ways.
void two_ropes(Record& record) {
  auto& paths = record.table(
      "two-weights",
      {{"t", "s"}, {"x", "m"}, {"y", "m"}, {"x in substeps", "m"}, {"y in substeps", "m"}});
  auto& shapes = record.table(
      "two-ropes", {{"x", "m"}, {"y", "m"}, {"x in substeps", "m"}, {"y in substeps", "m"}});
  const int pulls = 8;
  RopeWithWeight iterated = level_rope(10), stepped = iterated;
  double iterated_most = 0, stepped_most = 0;
  for (int n = 0; n <= 120; ++n) {
    const Vec a = iterated.x.back(), b = stepped.x.back();
    if (n <= 42) paths.add({n * frame, a.x(), a.y(), b.x(), b.y()});
    if (n == 42) {
      for (std::size_t i = 0; i < iterated.x.size(); ++i) {
        shapes.add({iterated.x[i].x(), iterated.x[i].y(), stepped.x[i].x(), stepped.x[i].y()});
      }
      record.number("weight-after", n * frame, 2, "s");
    }
    iterated_most = std::max(iterated_most, iterated.stretch());
    stepped_most = std::max(stepped_most, stepped.stretch());
    iterated.frame_of(iterated.x[0], 1, pulls);
    stepped.frame_of(stepped.x[0], pulls, 1);
  }
  record.number("weight-falls", 100 * iterated_most, 2, "%");
  record.number("weight-falls-substeps", 100 * stepped_most, 2, "%");
  record.number("weight-pulls", pulls, measure::whole);
  record.number("weight-hangs", 100 * hanging_with_weight(10, 1, pulls), 2, "%");
  record.number("weight-hangs-substeps", 100 * hanging_with_weight(10, pulls, 1), 2, "%");
  record.number("peg-radius", iterated.radius, 2, "m");
  record.number("peg-height", iterated.peg.y(), 2, "m");
}

}  // namespace

int main(int argc, char** argv) {
  return measure::record(argc, argv, [](Record& record) {
    burst(record);
    one_step(record);
    starts(record);
    moments(record);
    orders(record);
    price(record);
    drag(record);
    jitter(record);
    ropes(record);
    links_of_a_rope(record);
    two_ropes(record);
    wheels(record);
  });
}
