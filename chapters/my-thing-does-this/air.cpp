// SPDX-License-Identifier: MIT-0
// What jumps, falls, is thrown and is steered.
#include <cmath>
#include <complex>

#include "integrate/constant_acceleration.h"
#include "shelf/aim.h"
#include "shelf/jump.h"
#include "shelf/quadratic_drag.h"
#include "sketch.h"

namespace {

using Flat = std::complex<double>;

const auto dot = [](const Flat& a, const Flat& b) { return std::real(a * std::conj(b)); };

Sketch too_low() {
  const auto jump = shelf::jump_to(4.0, 0.44);
  double x = 0, v = jump.speed, y = 0, w = v;
  return {"too-low",
          0.44,
          "t [s]",
          "m",
          {run("velocity first, at 15 Hz", 0.4, 15, 0,
               [&](double h) {
                 v -= h * jump.gravity;
                 return x += h * v;
               }),
           run("jump_step", 0.4, 15, 0, [&](double h) {
             shelf::jump_step(y, w, jump.gravity, jump.gravity, h);
             return y;
           })}};
}

// How much further than g t^2 / 2 it falls, at 60 ticks a second.
Sketch falls_otherwise() {
  const auto fall = [](const char* label, int substeps) {
    double x = 0, v = 0, t = 0;
    return run(label, 2, 60, 0, [=](double h) mutable {
      for (int i = 0; i < substeps; ++i) v += h / substeps * g, x += h / substeps * v;
      t += h;
      return 100 * (x - g * t * t / 2);
    });
  };
  double x = 0, v = 0, t = 0;
  return {"falls-otherwise",
          2,
          "t [s]",
          "cm",
          {fall("velocity first", 1), fall("in four substeps", 4),
           run("constant_acceleration", 2, 60, 0, [&](double h) {
             integrate::constant_acceleration(x, v, t, h, [](double, double, double) { return g; });
             t += h;
             return 100 * (x - g * t * t / 2);
           })}};
}

Sketch terminal_speed() {
  constexpr double c = g / 2;
  double v = 0, w = 0;
  return {"terminal-speed",
          1.6,
          "t [s]",
          "m/s",
          {run("divides first, at 15 Hz", 1.6, 15, 0,
               [&](double h) { return v = v / (1 + c * h) + h * g; }),
           run("force first, then divides", 1.6, 15, 0,
               [&](double h) { return w = (w + h * g) / (1 + c * h); })}};
}

Sketch backwards() {
  constexpr double k = 1.2;
  double v = 350, x = 0, w = 350;
  return {"backwards",
          0.1,
          "t [s]",
          "m/s",
          {run("v -= h k v |v|, at 60 Hz", 0.1, 60, 350,
               [&](double h) { return v -= h * k * v * std::abs(v); }),
           run("quadratic_drag", 0.1, 60, 350, [&](double h) {
             shelf::quadratic_drag(x, w, 0.0, 0.0, k, h, [](double u) { return std::abs(u); });
             return w;
           })}};
}

// A grenade with linear drag, as high as it is.
Sketch wrong_arc() {
  const auto tick = [](Flat& x, Flat& v) {
    constexpr double h = 1 / 60.0;
    v = (v + h * Flat(0, -g)) / (1 + 0.3 * h);
    x = x + h * v;
  };
  const Flat thrown(15, 15);
  const auto by_ticks = [&](const char* label) {
    Flat x = 0, v = thrown;
    return run(label, 2.8, 60, 0, [&](double) {
      tick(x, v);
      return std::imag(x);
    });
  };
  double t = 0;
  return {"wrong-arc",
          2.8,
          "t [s]",
          "m",
          {run("the parabola", 2.8, 60, 0,
               [&](double h) {
                 t += h;
                 return 15 * t - g * t * t / 2;
               }),
           by_ticks("the flight"), by_ticks("drawn by the same step")}};
}

struct Hunter {
  Flat x, v;
};

// How far a shell of 60 m/s with drag is from a truck that passes 60 m away with 15 m/s.
Line shell(const char* label, bool leads) {
  constexpr double h = 1 / 60.0;
  const auto tick = [=](Flat& x, Flat& v) {
    const Flat before = v;
    v = (v + h * Flat(0, -g)) / (1 + h * 0.005 * std::abs(v));
    x = x + h / 2 * (before + v);
  };
  const auto truck = [](double t) { return Flat(60 + 15 * t, 0); };
  const auto stands = [&](double) { return truck(0); };
  const shelf::Gun<double> gun{60, h, 20, 1e-3};
  const auto shot = leads ? shelf::aim(Flat(0, 1), truck, tick, dot, gun)
                          : shelf::aim(Flat(0, 1), stands, tick, dot, gun);
  Flat x(0, 1), v = shot.velocity;
  double t = 0;
  return run(label, 2, 60, std::abs(truck(0) - x), [&](double) {
    tick(x, v);
    t += h;
    return std::abs(truck(t) - x);
  });
}

Sketch misses() {
  return {
      "misses", 2, "t [s]", "m to the truck", {shell("at where it is", false), shell("aim", true)}};
}

// A missile with 40 m/s^2 of thrust, and a target that it flies past.
Line missile(const char* label, bool steers) {
  Hunter one{Flat(0, 0), Flat(0, 25)};
  const Flat target(40, 0);
  return run(label, 6, 60, 40, [=](double h) mutable {
    const Flat way = target - one.x;
    if (std::abs(way) < 1 && steers) return std::abs(way);
    const Flat towards = way / std::abs(way);
    const Flat wanted = steers ? 40.0 * (60.0 * towards - one.v) : 40.0 * towards;
    one.v = one.v + h * std::min(1.0, 40 / std::abs(wanted)) * wanted;
    one.x = one.x + h * one.v;
    return std::abs(target - one.x);
  });
}

Sketch orbits() {
  return {
      "orbits",
      6,
      "t [s]",
      "m to the target",
      {missile("thrust towards it", false), missile("thrust towards the wanted velocity", true)}};
}

}  // namespace

std::vector<Sketch> sketches_of_the_air() {
  return {too_low(),   falls_otherwise(), terminal_speed(), backwards(),
          wrong_arc(), misses(),          orbits()};
}
