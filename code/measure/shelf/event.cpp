// SPDX-License-Identifier: MIT-0
#include "shelf/event.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "integrate/rk4.h"
#include "measure/shelf_card.h"
#include "shelf/bounce.h"

namespace measure::shelf_cards {
namespace {

struct Thrown {
  double x, v;
};

const auto fall = [](Thrown& one, double h) {
  one.x = one.x + h * one.v - h * h / 2 * 9.81;
  one.v = one.v - h * 9.81;
};

// How far the time is off at most, and the most steps that are asked for.
struct Met {
  double off = 0;
  int asked = 0;
};

Met met() {
  Met worst;
  constexpr double h = 1 / 60.0;
  for (int i = 1; i <= 100; ++i) {
    const Thrown start{0.001 * i, -0.5 * (i % 7) - 0.1 * i};
    const auto known = shelf::impact_plane(start.x, start.v, -9.81, h);
    int asked = 0;
    const auto counted = [&](Thrown& one, double part) { ++asked, fall(one, part); };
    const auto height = [](const Thrown& one) { return one.x; };
    const auto found = shelf::first_crossing(start, h, counted, height);
    if (known.hit != found.found) worst.off = 1;
    if (found.found) worst.off = std::max(worst.off, std::abs(found.time - known.time) / h);
    worst.asked = std::max(worst.asked, asked);
  }
  return worst;
}

Promise ground() {
  const double off = met().off;
  return {"a ball that falls meets the ground when impact_plane says so, to 1e-13 of the step",
          off < 1e-13, off};
}

Promise price() {
  const int most = met().asked;
  return {"for that it asks for no more than 18 steps", most <= 18, double(most), whole, "steps"};
}

// A wheel on a spring and a damper, over a kerb that it meets at 1.0037 s.
struct Wheel {
  double x = 0, v = 0, t = 0;
};
constexpr double kerb = 1.0037;

Wheel rolled(int rate, bool by_event) {
  Wheel wheel;
  bool is_over = false;
  const auto step = [&](Wheel& one, double h) {
    integrate::rk4(one.x, one.v, one.t, h, [&](double x, double v, double t) {
      const double road = (by_event ? is_over : t > kerb) ? 0.1 : 0.0;
      return 100 * (road - x) - 4 * v;
    });
    one.t = one.t + h;
  };
  const auto before = [](const Wheel& one) { return kerb - one.t; };
  for (int n = 0; n < 2 * rate; ++n) {
    double left = 1.0 / rate;
    const auto crossing = shelf::first_crossing(wheel, left, step, before);
    if (by_event && crossing.found) {
      step(wheel, crossing.time);
      left -= crossing.time, is_over = true;
    }
    step(wheel, left);
  }
  return wheel;
}

double off(int rate, bool by_event) {
  static const Wheel fine = rolled(16'384, true);
  return std::abs(rolled(rate, by_event).x - fine.x);
}

Promise order() {
  const double order = std::log2(off(64, true) / off(128, true));
  return {"over a kerb at 1.0037 s RK4 keeps its order of 4, to 0.1", std::abs(order - 4) < 0.1,
          order, 3};
}

Promise gain() {
  const double with = off(64, true), without = off(64, false);
  return {"there, at 64 Hz, it is more than fifty times nearer than across the kerb",
          without > 50 * with, without / with, 2};
}

Promise beyond() {
  bool kept = true;
  for (const float start : {0.1f, 3.0f, 500.0f}) {
    const auto step = [](float& one, float h) { one = one - 40 * h; };
    const auto height = [](float one) { return one; };
    const float h = start / 17.0f;
    const auto crossing = shelf::first_crossing(start, h, step, height);
    float there = start;
    step(there, crossing.time);
    kept = kept && crossing.found && there <= 0 && crossing.time <= h;
  }
  return {"in float, too, the event is never above zero at the time that it says", kept,
          kept ? Cell("never") : Cell("above")};
}

}  // namespace

ShelfCard event() {
  return {"event", {ground(), price(), order(), gain(), beyond()}};
}

}  // namespace measure::shelf_cards
