// SPDX-License-Identifier: MIT-0
// What touches a floor, a wall, a slope and a platform.
#include <cmath>
#include <complex>

#include "shelf/bounce.h"
#include "shelf/contact.h"
#include "shelf/orientation.h"
#include "shelf/wheel.h"
#include "sketch.h"

namespace {

using Flat = std::complex<double>;

const auto dot = [](const Flat& a, const Flat& b) { return std::real(a * std::conj(b)); };

// What everybody writes first: a step, and below the floor the velocity is turned round.
struct Turned {
  double x, v, restitution;
  bool put_back;  // onto the floor

  double step(double h) {
    v -= h * g;
    x += h * v;
    if (x < 0) v = -restitution * v;
    if (x < 0 && put_back) x = 0;
    return x;
  }
};

Line by_hand(const char* label, double seconds, Turned ball) {
  return run(label, seconds, 60, ball.x, [=](double h) mutable { return ball.step(h); });
}

Line by_bounce_step(double seconds, double start, double restitution, bool speed = false) {
  double x = start, v = 0;
  const shelf::Plane<double, double> floor{1, 0, restitution, 0, restitution < 1 ? 0.5 : 0};
  return run("bounce_step", seconds, 60, speed ? 0 : start, [=](double h) mutable {
    shelf::bounce_step(x, v, -g, h, floor, product);
    return speed ? v : x;
  });
}

Sketch trembles() {
  return {"trembles",
          3,
          "t [s]",
          "m",
          {by_hand("below: v = -0.6 v", 3, {0.5, 0, 0.6, false}), by_bounce_step(3, 0.5, 0.6)}};
}

Sketch never_rests() {
  Turned ball{0.01, 0, 0.6, true};
  return {"never-rests",
          1,
          "t [s]",
          "m/s",
          {run("below: x = 0, v = -0.6 v", 1, 60, 0,
               [&](double h) {
                 ball.step(h);
                 return ball.v;
               }),
           by_bounce_step(1, 0.01, 0.6, true)}};
}

Sketch bounces_higher() {
  double x = 1, v = 0;
  return {"bounces-higher",
          8,
          "t [s]",
          "m",
          {run("place, velocity, v = -v", 8, 60, 1,
               [&](double h) {
                 x += h * v;
                 v -= h * g;
                 if (x < 0) x = 0, v = -v;
                 return x;
               }),
           by_bounce_step(8, 1, 1)}};
}

// A crate of 1 kg that a spring of 100 N/m keeps out of the floor.
Sketch sinks() {
  double x = 0.2, v = 0, y = 0.2, w = 0;
  const shelf::Plane<double, double> floor{1, 0, 0, 0, 0.5};
  return {"sinks",
          2,
          "t [s]",
          "m",
          {run("pushed out by a spring", 2, 60, 0.2,
               [&](double h) {
                 v += h * (-g + (x < 0 ? -100 * x - 8 * v : 0));
                 return x += h * v;
               }),
           run("bounce_step", 2, 60, 0.2, [&](double h) {
             shelf::bounce_step(y, w, -g, h, floor, product);
             return y;
           })}};
}

// Sixty metres a second, at a wall of 20 cm that is 3.3 m on.
Sketch goes_through() {
  double x = 0, y = 0, w = 60;
  const shelf::Plane<double, double> wall{-1, -3.3, 0.2, 0, 0.5};
  return {"goes-through",
          0.2,
          "t [s]",
          "m",
          {run("looks where it is", 0.2, 60, 0,
               [&](double h) {
                 x += h * 60;
                 return x > 3.3 && x < 3.5 ? x = 3.3 : x;
               }),
           run("bounce_step", 0.2, 60, 0, [&](double h) {
             shelf::bounce_step(y, w, 0.0, h, wall, product);
             return y;
           })}};
}

// A crate on a slope of 20 degrees, at rest, with a friction of 0.5: how far it has slid.
Sketch creeps() {
  const double slope = 20 * std::numbers::pi / 180;
  const Flat a = g * Flat(std::sin(slope), -std::cos(slope)), up(0, 1);
  double x = 0, v = 0;
  Flat y = 0, w = 0;
  return {"creeps",
          4,
          "t [s]",
          "m",
          {run("a brake of 20 /s", 4, 60, 0,
               [&](double h) {
                 v = (v + h * g * std::sin(slope)) / (1 + 20 * h);
                 return x += h * v;
               }),
           run("friction", 4, 60, 0, [&](double h) {
             w = w + h * a;
             const double push = shelf::bounce(w, up, 0.0, 1.0, dot);
             shelf::friction(w, up, 0.5 * push, dot);
             y = y + h * w;
             return std::real(y);
           })}};
}

// A platform that goes up and down by 2 m at 2 rad/s, and the gap under what stands on it.
struct Platform {
  double height(double t) const { return 2 * std::sin(2 * t); }
  shelf::MovingPlane<double, double> at(double t) const {
    return {{1, 0, 0, 0, 0.5}, height(t), 4 * std::cos(2 * t)};
  }
};

Line on_a_platform(const char* label, bool moves) {
  const Platform platform;
  double x = 0, v = 4, t = 0;
  return run(label, 6, 60, 0, [=](double h) mutable {
    const double before = t;
    t += h;
    if (moves) {
      shelf::bounce_step(x, v, -g, h, platform.at(before), platform.at(t), product);
    } else {
      const shelf::Plane<double, double> floor{1, platform.height(t), 0, 0, 0.5};
      shelf::bounce_step(x, v, -g, h, floor, product);
    }
    return x - platform.height(t);
  });
}

Sketch leaves_the_platform() {
  return {"leaves-the-platform",
          6,
          "t [s]",
          "m of a gap",
          {on_a_platform("the floor put elsewhere", false), on_a_platform("MovingPlane", true)}};
}

// A corner of a car: 240 kg on 30 kN/m and a damper of 30 kN s/m, at 15 Hz.
Sketch car_shakes() {
  double x = 0.1, v = 0, y = 0.1, w = 0, force = 0;
  return {"car-shakes",
          2,
          "t [s]",
          "m",
          {run("the force of the start", 2, 15, 0.1,
               [&](double h) {
                 const double push = x < 0 ? std::max(0.0, -30e3 * x - 30e3 * v) : 0;
                 v += h * (push / 240 - g);
                 return x += h * v;
               }),
           run("wheel_push", 2, 15, 0.1, [&](double h) {
             w += h * (force / 240 - g);
             w += shelf::wheel_push(force, -y, w, 1 / 240.0, {30e3, 30e3}, h) / 240;
             return y += h * w;
           })}};
}

// A crate of 80 by 60 cm and 20 kg, let fall aslant, in the plane: the speed of its middle.
struct Crate {
  Flat x{0, 0.7}, v = 0;
  double angle = 0.3, L = 0;
  static constexpr double moment = 20 * (0.8 * 0.8 + 0.6 * 0.6) / 12;

