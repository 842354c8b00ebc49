// SPDX-License-Identifier: MIT-0
// What depends on the length of a frame.
#include <cmath>

#include "integrate/spring_exact.h"
#include "shelf/blend.h"
#include "shelf/fixed_step.h"
#include "shelf/jump.h"
#include "shelf/smooth_damp.h"
#include "sketch.h"

namespace {

Sketch explodes() {
  constexpr double omega = 2 * std::numbers::pi * 6;
  double x = 1, v = 0, y = 1, w = 0;
  return {"explodes",
          1,
          "t [s]",
          "m",
          {run("velocity first, at 15 fps", 1, 15, 1,
               [&](double h) {
                 v -= h * omega * omega * x;
                 return x += h * v;
               }),
           run("spring_exact, at 15 fps", 1, 15, 1, [&](double h) {
             integrate::spring_exact(y, w, h, omega, 0.0);
             return y;
           })}};
}

Sketch jumps_higher() {
  const auto jump = shelf::jump_to(4.0, 0.44);
  const auto by_hand = [&](const char* label, double rate) {
    double x = 0, v = jump.speed;
    return run(label, 0.8, rate, 0, [&, x, v](double h) mutable {
      x += h * v;
      v -= h * jump.gravity;
      return x;
    });
  };
  double x = 0, v = jump.speed;
  return {"jumps-higher",
          0.8,
          "t [s]",
          "m",
          {by_hand("place first, at 15 fps", 15), by_hand("at 60 fps", 60),
           run("jump_step, at 15 fps", 0.8, 15, 0, [&](double h) {
             shelf::jump_step(x, v, jump.gravity, jump.gravity, h);
             return x;
           })}};
}

Sketch brakes_by_frames() {
  const auto share = [](const char* label, double rate) {
    double v = 10;
    return run(label, 2, rate, v, [v](double) mutable { return v *= 0.99; });
  };
  const double c = -60 * std::log(0.99);
  double v = 10;
  return {
      "brakes-by-frames",
      2,
      "t [s]",
      "m/s",
      {share("v *= 0.99, at 30 fps", 30), share("at 144 fps", 144),
       run("v *= exp(-c h), at any", 2, 30, v, [&](double h) { return v *= std::exp(-c * h); })}};
}

Sketch smooths_by_frames() {
  const auto lerp = [](const char* label, double rate) {
    double x = 0;
    return run(label, 1, rate, x, [x](double) mutable { return x += 0.1 * (10 - x); });
  };
  double x = 0;
  return {"smooths-by-frames",
          1,
          "t [s]",
          "m",
          {lerp("lerp by 0.1, at 30 fps", 30), lerp("at 144 fps", 144),
           run("smooth, at any", 1, 30, x, [&](double h) {
             shelf::smooth(x, 10.0, 0.0, -60 * std::log(0.9), h);
             return x;
           })}};
}

// A runner who is stepped 60 times a second, and a camera that follows him in each of 75 frames.
// How far he is from the middle of the picture, once the camera has caught up.
Line on_the_screen(const char* label, bool blended) {
  shelf::FixedStep<> clock{1 / 60.0};
  double before = 0, runner = 0, camera = 0, speed = 10;
  const auto frame = [&] {
    clock.frame(1 / 75.0, [&](double) { before = runner, runner += 10 * clock.h; });
    const double seen = blended ? shelf::blend(before, runner, clock.blend()) : runner;
    shelf::smooth_damp(camera, speed, seen, 10.0, 8.0, 1 / 75.0);
    return 100 * (seen - camera);
  };
  for (int n = 0; n < 75 * 4; ++n) frame();
  return each(label, 46, [&](int) { return frame(); });
}

Sketch jitters() {
  return {"jitters",
          0.6,
          "t [s]",
          "cm",
          {on_the_screen("his last tick", false), on_the_screen("blended", true)}};
}

// Stepped 30 times a second and drawn 144 times: how far it goes from one picture to the next.
Line between_pictures(const char* label, bool blended) {
  shelf::FixedStep<> clock{1 / 30.0};
  double before = 0, x = 0, last = 0;
  const auto frame = [&] {
    clock.frame(1 / 144.0, [&](double) { before = x, x += 6 * clock.h; });
    const double seen = blended ? shelf::blend(before, x, clock.blend()) : x;
    const double moved = seen - last;
    last = seen;
    return 100 * moved;
  };
  for (int n = 0; n < 144; ++n) frame();
  return each(label, 49, [&](int) { return frame(); });
}

Sketch stutters() {
  return {"stutters",
          1 / 3.0,
          "t [s]",
          "cm",
          {between_pictures("the last tick", false), between_pictures("blended", true)}};
}

// A jump by velocity first, in game time, at a quarter of its pace.
Sketch slow_motion() {
  const auto jump = [](const char* label, double h, double rate) {
    shelf::FixedStep<> clock{h};
    double x = 0, v = 9;
    return run(label, 1.6, rate, 0, [&](double frame) {
      clock.frame(frame, [&](double) { v -= h * g, x += h * v; });
      return x > 0 ? x : 0;
    });
  };
  return {"slow-motion",
          1.6,
          "t of the game [s]",
          "m",
          {jump("h made a quarter", 1 / 120.0, 60), jump("at full speed", 1 / 30.0, 60),
           jump("frames made a quarter", 1 / 30.0, 240)}};
}

// A ball of 20 m/s, and a wall of half a metre 5 m on; the fifth frame takes half a second.
Sketch hitch() {
  const auto stop = [](double x) { return x > 5 && x < 5.5 ? 5 : x; };
  double x = 0, y = 0, v = 20;
  int n = 0, m = 0;
  shelf::FixedStep<> clock{1 / 60.0};
  return {"hitch",
          60,
          "frame",
          "m",
          {run("a step for each frame", 1, 60, 0,
               [&](double h) { return x = stop(x + 20 * (n++ == 5 ? 0.5 : h)); }),
           run("FixedStep", 1, 60, 0, [&](double h) {
             clock.frame(m++ == 5 ? 0.5 : h, [&](double) {
               y = stop(y + v * clock.h);
               if (y == 5) v = 0;
             });
             return y;
           })}};
}

Sketch a_day() {
  constexpr double h = 1 / 60.0;
  constexpr long start = 60L * 60 * 60 * 24;
  const auto moment = [&](int n) { return float(start + n) * float(h); };
  return {"a-day",
          0.5,
          "t after a day [s]",
          "ms",
          {each("a float", 31, [&](int n) { return 1e3 * double(moment(n + 1) - moment(n)); }),
           each("FixedStep<>", 31, [&](int n) {
             return 1e3 * ((double(start) + n + 1) * h - (double(start) + n) * h);
           })}};
}

// A step takes 18 ms and a picture 8, in steps of 1/60 s: how long the frames take.
Sketch spiral() {
  const auto frames = [](const char* label, double longest) {
    shelf::FixedStep<> clock{1 / 60.0, longest};
    double length = 1 / 60.0;
    return each(label, 40, [&](int) {
      int steps = 0;
      clock.frame(length, [&](double) { ++steps; });
      length = 0.018 * steps + 0.008;
      return 1e3 * length;
    });
  };
  return {"spiral",
          39,
          "frame",
          "ms",
          {frames("no longest frame", 1e9), frames("a quarter of a second", 0.25),
           frames("1/15 s", 1 / 15.0)}};
}

}  // namespace

std::vector<Sketch> sketches_of_frames() {
  return {explodes(), jumps_higher(), brakes_by_frames(), smooths_by_frames(),
          jitters(),  stutters(),     slow_motion(),      hitch(),
          a_day(),    spiral()};
}
