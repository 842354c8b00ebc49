// SPDX-License-Identifier: MIT-0
#include "shelf/jump.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "frames/recorded.h"
#include "measure/shelf_card.h"

namespace measure::shelf_cards {
namespace {

// A jump 4 m high, 0.44 s to its top, down in 0.3 s, whose button may be let go on the way.
struct Flight {
  shelf::Jump<double> jump = shelf::jump_to(4.0, 0.44);
  double falling = shelf::jump_to(4.0, 0.3).gravity;
  double released = shelf::jump_gravity(jump.speed, 1.0);
  double let_go = 1;  // [s]

  // Where it is by the laws of a stone that is thrown, part by part.
  double height(double t) const {
    const double held = std::min(let_go, jump.speed / jump.gravity);
    if (t <= held) return thrown(jump.speed, jump.gravity, t);
    const double speed = jump.speed - jump.gravity * held, top = held + speed / released;
    const double below = thrown(jump.speed, jump.gravity, held);
    if (t <= top) return below + thrown(speed, released, t - held);
    return below + speed * speed / (2 * released) + thrown(0, falling, t - top);
  }

 private:
  static double thrown(double speed, double pull, double t) { return speed * t - pull * t * t / 2; }
};

// How far it is at most off in three quarters of a second, in frames of these lengths. The button
// is let go between two of them.
template <class Frame>
double off_in(Flight flight, Frame frame) {
  double x = 0, v = flight.jump.speed, off = 0;
  const double asked = flight.let_go;
  bool held = true;
  for (double t = 0; t < 0.75;) {
    if (held && t >= asked) held = false, flight.let_go = t;
    const double h = frame();
    shelf::jump_step(x, v, held ? flight.jump.gravity : flight.released, flight.falling, h);
    t += h;
    if (!held || t < asked) off = std::max(off, std::abs(x - flight.height(t)));
  }
  return off;
}

Promise exact(const std::string& words, double let_go) {
  Flight flight;
  flight.let_go = let_go;
  frames::Playback recorded;
  double off = off_in(flight, [&] { return recorded.next(); });
  for (const double rate : {15.0, 30.0, 50.0, 60.0, 240.0, 1000.0})
    off = std::max(off, off_in(flight, [&] { return 1 / rate; }));
  return {words, off < 1e-12 * 4, off / 4};
}

Promise top() {
  const shelf::Jump<double> jump = shelf::jump_to(4.0, 0.44);
  double off = 0;
  for (const int steps : {1, 7, 22, 1000}) {
    double x = 0, v = jump.speed;
    for (int n = 0; n < steps; ++n)
      shelf::jump_step(x, v, jump.gravity, jump.gravity, 0.44 / steps);
    off = std::max({off, std::abs(x - 4), std::abs(v)});
  }
  return {
      "after the time that was asked for it is as high as was asked for, and at its top, to "
      "1e-13 of it, in 1 step and in 1000",
      off < 1e-13 * 4, off / 4};
}

// The top that symplectic Euler comes to.
double top_of_velocity_first(double h) {
  const shelf::Jump<double> jump = shelf::jump_to(4.0, 0.44);
  double x = 0, v = jump.speed, top = 0;
  for (double t = 0; t < 0.5; t += h) {
    v = v - h * jump.gravity;
    x = x + h * v;
    top = std::max(top, x);
  }
  return top;
}

Promise others() {
  const double at_50 = top_of_velocity_first(1 / 50.0), at_15 = top_of_velocity_first(1 / 15.0);
  return {"of 4 m a step that changes the velocity first reaches 3.82 at 50 Hz and 3.42 at 15 Hz",
          std::round(100 * at_50) == 382 && std::round(100 * at_15) == 342, at_15, 3, "m"};
}

Promise lowest() {
  double off = 0;
  for (const double height : {0.1, 1.0, 3.9}) {
    const Flight flight;
    const double pull = shelf::jump_gravity(flight.jump.speed, height);
    double x = 0, v = flight.jump.speed;
    shelf::jump_step(x, v, pull, pull, flight.jump.speed / pull);
    off = std::max(off, std::abs(x / height - 1));
  }
  return {"let go at once it rises as high as was asked for, to 1e-15 of it", off < 1e-15, off};
}

}  // namespace

ShelfCard jump() {
  return {"jump",
          {top(),
           exact("held all the way it is where a stone would be that is thrown under the one pull "
                 "and falls under the other, to 1e-12 of the height, at 15 to 1000 Hz and in "
                 "recorded frames",
                 1),
           exact("let go after a tenth of a second, too, by frames of any length", 0.1), lowest(),
           others()}};
}

}  // namespace measure::shelf_cards
