// SPDX-License-Identifier: MIT-0
// Chapter 1: where is the thing one frame later?
#include <algorithm>
#include <cmath>

#include "ball.h"
#include "frames/recorded.h"
#include "jump.h"
#include "measure/methods.h"
#include "measure/order.h"
#include "measure/record.h"
#include "runner.h"
#include "shelf/fixed_step.h"
#include "shot.h"

using measure::euler;
using measure::Record;
using measure::whole;

namespace {

void jumps(Record& record) {
  auto& table = record.table("jump", {{"rate", "Hz", whole}, {"t", "s"}, {"height", "m"}});
  for (const int rate : {20, 30, 60, 144}) {
    auto s = jump.start();
    measure::run(euler, jump, s, 1.0 / rate, rate,
                 [&](double t, const auto& now) { table.add({double(rate), t, now.x.y()}); });
    record.number("apex-" + std::to_string(rate), apex(euler, rate), 4, "m");
  }
  record.number("apex-exact", top_of_jump(), 4, "m");
  record.number("ledge", ledge, 3, "m");
  double missed = 0;
  for (const int rate : {20, 30, 60, 144}) {
    missed = std::max(missed, top_of_jump() - apex(measure::constant_acceleration, rate));
  }
  record.number("top-missed", 1000 * missed, 2, "mm");
}

/// The velocity of the jump that the three lines take for all of a step of a twentieth of a second.
void area_of_a_jump(Record& record) {
  auto& table =
      record.table("jump-area", {{"t", "s"}, {"ends", "s"}, {"v", "m/s"}, {"v then", "m/s"}});
  const double h = 1.0 / 20;
  auto s = jump.start();
  measure::run(euler, jump, s, h, 9, [&](double t, const auto& now) {
    table.add({t, t + h, now.v.y(), jump.exact(t + h).v.y()});
  });
  for (const int rate : {20, 60})
    record.number("corners-" + std::to_string(rate), 100 * too_high(euler, rate, 0.5), 3, "cm");
}

void cannon(Record& record) {
  // [cannon]
  auto s = cannonball.start();
  const double landing = 2 * 30 / 9.81;
  integrate::constant_acceleration(s.x, s.v, 0.0, landing, cannonball);
  // [cannon]
  record.number("cannon-range", s.x.x(), 4, "m");

  auto& exact = record.table("cannon", {{"t", "s"}, {"x", "m"}, {"y", "m"}});
  for (int twelfth = 0; twelfth <= 12; ++twelfth) {
    const auto now = cannonball.exact(landing * twelfth / 12).x;
    exact.add({landing * twelfth / 12, now.x(), now.y()});
  }
  auto& air = record.table("cannon-in-air", {{"t", "s"}, {"x", "m"}, {"y", "m"}});
  long n = 0;
  const Landing down = land_in_air(cannonball.start(), [&](double t, const auto& now) {
    if (n++ % 500 == 0) air.add({t, now.x.x(), now.x.y()});
  });
  air.add({down.t, down.x, 0.0});
  record.number("cannon-range-in-air", down.x, 3, "m");

  const auto once =
      measure::after(measure::constant_acceleration, heavy_air, cannonball.start(), down.t, 1);
  record.number("air-behind", -once.x.x(), 2, "m");
  record.number("air-below", -once.x.y(), 3, "m");
  record.number("air-euler", off_landing(euler, down), 2, "m");
  record.number("air-galileo", off_landing(measure::constant_acceleration, down), 2, "m");
}

void throws(Record& record) {
  const double h = 1.0 / 20;
  const long steps = 40;
  for (const Ball& ball : {in_a_vacuum, in_air}) {
    const std::string where = ball.up.c == 0 ? "in-a-vacuum" : "in-air";
    auto& table = record.table("throw-" + where, {{"t", "s"},
                                                  {"x", "m"},
                                                  {"y", "m"},
                                                  {"Euler's x", "m"},
                                                  {"Euler's y", "m"},
                                                  {"x with a h²/2", "m"},
                                                  {"y with a h²/2", "m"}});
    for (int n = 0; n <= steps; ++n) {
      const auto truth = ball.exact(n * h).x;
      const auto plain = measure::after(euler, ball, ball.start(), h, n).x;
      const auto curved =
          measure::after(measure::constant_acceleration, ball, ball.start(), h, n).x;
      table.add({n * h, truth.x(), truth.y(), plain.x(), plain.y(), curved.x(), curved.y()});
    }
    const auto error = [&](auto method) {
      return 100 * measure::largest_error(method, ball, h, steps).position;
    };
    record.number("euler-" + where, error(euler), 2, "cm");
    record.number("term-" + where, error(measure::constant_acceleration), 2, "cm");
  }
}

void order(Record& record) {
  auto& table = record.table("order", {{"steps per second", "", whole},
                                       {"Euler", "m"},
                                       {"order"},
                                       {"with a h²/2", "m"},
                                       {"its order"}});
  const auto plain = measure::halvings(euler, leaf, 1.0 / 8, 4.0, 7);
  const auto curved = measure::halvings(measure::constant_acceleration, leaf, 1.0 / 8, 4.0, 7);
  for (std::size_t i = 0; i < plain.size(); ++i) {
    table.add({1 / plain[i].h, plain[i].error.position, plain[i].position_order,
               curved[i].error.position, curved[i].position_order});
  }
  record.number("leaf-error-euler", 100 * plain[0].error.position, 3, "cm");
  record.number("leaf-error-term", 100 * curved[0].error.position, 3, "cm");
  record.number("leaf-fall", -leaf.exact(4).x, 3, "m");
  record.number("leaf-ratio", curved.back().error.position / plain.back().error.position, 2);
}

void uneven_frames(Record& record) {
  auto& table = record.table("uneven", {{"jump", "", whole}, {"t", "s"}, {"height", "m"}});
  auto& tops = record.table("uneven-tops", {{"jump", "", whole}, {"top", "m"}});
  double lowest = INFINITY, highest = 0;
  for (std::size_t jumps = 0; jumps < 10; ++jumps) {
    // [uneven]
    frames::Playback recording{.at = 60 * jumps};
    auto s = jump.start();
    double top = 0;
    for (double t = 0, length; t < 1; t += length) {
      table.add({double(jumps + 1), t, s.x.y()});
      top = std::max(top, s.x.y());
      length = recording.next();
      integrate::euler(s.x, s.v, t, length, jump);
    }
    // [uneven]
    tops.add({double(jumps + 1), top});
    lowest = std::min(lowest, top);
    highest = std::max(highest, top);
  }
  using frames::recorded;
  record.number("frames-recorded", double(recorded.size()), whole);
  record.number("frames-late",
                double(std::count_if(recorded.begin(), recorded.end(),
                                     [](double length) { return length > 2.0 / 60; })),
                whole);
  record.number("frames-longest", 1000 * *std::max_element(recorded.begin(), recorded.end()), 3,
                "ms");
  record.number("uneven-lowest", lowest, 4, "m");
  record.number("uneven-highest", highest, 4, "m");
}

/// Some recorded frames about a late one, and the steps that they pay for.
void time_line(Record& record) {
  using frames::recorded;
  auto& shown = record.table("frame-line", {{"begins", "ms"}, {"ends", "ms"}, {"spent", "ms"}});
  auto& steps = record.table("step-line", {{"begins", "ms"}, {"ends", "ms"}, {"paid", "ms"}});
  const auto late =
      std::find_if(recorded.begin(), recorded.end(), [](double length) { return length > 0.06; });
  frames::Playback recording{.at = std::size_t(late - recorded.begin()) - 4};
  shelf::FixedStep<> clock{.h = 1.0 / 60};
  double begins = 0;
  for (int n = 0; n < 8; ++n) {
    const double ends = begins + recording.next();
    const long long before = clock.steps;
    clock.frame(ends - begins,
                [&](double t) { steps.add({1000 * t, 1000 * (t + clock.h), 1000 * ends}); });
    shown.add({1000 * begins, 1000 * ends, 1000 * (ends - clock.saved)});
    if (n == 4) {
      record.number("late-frame", 1000 * (ends - begins), 3, "ms");
      record.number("late-steps", double(clock.steps - before), whole);
    }
    begins = ends;
  }
}

void display(Record& record) {
  auto& table = record.table(
      "display",
      {{"frame", "", whole}, {"newest state", "cm"}, {"blended", "cm"}, {"extrapolated", "cm"}});
  const auto from_the_wall = [](double x) { return 100 * (x - room); };
  // [drawn]
  shelf::FixedStep<> clock{.h = 1.0 / 60};
  Runner before{.x = room - 0.355}, now = before;
  for (int shows = 0; shows < 48; ++shows) {
    clock.frame(1.0 / 144, [&](double) {
      before = now;
      now.step(clock.h);
    });
    const double blended = before.x + clock.blend() * (now.x - before.x);
    const double ahead = now.x + clock.saved * now.v;
    table.add({double(shows), from_the_wall(now.x), from_the_wall(blended), from_the_wall(ahead)});
  }
  // [drawn]
  record.number("runner-step", 100 * Runner{}.v * clock.h, 2, "cm");
  record.number("runner-step-20", 100 * Runner{}.v / 20, 2, "cm");
}

void far_away(Record& record) {
  auto& table = record.table("far", {{"distance", "m", whole}, {"t", "s"}, {"drifted", "m"}});
  for (const float distance : {0.0f, 1500.0f, 4000.0f, 16'000.0f}) {
    // [far]
    float x = distance;
    for (int n = 0; n <= 10 * 240; ++n) {
      if (n % 40 == 0) table.add({distance, n / 240.0, double(x) - distance});
      x = x + (1 / 240.0f) * 0.1f;
    }
    // [far]
    record.number("drifted-" + std::to_string(int(distance)), table.rows.back()[2].value, 3, "m");
  }
  float clock = 0;
  constexpr long night = 8L * 3600 * 60;
  for (long n = 0; n < night; ++n) clock = clock + 1 / 60.0f;
  record.number("clock-wrong", std::abs(double(clock) - 8 * 3600), 3, "s");
}

}  // namespace

int main(int argc, char** argv) {
  return measure::record(argc, argv, [](Record& record) {
    jumps(record);
    area_of_a_jump(record);
    cannon(record);
    throws(record);
    order(record);
    uneven_frames(record);
    time_line(record);
    display(record);
    far_away(record);
  });
}
