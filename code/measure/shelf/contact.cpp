// SPDX-License-Identifier: MIT-0
#include "shelf/contact.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <random>

#include "integrate/rk4.h"
#include "measure/crate.h"
#include "measure/shelf_card.h"

namespace measure::shelf_cards {
namespace {

using Box = Crate<double>;
using Vec = shelf::Vec3<double>;
constexpr double g = Box::g, frame = 1 / 60.0;
constexpr std::array rates{30, 60, 120, 240};

Promise flight() {
  double off = 0;
  for (const int rate : rates) {
    Box box;
    box.x = {0, 50, 0}, box.v = {3, 4, 0};
    for (int n = 0; n < rate; ++n) box.step(1.0 / rate, {0.5, 0, 0.5});
    off = std::max(off, std::abs(box.x.y - (54 - g / 2)));
  }
  return {"what touches nothing falls without error, to 10^-12 m in a second", off < 1e-12, off, 2,
          "m"};
}

// What is worst of a crate let fall from half a metre, in many ways.
struct Fallen {
  double rests_after = 0, sinks = 0, gains = 0, leaves = 0, moves = 0;

  void let_fall(Box box, int rate, double restitution) {
    const double h = 1.0 / rate, begun = box.energy(), met = std::sqrt(2 * 0.5 / g);
    double energy = begun;
    for (int n = 1; n * h <= 3; ++n) {
      box.step(h, {0.5, restitution, 0.5});
      gains = std::max(gains, (box.energy() - energy) / begun);
      energy = box.energy();
      sinks = std::max(sinks, -box.lowest());
      if (box.speed() > 0.01) rests_after = std::max(rests_after, n * h - met);
      if (n * h > 2) moves = std::max(moves, box.speed());
    }
    leaves = std::max(leaves, std::abs(box.lowest()));
  }
};

const Fallen& fallen() {
  static const Fallen all = [] {
    Fallen worst;
    std::mt19937 random(5);
    const auto number = [&](double most) {
      return std::uniform_real_distribution<double>(-most, most)(random);
    };
    for (int n = 0; n < 12; ++n) {
      Box box;
      shelf::turn_exact(box.q, {number(0.3), number(0.3), number(0.3)}, 1);
      box.spin_with({number(1), number(1), number(1)});
      box.lift_to(0.5);
      for (const int rate : rates) {
        for (const double restitution : {0.0, 0.3}) worst.let_fall(box, rate, restitution);
      }
    }
    return worst;
  }();
  return all;
}

Promise rest() {
  const double after = fallen().rests_after;
  return {
      "crates of 80 by 60 by 60 cm, let fall from half a metre with a friction of 0.5, tilted by "
      "up to 0.3 rad about each axis and spinning by 1 rad/s, are at rest a second after they meet "
      "the floor, with a restitution of 0 and of 0.3, at 30, 60, 120 and 240 Hz",
      after < 1, after, 3, "s"};
}

Promise sunk() {
  const double deep = 1e3 * fallen().sinks;
  return {"of those measured no corner is ever more than 1 mm within the floor", deep < 1, deep, 2,
          "mm"};
}

// What is worst of one that is thrown and spins, at 60 Hz.
struct Thrown {
  double sinks = 0, gains = 0;
};

const Thrown& thrown() {
  static const Thrown all = [] {
    Thrown worst;
    std::mt19937 random(7);
    const auto number = [&](double most) {
      return std::uniform_real_distribution<double>(-most, most)(random);
    };
    for (int n = 0; n < 100; ++n) {
      Box box;
      shelf::turn_exact(box.q, {number(3), number(3), number(3)}, 1);
      box.spin_with({number(12), number(12), number(12)});
      box.v = {number(3), 0, number(3)};
      box.lift_to(0.5);
      const double begun = box.energy();
      double least = begun;
      for (int step = 0; step < 90; ++step) {
        box.step(frame, {0.2 + 0.2 * (n % 4), 0.1 * (n % 11), 0.5});
        worst.sinks = std::max(worst.sinks, -1e3 * box.lowest());
        worst.gains = std::max(worst.gains, 100 * (box.energy() - least) / begun);
        least = std::min(least, box.energy());
      }
    }
    return worst;
  }();
  return all;
}

Promise dips() {
  const double deep = thrown().sinks;
  return {
      "thrown so that it spins with up to 12 rad/s about each axis, none of a hundred dips into "
      "the floor by more than 3 mm at 60 Hz, with a friction of up to 0.8",
      deep < 3, deep, 2, "mm"};
}

Promise thrown_energy() {
  const double gain = thrown().gains;
  return {
      "thrown so, and with a restitution of up to 1, none of the hundred ever has 1 % of its first "
      "energy more than it had before",
      gain < 1, gain, 2, "%"};
}

Promise still() {
  const double most = std::max(fallen().moves, fallen().leaves);
  return {"at rest it moves by less than 10^-12 m/s, and lies on the floor to 10^-12 m",
          most < 1e-12, most, 2};
}

Promise energy() {
  const double gain = fallen().gains;
  return {"of those measured the energy grows in no step by more than 10^-6 of all", gain < 1e-6,
          gain};
}

Box on_slope(double angle) {
  Box box;
  box.up = {std::sin(angle), std::cos(angle), 0};
  shelf::turn_exact(box.q, {0, 0.3, 0}, 1);
  shelf::turn_exact(box.q, {0, 0, -angle}, 1);
  box.lift_to(0);
  return box;
}

double away(const Vec& from, const Vec& to) {
  const Vec way = to + -1.0 * from;
  return std::sqrt(dot(way, way));
}

Promise creep() {
  double most = 0;
  for (const int rate : {30, 120}) {
    Box box = on_slope(std::atan(0.5) - 0.01);
    const Vec start = box.x;
    for (int n = 0; n < 60 * rate; ++n) box.step(1.0 / rate, {0.5, 0, 0.5});
    most = std::max(most, away(start, box.x));
  }
  return {"on a slope 0.01 rad below the angle of friction it creeps by less than 10^-6 m a minute",
          most < 1e-6, most, 2, "m"};
}

Promise slide() {
  double off = 0;
  for (const double mu : {0.1, 0.3, 0.6}) {
    for (const int rate : rates) {
      const double angle = std::atan(mu) + 0.1, pull = g * (std::sin(angle) - mu * std::cos(angle));
      Box box = on_slope(angle);
      const Vec start = box.x;
      for (int n = 0; n < 2 * rate; ++n) box.step(1.0 / rate, {mu, 0, 0.5});
      off = std::max(off, std::abs(away(start, box.x) / (2 * pull) - 1));
    }
  }
  return {
      "0.1 rad beyond that angle it slides with g (sin a - mu cos a), to 10^-10 of the way in "
      "two seconds",
      off < 1e-10, off};
}

// Its corners brake a flat thing that spins: four times the push mu m g / 4 at the arm of a corner.
Promise spun() {
  double late = 0;
  for (const Vec size : {Vec{0.8, 0.6, 0.6}, Vec{2, 0.05, 2}, Vec{1, 1, 1}, Vec{1, 0.2, 0.3}}) {
    for (const int rate : rates) {
      Box box;
      box.size = size;
      box.lift_to(0);
      box.spin_with({0, 6, 0});
      const double arm = std::hypot(size.x, size.z) / 2;
      const double wanted = box.L.y / (0.4 * Box::mass * g * arm);
      int n = 0;
      while (box.speed() > 1e-3 && n < 20 * rate) box.step(1.0 / rate, {0.4, 0, 0.5}), ++n;
      late = std::max(late, std::abs(n - wanted * rate));
    }
  }
  return {
      "a box that spins flat on the floor is braked by its four corners for as long as the "
      "integral over them says, to two steps",
      late < 2, late, 2, "steps"};
}

// A plate without height, which slides and spins: where it comes to lie, by RK4 in 20,000 steps a
// second. Each corner carries a quarter, and is braked against its slip.
std::array<double, 3> plate_lies(double width, double speed, double spin) {
  std::array<double, 3> place{};
  struct State {
    double x, z, w;
    State operator+(const State& s) const { return {x + s.x, z + s.z, w + s.w}; }
  };
  State v{speed, 0, spin};
  const double h = 5e-5, half = width / 2, radius = half * half * 2 / 3;
  const auto rate = [&](const State& now, double angle) {
    State sum{0, 0, 0};
    for (int i = 0; i < 4; ++i) {
      const double x0 = i & 1 ? half : -half, z0 = i & 2 ? half : -half;
      const double x = x0 * std::cos(angle) + z0 * std::sin(angle);
      const double z = z0 * std::cos(angle) - x0 * std::sin(angle);
      const double vx = now.x + now.w * z, vz = now.z - now.w * x, slip = std::hypot(vx, vz);
      const double push = slip > 0 ? 0.3 * g / 4 / slip : 0;
      sum = sum + State{-push * vx, -push * vz, -push * (z * vx - x * vz) / radius};
    }
    return sum;
  };
  const auto times = [](double s, const State& a) { return State{s * a.x, s * a.z, s * a.w}; };
  while (std::hypot(v.x, v.z) + std::abs(v.w) > 0.3 * g * h * 4) {
    const double angle = place[2];
    const State k1 = rate(v, angle);
    const State k2 = rate(v + times(h / 2, k1), angle + h / 2 * v.w);
    const State end = v + times(h, k2);
    place[0] += h * (v.x + end.x) / 2, place[1] += h * (v.z + end.z) / 2;
    place[2] += h * (v.w + end.w) / 2;
    v = end;
  }
  return place;
}

double plate_off(double width, double speed, double spin) {
  Box box;
  box.size = {width, 1e-6, width};
  box.corners = 4;
  box.lift_to(0);
  box.v = {speed, 0, 0};
  box.spin_with({0, spin, 0});
  for (int n = 0; n < 60 * 5; ++n) box.step(frame, {0.3, 0, 0.5});
  const auto [x, z, angle] = plate_lies(width, speed, spin);
  return std::hypot(box.x.x - x, box.x.z - z);
}

Promise plate() {
  const double off = std::max(
      {plate_off(1, 3, 6), plate_off(1, 2, -9), plate_off(0.5, 4, 20), plate_off(2, 1, 3)});
  return {
      "a plate that slides and spins lies, at 60 Hz, within 2 cm of where steps of 1/20000 s over "
      "its four corners take it, after up to 4.2 m",
      off < 0.02, off, 2, "m"};
}

// A crate that stands on an edge, 0.1 rad out of balance: how far from a pendulum upside down.
double topple_off(int rate) {
  Box box;
  const double reach = 0.5, balance = std::atan2(0.8, 0.6), slow = reach * reach + 1 / 12.0;
  shelf::turn_exact(box.q, {0, 0, balance + 0.1}, 1);
  box.lift_to(0);
  double angle = 0.1, turning = 0;
  const auto pull = [&](double now, double, double) { return g * reach / slow * std::sin(now); };
  for (int n = 0; n < 6'000; ++n) integrate::rk4(angle, turning, 0.0, 1e-4, pull);
  for (int n = 0; n < 6 * rate / 10; ++n) box.step(1.0 / rate, {1, 0, 0.5});
  return std::abs(std::acos(box.x.y / reach) - angle);
}

Promise topple() {
  const double off = topple_off(60);
  return {
      "a crate that topples over an edge is, at 60 Hz, within 0.02 rad of a pendulum upside down",
      off < 0.02, off, 2, "rad"};
}

// A ball of 5.7 cm on a table that begins to slide with 3 m/s, in a plane.
struct Ball {
  using Flat = std::complex<double>;
  static constexpr double mass = 0.17, radius = 0.0285, start = 3, friction = 0.2;
  Flat x{0, radius}, v{start};
  double L = 0;
  shelf::Contact<Flat, double> foot;

  static double spin(double now) { return now / (0.4 * mass * radius * radius); }
  double slip() const { return v.real() + radius * spin(L); }

  void step(double h) {
    foot.r = Flat(0, -radius), foot.normal = Flat(0, 1), foot.gap = x.imag() - radius;
    const shelf::Surface<double> table{friction, 0.5, 0.5};
    x += h * shelf::contact_step(v, L, Flat(0, -g), h, &foot, 1, table, 1 / mass, spin,
                                 FlatProducts::dot, FlatProducts())
                 .v;
  }
};

Promise ball() {
  double off = 0, late = 0;
  for (const int rate : rates) {
    Ball ball;
    int n = 0;
    for (; ball.slip() > 1e-9 && n < 3 * rate; ++n) ball.step(1.0 / rate);
    late = std::max(late, std::abs(n - 2 * Ball::start / (7 * Ball::friction * g) * rate));
    for (n = 0; n < 10 * rate; ++n) ball.step(1.0 / rate);
    off = std::max(off, std::abs(ball.v.real() / Ball::start - 5 / 7.0));
  }
  return {
      "a ball that begins to slide rolls with 5/7 of its speed in the end, to 10^-12 of it, and "
      "comes to that within a step of when it is due",
      off < 1e-12 && late < 1, off};
}

}  // namespace

ShelfCard contact() {
  return {"contact",
          {flight(), rest(), sunk(), energy(), dips(), thrown_energy(), still(), creep(), slide(),
           spun(), plate(), topple(), ball()}};
}

}  // namespace measure::shelf_cards
