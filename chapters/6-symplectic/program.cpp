// SPDX-License-Identifier: MIT-0
// Chapter 6: symplectic Euler, one scene after the other.
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <vector>

#include "ball.h"
#include "cats.h"
#include "drag.h"
#include "kicks.h"
#include "measure/energy.h"
#include "measure/methods.h"
#include "measure/order.h"
#include "measure/path.h"
#include "measure/stability.h"
#include "pair.h"
#include "planets.h"
#include "precession.h"
#include "shadow.h"
#include "spin_ball.h"
#include "thrown.h"
#include "tumbling.h"
#include "uneven.h"

using measure::euler;
using measure::Record;
using measure::symplectic_euler;
using measure::whole;

namespace {

void an_hour(Record& record) {
  auto& table = record.table("hour", {{"minute"}, {"Euler", "m"}, {"symplectic Euler", "m"}});
  auto s = drone.start(), swapped = drone.start();
  double nearest = INFINITY, farthest = 0;
  constexpr long hour = 3600 * 60;  // steps
  for (long n = 0; n <= hour; ++n) {
    nearest = std::min(nearest, swapped.x.norm());
    farthest = std::max(farthest, swapped.x.norm());
    if (n % 3600 == 0) table.add({double(n) / 3600, s.x.norm(), swapped.x.norm()});
    euler(s.x, s.v, 0.0, frame, drone);
    symplectic_euler(swapped.x, swapped.v, 0.0, frame, drone);
  }
  constexpr double moon = 384'400'000;  // m
  record.number("moon", moon, 4, "m");
  record.number("hour-euler", table.rows.back()[1].value / 1e9, 3, "million km");
  record.number("hour-moons", table.rows.back()[1].value / moon, 2);
  record.number("hour-nearest", nearest, 4, "m");
  record.number("hour-farthest", farthest, 4, "m");
}

void shadow(Record& record) {
  const auto energy = [](double x, double v) { return undamped_suspension.energy(x, v); };
  const auto shadow = shadow_energy(undamped_suspension, frame);
  const double full = energy(undamped_suspension.x0, 0);
  auto& wobble = record.table("wobble", {{"t", "s"}, {"Euler"}, {"symplectic Euler"}, {"shadow"}});
  auto s = undamped_suspension.start(), grown = undamped_suspension.start();
  for (int n = 0; n <= 60; ++n) {
    wobble.add({n * frame, energy(grown.x, grown.v) / full, energy(s.x, s.v) / full,
                shadow(s.x, s.v) / full});
    euler(grown.x, grown.v, 0.0, frame, undamped_suspension);
    symplectic_euler(s.x, s.v, 0.0, frame, undamped_suspension);
  }
  double least = 1, most = 1;
  measure::run(symplectic_euler, undamped_suspension, s, frame, 60'000,
               [&](double, const auto& now) {
                 least = std::min(least, energy(now.x, now.v) / full);
                 most = std::max(most, energy(now.x, now.v) / full);
               });
  record.number("wobble-least", 100 * least, 3, "%");
  record.number("wobble-most", 100 * most, 3, "%");

  measure::path(record, "ellipse", symplectic_euler, undamped_suspension, 2 * frame, 1.5);
  measure::path(record, "ellipse-twin", measure::symplectic_euler_position_first,
                undamped_suspension, 2 * frame, 1.5);
  for (const int percent : {67, 150, 190, 210}) {
    measure::path(record, "opening-" + std::to_string(percent), symplectic_euler,
                  undamped_suspension, percent / 100.0 / undamped_suspension.omega,
                  percent > 200    ? 0.7
                  : percent == 190 ? 10
                                   : 6);
  }
  record.number("limit",
                measure::stability_limit(symplectic_euler, undamped_suspension, 0.01, 1.0) * 1000,
                4, "ms");

  for (const double homega : {1.9, 1.99}) {
    const double step = homega / undamped_suspension.omega;
    record.number("swing-" + std::to_string(std::lround(100 * homega)),
                  swing(undamped_suspension, step, 100'000) / undamped_suspension.x0, 2);
  }

  const auto angle = std::arg(
      measure::eigenvalues(measure::step_matrix(symplectic_euler, undamped_suspension, frame))[0]);
  const double fast = std::abs(angle) / (frame * undamped_suspension.omega);
  record.number("clock-fast", 100 * (fast - 1), 2, "%");
  record.number("clock-minute",
                60 * undamped_suspension.omega * (fast - 1) / (2 * std::numbers::pi), 2);
}

/// The velocities of leapfrog on the suspension between the kicks, and the true one.
void kicks(Record& record) {
  auto& table = record.table(
      "kicks", {{"t", "s"}, {"before", "m/s"}, {"after", "m/s"}, {"velocity Verlet", "m/s"}});
  for (const Kick& kick : kicks_of(undamped_suspension, 2 * frame, 10))
    table.add({kick.t, kick.before, kick.after, kick.verlet});
  auto& truth = record.table("kicks-exact", {{"t", "s"}, {"v", "m/s"}});
  for (int n = 0; n <= 110; ++n) {
    const double t = n * frame / 5;
    truth.add({t, undamped_suspension.exact(t).v});
  }
}

void half_a_kick(Record& record) {
  auto& table = record.table("half", {{"steps per second", "", whole},
                                      {"as it is", "m"},
                                      {"order"},
                                      {"half a kick back", "m"},
                                      {"its order"}});
  const auto plain = measure::halvings(symplectic_euler, drone, 1.0 / 15, 8.0, 5);
  const auto started = measure::halvings(measure::leapfrog, drone, 1.0 / 15, 8.0, 5);
  for (std::size_t i = 0; i < plain.size(); ++i) {
    table.add({1 / plain[i].h, plain[i].error.position, plain[i].position_order,
               started[i].error.position, started[i].position_order});
  }
  record.number("drone-error", 100 * plain[2].error.position, 2, "cm");
  record.number("drone-error-rk4",
                1e6 * measure::largest_error(measure::rk4, drone, 4 * frame, 120).position, 2,
                "µm");
}

/// The largest error of the suspension in a second, at a price per second.
template <class Step>
double error_of_a_second(Step step, double zeta, int evaluations, int evaluations_per_step) {
  scenes::Spring<> spring = undamped_suspension;
  spring.zeta = zeta;
  const long steps = evaluations / evaluations_per_step;
  return measure::largest_error(step, spring, 1.0 / double(steps), steps).position;
}

void composition(Record& record) {
  auto& table = record.table("composition", {{"evaluations per second", "", whole},
                                             {"symplectic Euler", "m"},
                                             {"velocity Verlet", "m"},
                                             {"Yoshida 4", "m"},
                                             {"RK4", "m"},
                                             {"velocity Verlet damped", "m"},
                                             {"Yoshida 4 damped", "m"}});
  for (int price = 120; price < 10'000; price *= 2) {
    table.add({double(price), error_of_a_second(symplectic_euler, 0, price, 1),
               error_of_a_second(measure::velocity_verlet, 0, price, 1),
               error_of_a_second(measure::yoshida4, 0, price, 3),
               error_of_a_second(measure::rk4, 0, price, 4),
               error_of_a_second(measure::velocity_verlet, 0.1, price, 1),
               error_of_a_second(measure::yoshida4, 0.1, price, 3)});
  }
  const double limit = measure::stability_limit(measure::yoshida4, scenes::Spring<>{}, 0.01, 10.0);
  record.number("yoshida-limit", limit, 4);
  record.number("yoshida-share", limit / 3, 2);
}

}  // namespace

int main(int argc, char** argv) {
  return measure::record(argc, argv, [](Record& record) {
    an_hour(record);
    cats(record);
    shadow(record);
    uneven_steps(record);
    kicks(record);
    half_a_kick(record);
    bounces(record);
    orbit(record);
    damped_limits(record);
    six_ways(record);
    thrown_pair(record);
    tumbling(record);
    thrown_crate(record);
    record_free_rigid_body(record);
    spin_ball(record);
    composition(record);
    planets(record);
  });
}