  Flat corner(int i) const {
    return std::polar(1.0, angle) * Flat(i % 2 == 0 ? 0.4 : -0.4, i < 2 ? 0.3 : -0.3);
  }
  static double spin(double L) { return L / moment; }

  // Each corner that is below the floor is stopped, one after the other.
  void stop_corners(double h) {
    v += h * Flat(0, -g);
    for (int i = 0; i < 4; ++i) {
      const Flat r = corner(i);
      const double height = (x + r).imag(), rises = v.imag() + spin(L) * r.real();
      if (height > 0 || rises > 0) continue;
      const double push = -1.3 * rises / (1 / 20.0 + r.real() * r.real() / moment);
      v += Flat(0, push / 20);
      L += r.real() * push;
    }
    x += h * v;
    angle += h * spin(L);
  }

  void by_contacts(shelf::Contact<Flat, double> (&contacts)[4], double h) {
    struct {
      double operator()(Flat r, Flat push) const { return (std::conj(r) * push).imag(); }
      Flat operator()(double w, Flat r) const { return Flat(0, w) * r; }
    } const cross;
    for (int i = 0; i < 4; ++i) {
      contacts[i].r = corner(i);
      contacts[i].normal = Flat(0, 1);
      contacts[i].gap = (x + contacts[i].r).imag();
    }
    const auto way = shelf::contact_step(
        v, L, Flat(0, -g), h, contacts, 4, shelf::Surface<double>{0.5, 0.3, 0.5}, 1 / 20.0,
        [](double momentum) { return spin(momentum); }, dot, cross);
    x += h * way.v;
    angle += h * spin(way.L);
  }
};

Sketch never_settles() {
  Crate one, other;
  shelf::Contact<Flat, double> contacts[4];
  return {"never-settles",
          3,
          "t [s]",
          "rad aslant",
          {run("each corner for itself", 3, 60, 0.3,
               [&](double h) {
                 one.stop_corners(h);
                 return one.angle;
               }),
           run("contact_step", 3, 60, 0.3, [&](double h) {
             other.by_contacts(contacts, h);
             return other.angle;
           })}};
}

}  // namespace

std::vector<Sketch> sketches_of_contacts() {
  return {trembles(), never_rests(),         bounces_higher(), sinks(),        goes_through(),
          creeps(),   leaves_the_platform(), car_shakes(),     never_settles()};
}
