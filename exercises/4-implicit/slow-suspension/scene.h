// SPDX-License-Identifier: MIT-0
/// @file
/// A spring and its steps by the trapezoid rule, and what else is made of them.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "harness.h"
#include "judge/describe.h"
#include "judge/random.h"
#include "judge/session.h"
#include "judge/student.h"

namespace judge::slow_suspension {

struct Swing {
  double x = 0, v = 0;
};

struct Suspension {
  Swing start;
  double h = 0, omega = 0, zeta = 0;
  int steps = 0;

  static Suspension draw(Random& random, double angle, double zeta, int steps) {
    const double h = random.between(0.01, 0.04), omega = angle / h;
    const double sign = random.sign();
    return {
        {random.between(0.1, 0.3), sign * omega * random.between(0.1, 0.3)}, h, omega, zeta, steps};
  }

  // A step of anything that may be asked, but for a step back with a damper so heavy that it
  // divides by nearly nothing.
  static Suspension anywhere(Random& random) {
    Suspension scene;
    do {
      scene.start = {random.anywhere(harness_bounds::place),
                     random.anywhere(harness_bounds::velocity)};
      scene.h = random.anywhere(harness_bounds::h);
      scene.omega = random.anywhere(harness_bounds::omega);
      scene.zeta = random.anywhere(harness_bounds::zeta);
    } while (!scene.askable());
    scene.steps = 1;
    return scene;
  }

  // A run long enough for a swing that is slower by a hundredth to fall behind.
  static Suspension a_minute(Random& random) {
    Suspension scene = draw(random, random.between(0.4, 1.2), 0, 0);
    scene.steps = static_cast<int>(60 / scene.h);
    return scene;
  }

  std::vector<Swing> by(Student& student) const {
    const auto n = student.call(0, {start.x, start.v, h, omega, zeta, double(steps)},
                                static_cast<std::size_t>(2 * steps));
    std::vector<Swing> path{start};
    for (std::size_t i = 0; i < n.size(); i += 2) path.push_back({n[i], n[i + 1]});
    return path;
  }

  // The share of the divisor that cancels: what it sums up over what is left.
  double cancels() const {
    const double half = h * omega / 2, brake = 2 * zeta * half, pull = half * half;
    return (1 + std::abs(brake) + pull) / std::abs(1 + brake + pull);
  }
  bool askable() const { return cancels() <= 100; }

  // The numbers that a step sums up, all with one sign, over what it divides by; and what that has
  // lost counts in full.
  double summed() const {
    const double half = std::abs(h) * omega / 2, brake = 2 * zeta * half;
    const double x = std::abs(start.x), v = std::abs(start.v) / omega;
    const double pushed = half * x + (1 + brake) * v + half * (x + half * v);
    const double divisor = (1 + brake + half * half) / cancels();
    return x + half * v + (1 + half) * pushed / divisor * cancels();
  }

  // One step, from (1 - h/2 A) end = (1 + h/2 A) start, by Cramer's rule.
  Swing after_one(const Swing& s) const {
    const double half = h / 2, k = omega * omega, c = 2 * zeta * omega;
    const double top = s.x + half * s.v, bottom = s.v + half * (-k * s.x - c * s.v);
    const double determinant = 1 + half * c + half * half * k;
    return {((1 + half * c) * top + half * bottom) / determinant,
            (bottom - half * k * top) / determinant};
  }

  std::vector<Swing> right() const {
    std::vector<Swing> path{start};
    for (int n = 0; n < steps; ++n) path.push_back(after_one(path.back()));
    return path;
  }

  // The largest number that a right path has in it.
  double largest() const {
    double most = 0;
    for (const Swing& s : right()) most = std::max(most, size(s));
    return most;
  }

  // The size in units of length, in which the energy is a sum of two squares.
  double size(const Swing& s) const { return std::hypot(s.x, s.v / omega); }
  double apart(const Swing& a, const Swing& b) const { return size({a.x - b.x, a.v - b.v}); }

  std::string described() const {
    return named("x", start.x, "v", start.v, "h", h, "omega", omega, "zeta", zeta);
  }

  grade::Curve sizes(const std::string& name, const std::vector<Swing>& path) const {
    grade::Curve found = curve(name, path);
    for (std::size_t n = 0; n < found.y.size(); ++n) found.y[n] = size(path[n]);
    return found;
  }

  grade::Curve curve(const std::string& name, const std::vector<Swing>& path) const {
    grade::Curve curve{name, {}, {}};
    for (std::size_t n = 0; n < std::min<std::size_t>(path.size(), 60); ++n) {
      curve.x.push_back(static_cast<double>(n) * h);
      curve.y.push_back(path[n].x);
    }
    return curve;
  }

  grade::Plot plot(const std::vector<Swing>& yours) const {
    return {"The suspension",
            "time [s]",
            "stretch [m]",
            {curve("yours", yours), curve("the trapezoid rule", right())}};
  }
};

}  // namespace judge::slow_suspension
