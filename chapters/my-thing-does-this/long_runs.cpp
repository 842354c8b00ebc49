// SPDX-License-Identifier: MIT-0
// What goes wrong late, far out and on another machine.
#include <Eigen/Core>
#include <cmath>

#include "frames/recorded.h"
#include "integrate/euler.h"
#include "integrate/leapfrog.h"
#include "integrate/rk4.h"
#include "integrate/symplectic_euler.h"
#include "scenes/orbit.h"
#include "shelf/fixed_step.h"
#include "sketch.h"

namespace {

using Vec = Eigen::Vector2d;

// A moon on a circle, once round in so many seconds.
struct Circle {
  double omega;

  Vec operator()(const Vec& x, const Vec&, double) const {
    return -omega * omega / std::pow(x.norm(), 3) * x;
  }
};

Sketch spirals_out() {
  const Circle pull{2 * std::numbers::pi / 4};
  Vec x(1, 0), v(0, pull.omega), y = x, w = integrate::leapfrog_start(x, v, 0.0, 1 / 30.0, pull);
  return {"spirals-out",
          40,
          "t [s]",
          "radii from the planet",
          {run("Euler", 40, 30, 1,
               [&](double h) {
                 integrate::euler(x, v, 0.0, h, pull);
                 return x.norm();
               }),
           run("leapfrog", 40, 30, 1, [&](double h) {
             integrate::leapfrog(y, w, 0.0, h, pull);
             return y.norm();
           })}};
}

// Twenty steps a turn.
Sketch sinks_into_the_planet() {
  const Circle pull{2 * std::numbers::pi};
  Vec x(1, 0), v(0, pull.omega), y = x, w = integrate::leapfrog_start(x, v, 0.0, 0.05, pull);
  return {"sinks-into-the-planet",
          200,
          "turns",
          "radii from the planet",
          {run("RK4", 200, 20, 1,
               [&](double h) {
                 integrate::rk4(x, v, 0.0, h, pull);
                 return x.norm();
               }),
           run("leapfrog", 200, 20, 1, [&](double h) {
             integrate::leapfrog(y, w, 0.0, h, pull);
             return y.norm();
           })}};
}

// A door that moves by 20 cm/s, 100 km from the origin.
Sketch stands_still() {
  float x = 100'000;
  double y = 0;
  return {"stands-still",
          1,
          "t [s]",
          "m moved",
          {run("float from the origin", 1, 60, 0,
               [&](double h) {
                 x += float(h) * 0.2f;
                 return double(x) - 100'000;
               }),
           run("float from a place nearby", 1, 60, 0, [&](double h) { return y += h * 0.2; })}};
}

// A pendulum that begins nearly upright.
struct Pendulum {
  double angle = 3.1, spin = 0;

  double step(double h) {
    spin -= h * 10 * std::sin(angle);
    return angle += h * spin;
  }
};

// Its angles by steps of 1/60 s, which frames of any length bring.
template <class Frame>
std::vector<double> by_fixed_steps(int steps, Frame&& frame) {
  Pendulum pendulum;
  shelf::FixedStep<> clock{1 / 60.0};
  std::vector<double> angles;
  while (int(angles.size()) < steps) {
    clock.frame(frame(), [&](double) { angles.push_back(pendulum.step(clock.h)); });
  }
  return angles;
}

// How far apart two machines are, one of which has even frames and one those of the recording.
Sketch other_replay() {
  Pendulum even, uneven;
  frames::Playback frame;
  double ahead = 0;
  const auto by_frames = run("a step for each frame", 6, 60, 0, [&](double h) {
    even.step(h);
    for (ahead -= h; ahead < 0;) {
      const double length = frame.next();
      uneven.step(length);
      ahead += length;
    }
    return uneven.angle - even.angle;
  });
  frames::Playback again;
  const auto one = by_fixed_steps(points, [] { return 1 / 60.0; });
  const auto other = by_fixed_steps(points, [&] { return again.next(); });
  const auto by_steps = each("the same steps", points,
                             [&](int n) { return other[std::size_t(n)] - one[std::size_t(n)]; });
  return {"other-replay", 6, "t [s]", "rad apart", {by_frames, by_steps}};
}

// A spring without a damper for a minute, by recorded frames: how far it swings, at most, so far.
Sketch swings_higher_in_frames() {
  struct Spring {
    double x = 1, v = 0;

    double step(double h) {
      integrate::symplectic_euler(x, v, 0.0, h, [](double y, double, double) { return -400 * y; });
      return std::sqrt(x * x + v * v / 400);
    }
  };
  Spring uneven, even;
  frames::Playback frame;
  shelf::FixedStep<> clock{1 / 60.0};
  double swing = 1;
  return {
      "swings-higher-in-frames",
      60,
      "t [s]",
      "m of swing",
      {run("a step for each frame", 60, 60, 1, [&](double) { return uneven.step(frame.next()); }),
       run("FixedStep", 60, 60, 1, [&](double h) {
         clock.frame(h, [&](double) { swing = even.step(clock.h); });
         return swing;
       })}};
}

}  // namespace

std::vector<Sketch> sketches_of_long_runs() {
  return {spirals_out(), sinks_into_the_planet(), stands_still(), other_replay(),
          swings_higher_in_frames()};
}
