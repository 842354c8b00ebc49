// SPDX-License-Identifier: MIT-0
// Springs, dampers and cameras.
#include <cmath>

#include "integrate/euler.h"
#include "integrate/rk4.h"
#include "integrate/spring_exact.h"
#include "integrate/symplectic_euler.h"
#include "shelf/event.h"
#include "shelf/smooth_damp.h"
#include "shelf/soft_constraint.h"
#include "sketch.h"

namespace {

constexpr double frame = 1 / 60.0;

// A spring of 6 rad/s without a damper.
constexpr auto pull = [](double x, double, double) { return -36 * x; };

Sketch swings_higher() {
  double x = 1, v = 0, y = 1, w = 0;
  return {"swings-higher",
          4,
          "t [s]",
          "m",
          {run("Euler", 4, 60, 1,
               [&](double h) {
                 integrate::euler(x, v, 0.0, h, pull);
                 return x;
               }),
           run("symplectic_euler", 4, 60, 1, [&](double h) {
             integrate::symplectic_euler(y, w, 0.0, h, pull);
             return y;
           })}};
}

Sketch swing_dies() {
  double x = 1, v = 0, y = 1, w = 0;
  return {"swing-dies",
          6,
          "t [s]",
          "m",
          {run("backward Euler", 6, 60, 1,
               [&](double h) {
                 v = (v - h * 36 * x) / (1 + h * h * 36);
                 return x += h * v;
               }),
           run("symplectic_euler", 6, 60, 1, [&](double h) {
             integrate::symplectic_euler(y, w, 0.0, h, pull);
             return y;
           })}};
}

// A damper of c h = 1.95.
Sketch buzzes() {
  constexpr double c = 117;
  double v = 1, w = 1;
  return {"buzzes",
          0.5,
          "t [s]",
          "m/s",
          {run("v -= h c v, at 60 Hz", 0.5, 60, 1, [&](double h) { return v -= h * c * v; }),
           run("v /= 1 + h c", 0.5, 60, 1, [&](double h) { return w /= 1 + h * c; })}};
}

Sketch overshoots() {
  double x = 0, v = 60, y = 0, w = 60;
  return {"overshoots",
          1.5,
          "t [s]",
          "m",
          {run("smooth_damp", 1.5, 60, 0,
               [&](double h) {
                 shelf::smooth_damp(x, v, 3.0, 0.0, 4.0, h);
                 return x;
               }),
           run("smooth_damp_no_overshoot", 1.5, 60, 0, [&](double h) {
             shelf::smooth_damp_no_overshoot(y, w, 3.0, 0.0, 4.0, h, product);
             return y;
           })}};
}

Line behind_a_runner(const char* label, double known) {
  double x = 0, v = 0, place = 0;
  return run(label, 3, 60, 0, [=](double h) mutable {
    place += 10 * h;
    shelf::smooth_damp(x, v, place, known, 4.0, h);
    return place - x;
  });
}

Sketch lags() {
  return {"lags",
          3,
          "t [s]",
          "m behind",
          {behind_a_runner("velocity 0 handed over", 0), behind_a_runner("the runner's", 10)}};
}

Sketch whips() {
  double x = 0, v = 0, y = 0, w = 0;
  return {"whips",
          3,
          "t [s]",
          "m/s",
          {run("smooth_damp", 3, 60, 0,
               [&](double h) {
                 shelf::smooth_damp(x, v, 80.0, 0.0, 4.0, h);
                 return v;
               }),
           run("smooth_damp_limited", 3, 60, 0, [&](double h) {
             shelf::smooth_damp_limited(y, w, 80.0, 0.0, 4.0, 40.0, 200.0, h, product);
             return w;
           })}};
}

Sketch too_soft() {
  constexpr double omega = 2 * std::numbers::pi * 5;
  const auto soft = shelf::softness(frame, omega, 0.0);
  double wall = 0, x = 0.1, v = 0, impulse = 0, y = 0.1, w = 0;
  return {"too-soft",
          1,
          "t [s]",
          "m",
          {run("a soft constraint of 5 Hz", 1, 60, 0.1,
               [&](double h) {
                 shelf::soft_warm_start(wall, v, impulse, 1.0, 0.0, 1.0);
                 shelf::soft_constraint(wall, v, impulse, 1.0, x, 0.0, 1.0, soft, product);
                 return x += h * v;
               }),
           run("spring_exact of 5 Hz", 1, 60, 0.1, [&](double h) {
             integrate::spring_exact(y, w, h, omega, 0.0);
             return y;
           })}};
}

// A wheel over a kerb of 10 cm that it meets between two frames.
struct Wheel {
  double x = 0, v = 0, t = 0;
};
constexpr double kerb = 0.1037;

void roll(Wheel& one, double h, double road) {
  integrate::rk4(one.x, one.v, one.t, h,
                 [&](double x, double v, double) { return 100 * (road - x) - 4 * v; });
  one.t += h;
}

// How far RK4 is from a run in short steps, in millimetres, at 60 Hz.
Line over_the_kerb(const char* label, bool at_event) {
  Wheel one, fine;
  return run(label, 0.6, 60, 0, [=](double h) mutable {
    double left = h;
    const auto step = [&](Wheel& wheel, double part) {
      roll(wheel, part, wheel.t < kerb ? 0 : 0.1);
    };
    const auto before = [](const Wheel& wheel) { return kerb - wheel.t; };
    const auto crossing = shelf::first_crossing(one, left, step, before);
    if (at_event && crossing.found) {
      roll(one, crossing.time, 0);
      one.t = kerb;
      left -= crossing.time;
    }
    if (at_event) {
      step(one, left);
    } else {
      integrate::rk4(one.x, one.v, one.t, h, [](double x, double v, double t) {
        return 100 * ((t < kerb ? 0 : 0.1) - x) - 4 * v;
      });
      one.t += h;
    }
    for (int i = 0; i < 1000; ++i) roll(fine, h / 1000, fine.t + h / 2000 < kerb ? 0 : 0.1);
    return 1e3 * (one.x - fine.x);
  });
}

Sketch no_better() {
  return {
      "no-better",
      0.6,
      "t [s]",
      "mm off",
      {over_the_kerb("RK4 across the kerb", false), over_the_kerb("RK4 up to it, and on", true)}};
}

}  // namespace

std::vector<Sketch> sketches_of_springs() {
  return {swings_higher(), swing_dies(), buzzes(),   overshoots(),
          lags(),          whips(),      too_soft(), no_better()};
}
