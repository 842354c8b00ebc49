// SPDX-License-Identifier: MIT-0
// Chapter 2: Euler's method, one scene after the other.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "../cast.h"
#include "blob.h"
#include "hitch.h"
#include "machines.h"
#include "measure/energy.h"
#include "measure/fewest_steps.h"
#include "measure/methods.h"
#include "measure/order.h"
#include "measure/path.h"
#include "measure/stability.h"
#include "planets.h"

using measure::euler;
using measure::Record;
using measure::whole;
using scenes::State;

namespace {

void spiral(Record& record) {
  auto& path = record.table("spiral", {{"t", "s"}, {"x", "m"}, {"y", "m"}, {"distance", "m", 4}});
  auto s = drone.start();
  measure::run(euler, drone, s, frame, 10 * turn, [&](double t, const auto& now) {
    path.add({t, now.x.x(), now.x.y(), now.x.norm()});
  });
  const auto once = measure::after(euler, drone, drone.start(), frame, turn);
  record.number("distance-1", once.x.norm(), 4, "m");
  record.number("distance-10", s.x.norm(), 4, "m");
  record.number("circle", drone.radius, 2, "m");
  record.number("fence", fence, 2, "m");

  double nearest = INFINITY, farthest = 0;
  s = drone.start();
  measure::run(measure::symplectic_euler, drone, s, frame, 10 * turn, [&](double, const auto& now) {
    nearest = std::min(nearest, now.x.norm());
    farthest = std::max(farthest, now.x.norm());
  });
  record.number("swapped-nearest", nearest, 4, "m");
  record.number("swapped-farthest", farthest, 4, "m");

  record.number("drone-angle", frame * drone.omega, 3);
  auto& coarse = record.table("tangent", {{"t", "s"}, {"x", "m"}, {"y", "m"}});
  s = drone.start();
  measure::run(euler, drone, s, 1.0, 4,
               [&](double t, const auto& now) { coarse.add({t, now.x.x(), now.x.y()}); });
}

void energy(Record& record) {
  const auto drone_energy = [](auto& x, auto& v) { return drone.energy(x, v); };
  const double growth = 1 + std::pow(frame * drone.omega, 2);
  record.number("growth-step", growth, 8);
  record.number("growth-minute", std::pow(growth, 3600), 4);
  record.number("growth-240",
                1 + measure::drift(euler, drone, frame / 4, 4 * 3600, drone_energy).last, 4);
  record.number("growth-measured", 1 + measure::drift(euler, drone, frame, 3600, drone_energy).last,
                4);

  auto& table = record.table("energy", {{"t", "s"}, {"30 Hz"}, {"60 Hz"}, {"120 Hz"}, {"240 Hz"}});
  for (int t = 0; t <= 60; t += 3) {
    std::vector<measure::Cell> row{double(t)};
    for (const int rate : {30, 60, 120, 240}) {
      row.push_back(1 + measure::drift(euler, drone, 1.0 / rate, t * rate, drone_energy).last);
    }
    table.add(row);
  }
}

void order(Record& record) {
  auto& table = record.table("order", {{"steps per second", "", whole},
                                       {"error", "m"},
                                       {"order"},
                                       {"velocity error", "m/s"},
                                       {"velocity order"}});
  for (const auto& row : measure::halvings(euler, drone, 1.0 / 15, 8.0, 8)) {
    table.add({1 / row.h, row.error.position, row.position_order, row.error.velocity,
               row.velocity_order});
  }
  record.number("error-60", table.rows[2][1].value, 3, "m");
  const auto rate_for_a_centimetre = [](double seconds) {
    return double(measure::fewest_steps(euler, drone, seconds, 0.01)) / seconds;
  };
  record.number("rate-for-one-turn", rate_for_a_centimetre(8), 3);
  record.number("rate-for-ten-turns", rate_for_a_centimetre(80), 3);
}

void springs(Record& record) {
  const auto energy = [](double x, double v) { return undamped_suspension.energy(x, v); };
  const double gain = measure::drift(euler, undamped_suspension, frame, 60, energy).last;
  record.number("swing-after-a-second", std::sqrt(1 + gain), 3);

  const double limit = measure::stability_limit(euler, suspension, 0.001, 0.1);
  record.number("suspension-limit", 1000 * limit, 4, "ms");
  const double inside = 0.9 * limit, outside = 1.1 * limit;
  measure::path(record, "suspension-inside", euler, suspension, inside, 1.5);
  measure::path(record, "suspension-outside", euler, suspension, outside, 1.5);
  record.number("suspension-inside", 1000 * inside, 1, "ms");
  record.number("suspension-outside", 1000 * outside, 2, "ms");
  record.number("suspension-rate", 1 / limit, 4, "Hz");
  const double at_60 = measure::spectral_radius(euler, suspension, frame);
  record.number("suspension-at-60", std::pow(at_60, 60), 3);
  measure::exact_path(record, "suspension-exact", suspension, 1.5);

  auto& map = record.table("limits", {{"zeta"}, {"limit"}});
  for (double zeta = 0.1; zeta < 3.01; zeta += 0.1) {
    map.add({zeta, measure::stability_limit(euler, scenes::Spring<>{.zeta = zeta}, 1e-6, 10.0)});
  }
}

void stiffness(Record& record) {
  const double limit = measure::stability_limit(euler, door, 0.001, 0.1);
  record.number("door-limit", 1000 * limit, 3, "ms");
  const double inside = 0.95 * limit, outside = 1.05 * limit;
  measure::path(record, "door-inside", euler, door, inside, 2);
  measure::path(record, "door-outside", euler, door, outside, 2);
  record.number("door-inside", 1000 * inside, 3, "ms");
  record.number("door-outside", 1000 * outside, 3, "ms");
  measure::exact_path(record, "door-exact", door, 2);

  auto& table = record.table("stiffness", {{"ω", "rad/s", whole},
                                           {"ζ", "", whole},
                                           {"still open after 1 s"},
                                           {"steps per second needed", "", whole}});
  for (const double zeta : {5.0, 10.0, 20.0, 40.0}) {
    const scenes::Spring<> closer{.omega = 2 * zeta, .zeta = zeta, .x0 = 1};
    const double step = measure::stability_limit(euler, closer, 1e-6, 1.0);
    table.add({closer.omega, zeta, closer.exact(1).x, std::ceil(1 / step)});
  }
}

void drag(Record& record) {
  for (const double ch : {0.5, 1.5, 2.1}) {
    const std::string name = "drag-" + std::to_string(std::lround(10 * ch));
    measure::path(record, name, euler, leaf, ch / leaf.c, 9);
  }
  record.number("terminal-speed", leaf.g / leaf.c, 4, "m/s");
  const auto end = measure::after(euler, leaf, leaf.start(), frame, 60 * 60);
  record.number("terminal-speed-euler", -end.v, 4, "m/s");

  const State<double> diver{0, diving};
  record.number("diver-after-one-step", measure::after(euler, parachute, diver, 0.1, 1).v, 3,
                "m/s");
  record.number("diver-at-60", -measure::after(euler, parachute, diver, frame, 1).v, 3, "m/s");
  record.number("diver-true", -measure::after(euler, parachute, diver, frame / 1e5, 100'000).v, 3,
                "m/s");
}

void machines(Record& record) {
  auto& table =
      record.table("machines", {{"rate", "Hz", whole}, {"t", "s"}, {"lerp", "m"}, {"exact", "m"}});
  for (const double rate : {30.0, 60.0, 144.0}) {
    after_a_jump(rate, 1, [&](const auto& machine) {
      table.add({rate, double(machine.shown) / rate, 10 - machine.lerp, 10 - machine.exact});
    });
  }
  record.number("lerp-60", left_by_lerp(60), 2, "m");
  after_a_jump(60, 15, [&](const auto& machine) {
    if (machine.shown == 30) record.number("lerp-late", 10 - machine.lerp, 2, "m");
  });
}

void constant_force(Record& record) {
  for (const int rate : {15, 30, 60}) {
    const double top = measure::after(euler, jump, jump.start(), 1.0 / rate, rate).x.y();
    record.number("jump-error-" + std::to_string(rate), 100 * (top - jump.exact(1).x.y()), 4, "cm");
  }
}

}  // namespace

int main(int argc, char** argv) {
  return measure::record(argc, argv, [](Record& record) {
    spiral(record);
    energy(record);
    order(record);
    springs(record);
    blobs(record);
    stiffness(record);
    drag(record);
    cameras(record);
    machines(record);
    constant_force(record);
    planets(record);
  });
}
