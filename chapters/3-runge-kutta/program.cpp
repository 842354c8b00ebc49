// SPDX-License-Identifier: MIT-0
// Chapter 3: Runge-Kutta, one question after the other.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "blend.h"
#include "burn_areas.h"
#include "burnout.h"
#include "comet.h"
#include "equal_cost.h"
#include "measure/fewest_steps.h"
#include "measure/methods.h"
#include "measure/order.h"
#include "measure/path.h"
#include "measure/times.h"
#include "rest.h"
#include "rk4_energy.h"
#include "single.h"
#include "stability_limits.h"
#include "toys.h"
#include "wrong.h"

using measure::euler;
using measure::midpoint;
using measure::Record;
using measure::rk4;
using measure::whole;

namespace {

void first_try(Record& record) {
  auto& table = record.table("distance", {{"t", "s"},
                                          {"Euler", "m"},
                                          {"old velocity", "m"},
                                          {"Euler at 120 Hz", "m"},
                                          {"midpoint", "m", 8}});
  const auto distance = [](auto step, double step_size, double t) {
    return measure::after(step, drone, drone.start(), step_size, std::lround(t / step_size))
        .x.norm();
  };
  for (int t = 0; t <= 80; ++t) {
    table.add({double(t), distance(euler, frame, t), distance(wrong::old_velocity, frame, t),
               distance(euler, frame / 2, t), distance(midpoint, frame, t)});
  }
  const auto& end = table.rows.back();
  record.number("euler-10", end[1].value, 4, "m");
  record.number("old-10", end[2].value, 4, "m");
  record.number("euler-120-10", end[3].value, 4, "m");
  record.number("midpoint-10", 1000 * (end[4].value - 10), 2, "mm");
  const auto arrived =
      measure::after(midpoint, drone, drone.start(), frame, std::lround(80 / frame));
  const double ahead = std::atan2(arrived.x.y(), arrived.x.x());
  record.number("midpoint-10-ahead", 1000 * ahead * arrived.x.norm(), 3, "mm");
  record.number("rate", 1 / frame, whole, "Hz");
  record.number("rate-twice", 2 / frame, whole, "Hz");
  record.number("circle", drone.radius, 2, "m");

  const scenes::Circle<> demo{.omega = 2 * std::numbers::pi / 4};
  const auto turn_of_demo = [&](auto step) {
    return measure::after(step, demo, demo.start(), 0.01, 400).x.norm();
  };
  record.number("demo-euler", turn_of_demo(euler), 4);
  record.number("demo-old", turn_of_demo(wrong::old_velocity), 4);
  record.number("demo-midpoint", turn_of_demo(midpoint), 7);
}

void one_step(Record& record) {
  auto& table = record.table("middle", {{"x", "m"}, {"y", "m"}, {"u", "m/s"}, {"v", "m/s"}});
  const auto add = [&](const auto& s) { table.add({s.x.x(), s.x.y(), s.v.x(), s.v.y()}); };
  const auto start = drone.start();
  add(start);
  add(measure::after(euler, drone, start, 0.5, 1));
  add(measure::after(midpoint, drone, start, 1.0, 1));
  add(measure::after(euler, drone, start, 1.0, 1));

  auto& looks = record.table("looks", {{"x", "m"}, {"y", "m"}, {"u", "m/s"}, {"v", "m/s"}});
  auto end = start;
  integrate::rk4(end.x, end.v, 0.0, 1.0, [&](const auto& x, const auto& v, double t) {
    looks.add({x.x(), x.y(), v.x(), v.y()});
    return drone(x, v, t);
  });
  looks.add({end.x.x(), end.x.y(), end.v.x(), end.v.y()});
  record.number("four-looks-off", 100 * (end.x - drone.exact(1).x).norm(), 2, "cm");

  auto& slopes = record.table("slopes", {{"t", "s"}, {"braking", "m/s²"}});
  double x = 0, v = 1;
  integrate::rk4(x, v, 0.0, 1.0, [&](double, double velocity, double t) {
    slopes.add({t, velocity});
    return -velocity;
  });
  for (std::size_t i = 0; i < 4; ++i) {
    record.number("slope-" + std::to_string(i + 1), slopes.rows[i][1].value, 3);
  }
  const double once = slopes.rows[0][1].value, twice = slopes.rows[1][1].value;
  const double thrice = slopes.rows[2][1].value, last = slopes.rows[3][1].value;
  record.number("slope-mean", (once + 2 * twice + 2 * thrice + last) / 6, 3);
  record.number("slope-true-middle", std::exp(-0.5), 3);
  record.number("slope-true-end", std::exp(-1.0), 3);
  record.number("slope-true-mean", 1 - std::exp(-1.0), 3);

  const auto around = [&](const char* name, auto step, double h, long steps) {
    auto& path = record.table(name, {{"t", "s"}, {"x", "m"}, {"y", "m"}});
    auto s = drone.start();
    measure::run(step, drone, s, h, steps,
                 [&](double t, const auto& now) { path.add({t, now.x.x(), now.x.y()}); });
    return s.x.norm();
  };
  record.number("eight-midpoint", around("eight-midpoint", midpoint, 1, 8), 3, "m");
  record.number("eight-rk4", around("eight-rk4", rk4, 1, 8), 3, "m");
}

void work(Record& record) {
  auto& table = record.table("work", {{"evaluations", "1/s", whole},
                                      {"Euler", "m"},
                                      {"midpoint", "m"},
                                      {"RK4", "m"},
                                      {"RK4 in float", "m"}});
  const auto error = [](auto step, double rate) {
    const long steps = std::lround(8 * rate);
    return measure::largest_error(step, drone, 1 / rate, steps).position;
  };
  for (double questions = 4; questions <= 4096; questions *= 2) {
    table.add({questions, error(euler, questions), error(midpoint, questions / 2),
               error(rk4, questions / 4), error_in_float(rk4, int(questions) / 4)});
  }
  record.number("at-240-euler", 100 * error(euler, 240), 2, "cm");
  record.number("at-240-midpoint", 1000 * error(midpoint, 120), 2, "mm");
  record.number("at-240-rk4", 1e9 * error(rk4, 60), 2, "nm");
  const auto steps = [](auto step) {
    return double(measure::fewest_steps(step, drone, 8.0, 0.01)) / 8;
  };
  record.number("centimetre-euler", steps(euler), 3);
  record.number("centimetre-midpoint", 2 * steps(midpoint), 2);
  record.number("centimetre-rk4", 4 * steps(rk4), 2);
}

void large_steps(Record& record) {
  const auto error = [](auto step, int rate) {
    return 100 * measure::largest_error(step, suspension, 1.0 / rate, rate).position;
  };
  record.number("at-80-euler", error(euler, 80), 2, "cm");
  record.number("at-80-midpoint", error(midpoint, 40), 2, "cm");
  record.number("at-80-rk4", error(rk4, 20), 2, "cm");
  measure::path(record, "suspension-midpoint", midpoint, suspension, 1.0 / 20, 1);
  measure::path(record, "suspension-rk4", rk4, suspension, 1.0 / 20, 1);
  measure::exact_path(record, "suspension-exact", suspension, 1);
}

void matrix(Record& record) {
  // [matrix]
  const double k = suspension.omega * suspension.omega, c = suspension.damping();
  const auto folded = integrate::rk4_linear_start(k, c, frame);
  double x = suspension.x0, v = suspension.v0;
  for (int n = 0; n < 60; ++n) integrate::rk4_linear(x, v, folded);
  // [matrix]
  const auto plain = measure::after(rk4, suspension, suspension.start(), frame, 60);
  record.number("matrix-xx", folded.xx, 4);
  record.number("matrix-xv", folded.xv, 4);
  record.number("matrix-vx", folded.vx, 4);
  record.number("matrix-vv", folded.vv, 4);
  record.number("matrix-apart", std::abs(x - plain.x), 1, "m");

  auto& speed = record.table("speed", {{"a step of"}, {"swinging", "ns"}, {"at rest", "ns"}});
  speed.add({"RK4, four evaluations", "time:spring/RK4", "time:spring/RK4 at rest"});
  speed.add(
      {"RK4, folded into one matrix", "time:spring/RK4 folded", "time:spring/RK4 folded at rest"});
  speed.add({"the exact step, folded likewise", "time:spring/exact folded", "–"});
  record.number("rests-after", comes_to_rest() / 60, 2, "min");
  const measure::Times& times = measure::recorded_times();
  record.number("rest-longer",
                times.at("spring/RK4 at rest").median / times.at("spring/RK4").median, 2);
}

void bugs(Record& record) {
  auto& table = record.table("bugs", {{"fault", "", measure::whole},
                                      {"off in a turn", "µm", 2},
                                      {"order on the drone", "", 2},
                                      {"on a parachute", "", 2},
                                      {"on a rocket", "", 2}});
  const auto order = [](const auto& method, const auto& scene, double coarse, double duration) {
    return measure::halvings(method, scene, coarse, duration, 4).back().position_order;
  };
  for (const wrong::Bug& bug :
       {wrong::Bug{"none", {}}, wrong::fourth_looks_too_soon, wrong::third_is_second,
        wrong::stale_velocities, wrong::equal_weights, wrong::stopped_clock}) {
    const auto method = wrong::method_of(bug.stages);
    table.add({bug.what, 1e6 * measure::largest_error(method, drone, frame, turn).position,
               order(method, drone, 0.25, 8), order(method, parachute, 1.0 / 32, 2),
               order(method, engine_on, 0.25, 4)});
  }
  record.number("bug-off", table.rows[1][1].value, 2, "µm");
  auto& orders =
      record.table("stages", {{"steps per second", "", whole}, {"RK4", "m"}, {"bug", "m"}});
  const auto right = measure::halvings(rk4, drone, 1.0, 8.0, 8);
  const auto wrong =
      measure::halvings(wrong::method_of(wrong::fourth_looks_too_soon.stages), drone, 1.0, 8.0, 8);
  for (std::size_t i = 0; i < right.size(); ++i) {
    orders.add({1 / right[i].h, right[i].error.position, wrong[i].error.position});
  }
}

/// What the passage costs, in one go and in frames, and what equal steps would have cost.
void comet_passes(Record& record) {
  const Passage smooth = pass(1), framed = pass(1200), ahead = read(1200);
  record.number("comet-free", double(smooth.total()), whole);
  record.number("comet-framed", double(framed.total()), whole);
  record.number("comet-dearest", double(framed.dearest()), whole);
  record.number("comet-cheapest", double(framed.cheapest()), whole);
  record.number("comet-error", 1e6 * smooth.error, 2, "µm");
  record.number("comet-read", 1e6 * ahead.farthest, 2, "µm");
  record.number("comet-read-dearest", double(ahead.dearest()), whole);
  record.number("comet-longest", longest_step(), 2, "s");
  long rate = 60;
  while (error_of_equal_steps(rate) > smooth.error) rate += 60;
  record.number("comet-rk4", double(4 * rate) * comet_year, 2);
  record.number("comet-rk4-rate", double(rate), whole);
  record.number("comet-rk4-60", error_of_equal_steps(60), 2, "m");
  const Passage fixed = step_equally(1200);
  record.number("comet-fixed-frame", double(fixed.total()) / 1200, 2);
  record.number("comet-fixed", double(fixed.total()), whole);
  record.number("comet-fixed-error", 1000 * fixed.error, 2, "mm");
  record.number("comet-apart", 1e6 * (framed.end.x - pass(2880).end.x).norm(), 2, "µm");

  auto& table = record.table("comet", {{"t", "s"}, {"evaluations", "", whole}});
  for (std::size_t n = 0; n < framed.evaluations.size(); ++n) {
    table.add({double(n) / 60, double(framed.evaluations[n])});
  }
}

}  // namespace

int main(int argc, char** argv) {
  return measure::record(argc, argv, [](Record& record) {
    first_try(record);
    one_step(record);
    work(record);
    equal_cost(record);
    burn_areas(record);
    burnout(record);
    energy(record);
    large_steps(record);
    blends(record);
    limits(record);
    matrix(record);
    bugs(record);
    single_precision(record);
    comet_passes(record);
  });
}
