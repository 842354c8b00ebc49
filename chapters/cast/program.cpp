// SPDX-License-Identifier: MIT-0
// The numbers of the cast, as they stand in cast.h, and what its pictures are drawn from.
#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "../cast_of_many.h"
#include "measure/methods.h"
#include "measure/path.h"
#include "measure/record.h"
#include "measure/run.h"

using measure::Record;
using measure::whole;

namespace {

/// The path of something in the plane, in 240 equal parts.
template <class Scene>
void way(Record& record, const std::string& name, const Scene& scene, double duration,
         double begin = 0) {
  auto& table = record.table(name, {{"t", "s"}, {"x", "m"}, {"y", "m"}});
  for (int i = 0; i <= 240; ++i) {
    const double t = begin + duration * i / 240;
    const Eigen::Vector2d place = scene.exact(t).x;
    table.add({t, place.x(), place.y()});
  }
}

/// Where a pendulum hangs at some moments of half a swing.
void moments(Record& record, const std::string& name, const scenes::Pendulum<>& pendulum) {
  auto& table = record.table(name, {{"t", "s"}, {"x", "m"}, {"y", "m"}});
  for (int i = 0; i <= 8; ++i) {
    const double t = pendulum.period() / 2 * i / 8;
    const double angle = pendulum.exact(t).x;
    table.add({t, pendulum.length * std::sin(angle), -pendulum.length * std::cos(angle)});
  }
}

void thrown(Record& record) {
  record.number("frame", 1000 * frame, 3, "ms");
  const double up = jump.start_velocity.y(), across = running_jump.start_velocity.x();
  record.number("jump-speed", up, 1, "m/s");
  record.number("jump-top", up * up / (2 * jump.g), 3, "m");
  record.number("running-speed", across, 1, "m/s");
  way(record, "jump", jump, 2 * up / jump.g);
  way(record, "running-jump", running_jump, 2 * up / jump.g);

  const Eigen::Vector2d shot = cannonball.start_velocity;
  record.number("cannonball-speed", shot.norm(), 2, "m/s");
  record.number("cannonball-across", shot.x(), 2, "m/s");
  way(record, "cannonball", cannonball, 2 * shot.y() / cannonball.g);

  record.number("leaf-drag", leaf.c, 1);
  record.number("leaf-terminal", leaf.terminal_speed(), 3, "m/s");
  measure::exact_path(record, "leaf", leaf, 2);

  record.number("parachute-terminal", std::sqrt(parachute.g / parachute.k), 1, "m/s");
  record.number("diving", -diving, 2, "m/s");
  auto& braking = record.table("parachute", {{"t", "s"}, {"speed", "m/s"}});
  scenes::State<double> diver{0, diving};
  measure::run(measure::rk4, parachute, diver, 1e-3, 1500,
               [&](double t, const auto& now) { braking.add({t, -now.v}); });
  record.number("diving-half", braking.rows[500][1].value, 2, "m/s");
}

void rockets(Record& record) {
  record.number("rocket-mass", rocket.mass, 1, "kg");
  record.number("rocket-thrust", rocket.thrust, 2, "N");
  record.number("rocket-burn", 1000 * rocket.burn, 3, "g/s");
  record.number("rocket-time", rocket.burn_time, 1, "s");
  record.number("rocket-off-beat", off_beat_rocket.burn_time, 5, "s");
  measure::exact_path(record, "rocket", rocket, rocket.burn_time);
  auto& off_beat = record.table("off-beat", {{"t", "s"}, {"x", "m"}});
  for (const double t : {off_beat_rocket.burn_time, rocket.burn_time}) {
    off_beat.add({t, off_beat_rocket.exact(t).x});
  }
}

void spring(Record& record, const std::string& name, const scenes::Spring<>& scene,
            double duration) {
  record.number(name + "-omega", scene.omega, 2, "rad/s");
  record.number(name + "-zeta", scene.zeta, 1);
  measure::exact_path(record, name, scene, duration);
}

void springs(Record& record) {
  spring(record, "suspension", suspension, 1.5);
  spring(record, "undamped", undamped_suspension, 1.5);
  record.number("suspension-out", 100 * suspension.x0, 2, "cm");
  record.number("suspension-swings", suspension.omega / (2 * std::numbers::pi), 2);
  spring(record, "hatch", hatch, 0.5);
  record.number("hatch-open", hatch.x0, 1, "m");
  record.number("hatch-left", 100 * hatch.exact(0.25).x, 2, "cm");
  spring(record, "door", door, 4);
  record.number("door-open", door.x0, 1, "m");
  record.number("door-left", 100 * door.exact(1).x, 2, "cm");
  spring(record, "camera", camera, 0.3);
  record.number("camera-off", camera.x0, 1, "m");
  record.number("camera-left", 100 * camera.exact(0.2).x, 1, "cm");
  spring(record, "bar", bar, 0.06);
  record.number("bar-out", 1000 * bar.x0, 1, "mm");
  record.number("bar-swings", bar.omega / (2 * std::numbers::pi), 2);
}

void pendulums(Record& record) {
  moments(record, "lamp", lamp);
  record.number("lamp-length", lamp.length, 1, "m");
  record.number("lamp-angle", lamp.angle, 1, "rad");
  record.number("lamp-period", lamp.period(), 3, "s");
  moments(record, "wrecking-ball", wrecking_ball);
  record.number("wrecking-ball-length", wrecking_ball.length, 3, "m");
  record.number("wrecking-ball-period", wrecking_ball.period(), 2, "s");
}

void orbit(Record& record, const std::string& name, const scenes::Orbit<>& scene) {
  way(record, name, scene, scene.period());
  record.number(name + "-eccentricity", scene.eccentricity, 2);
  record.number(name + "-length", 2 * scene.semi_major, 2, "m");
  record.number(name + "-nearest", scene.semi_major * (1 - scene.eccentricity), 1, "m");
}

void orbits(Record& record) {
  way(record, "drone", drone, drone.period());
  record.number("drone-radius", drone.radius, 2, "m");
  record.number("drone-turn", drone.period(), 1, "s");
  record.number("drone-frames", turn, whole);
  record.number("drone-fence", fence, 2, "m");
  orbit(record, "shuttle", shuttle);
  orbit(record, "race-shuttle", race_shuttle);
  record.number("shuttle-turn", shuttle_turn, 1, "s");
  orbit(record, "comet", comet);
  record.number("comet-year", comet_year, 2, "s");

  using Planets = scenes::OuterSolarSystem<>;
  std::vector<measure::Column> columns{{"day"}};
  for (int body = 1; body < Planets::bodies; ++body) {
    columns.push_back({std::string(Planets::names[body]) + " x", "AU"});
    columns.push_back({std::string(Planets::names[body]) + " y", "AU"});
  }
  auto& table = record.table("planets", columns);
  auto s = outer_planets.start();
  constexpr double days = 50;
  measure::run(measure::rk4, outer_planets, s, days, 1825, [&](double day, const auto& now) {
    if (std::fmod(day, 5 * days) != 0) return;
    std::vector<measure::Cell> row{day};
    for (int body = 1; body < Planets::bodies; ++body) {
      for (int axis = 0; axis < 2; ++axis) row.push_back(now.x(axis, body) - now.x(axis, 0));
    }
    table.add(row);
  });
  record.number("planets-bodies", Planets::bodies, whole);
  const auto begin = outer_planets.start();
  record.number("planets-jupiter", (begin.x.col(1) - begin.x.col(0)).norm(), 2, "AU");
  record.number("planets-neptune", (begin.x.col(4) - begin.x.col(0)).norm(), 2, "AU");
}

void ropes(Record& record) {
  const auto rope = rope_on_a_nail(1e4);
  record.number("rope-drawn", 1e-3 * rope.k, 2, "kN/m");
  record.number("rope-length", rope.length, 1, "m");
  record.number("rope-beads", rope.count, whole);
  record.number("rope-springs", rope_of_springs.count - 1, whole);
  record.number("rope-bead", 1000 * rope.mass, 2, "g");
  record.number("rope-k", 1e-3 * rope_of_springs.k, 3, "kN/m");
  auto& table = record.table("rope", {{"t", "s"}, {"x", "m"}, {"y", "m"}});
  auto s = rope.start();
  measure::run(measure::symplectic_euler, rope, s, 1e-4, 6000, [&](double t, const auto& now) {
    const double shown = t / 0.12;
    if (std::abs(shown - std::round(shown)) > 1e-6) return;
    for (int i = 0; i < rope.count; ++i) table.add({t, now.x[3 * i], now.x[3 * i + 1]});
  });
}

void nets(Record& record) {
  record.number("bead", 1000 * bead_mass, 2, "g");
  record.number("steel", 1e-3 * steel_k, 2, "kN/m");
  record.number("nets-swings", std::sqrt(steel_k / bead_mass) / (2 * std::numbers::pi), 3);
  record.number("chain-beads", steel_chain.count, whole);
  record.number("rope-of-steel-beads", steel_rope.count, whole);
  record.number("cloth-beads", steel_cloth.side, whole);
  auto& beads = record.table("beads", {{"net"}, {"x", "m"}, {"y", "m"}, {"held", "", whole}});
  for (int i = 0; i < steel_chain.count; ++i) beads.add({"chain", i + 1.0, 0.0, 0.0});
  const auto add = [&](const char* name, const auto& net) {
    const auto x = net.start().x;
    for (int i = 0; i < net.nodes(); ++i) {
      // The rope from the side, where all z are 0, and the cloth from above, where all y are.
      beads.add({name, x[3 * i], x[3 * i + 1] - x[3 * i + 2], double(net.held(i))});
    }
  };
  add("rope", steel_rope);
  add("cloth", steel_cloth);
  auto& links =
      record.table("cloth-links", {{"x", "m"}, {"y", "m"}, {"right", "m"}, {"down", "m"}});
  const auto x = steel_cloth.start().x;
  steel_cloth.for_each_link([&](int i, int j, const auto&) {
    links.add({x[3 * i], -x[3 * i + 2], x[3 * j] - x[3 * i], x[3 * i + 2] - x[3 * j + 2]});
  });
}

}  // namespace

int main(int argc, char** argv) {
  return measure::record(argc, argv, [](Record& record) {
    thrown(record);
    rockets(record);
    springs(record);
    pendulums(record);
    orbits(record);
    ropes(record);
    nets(record);
  });
}
