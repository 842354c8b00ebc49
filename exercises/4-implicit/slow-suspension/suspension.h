// SPDX-License-Identifier: MIT-0
/// @file
/// A spring and its steps by the trapezoid rule, and what else is made of them.
#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "format_values.h"
#include "harness.h"
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
    const double sign = 2.0 * random.whole(0, 1) - 1;
    return {
        {random.between(0.1, 0.3), sign * omega * random.between(0.1, 0.3)}, h, omega, zeta, steps};
  }

  // Each bound and each special value once, where the divisor is far from zero: a step back with a
  // heavy damper may divide by nothing.
  static std::vector<Suspension> at_the_bounds(Random& random) {
    std::vector<Suspension> scenes;
    const auto add = [&](double h, double omega, double zeta) {
      scenes.push_back(
          {{random.between(0.1, 0.3), omega * random.between(0.1, 0.3)}, h, omega, zeta, 5});
    };
    const auto light = [&] { return random.between(0.1, 0.5); };
    for (const double h : harness_bounds::h.asked()) add(h, random.between(5, 30), light());
    for (const double omega : harness_bounds::omega.asked()) {
      add(-random.between(0.01, 0.04), omega, light());
      add(harness_bounds::h.largest(), omega, light());
    }
    for (const double zeta : harness_bounds::zeta.asked())
      add(random.between(0.01, 0.04), random.between(20, 80), zeta);
    return scenes;
  }

  // Long enough for a swing that is slower by a hundredth to fall behind.
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

  // From (1 - h/2 A) end = (1 + h/2 A) start, by Cramer's rule.
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

  // In units of length, in which the energy is a sum of two squares.
  double size(const Swing& s) const { return std::hypot(s.x, s.v / omega); }
  double apart(const Swing& a, const Swing& b) const { return size({a.x - b.x, a.v - b.v}); }

  std::string described() const {
    return "x = " + grade::number(start.x, 17) + ", v = " + grade::number(start.v, 17) +
           ", h = " + grade::number(h, 17) + ", omega = " + grade::number(omega, 17) +
           ", zeta = " + grade::number(zeta, 17);
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

// What a wrong first step often is: the trapezoid rule's change of velocity over another divisor,
// or another move.
inline std::vector<std::string> recognised(const Suspension& scene, const Swing& got,
                                           double within) {
  const auto [x, v] = scene.start;
  const double h = scene.h, half = h / 2;
  const double k = scene.omega * scene.omega, c = 2 * scene.zeta * scene.omega;
  const double push = half * (-k * (2 * x + h * v) - 2 * c * v);
  const auto divided = [&](double by) {
    return Swing{x + h * v + half * push / by, v + push / by};
  };
  const double v_right = scene.after_one(scene.start).v;
  Suspension forward = scene;
  forward.h = std::abs(h);
  const double right = 1 + half * c + half * half * k, v_symplectic = v - h * (k * x + c * v);
  const double v_backward = (v - h * k * x) / (1 + h * c + h * h * k);
  const std::pair<Swing, const char*> known[] = {
      {divided(1 + half * c + half * h * k), "this is the step of the code as it was"},
      {forward.after_one(scene.start), "this is a step forward, and h is negative: it goes back"},
      {divided(1), "this is the step of Heun's method: nothing is divided"},
      {divided(1 + h * c + half * half * k), "the damping in the divisor is not halved"},
      {divided(1 + half / 2 * c + half * half * k), "the damping in the divisor is halved twice"},
      {divided(1 + half * half * c + half * half * k),
       "the damping in the divisor is multiplied by h / 2 twice"},
      {divided(1 + half * c + half * half * half * k),
       "in the divisor h / 2 stands three times before omega^2"},
      {{x + h * v_backward, v_backward}, "this is backward Euler"},
      {{x + h * v + half * half * push / right, v + push / right},
       "the velocity is right; in the place its change is halved twice"},
      {{x + h * v_symplectic, v_symplectic}, "this is symplectic Euler"},
      {{x + h * v_right, v_right}, "the velocity is right; the place moved with the new one alone"},
  };
  for (const auto& [end, says] : known) {
    if (scene.apart(got, end) <= within) return {says};
  }
  if (std::abs(scene.size(got) - scene.size(scene.start)) <= within && c > 0)
    return {"the energy stays, and the damper should have taken some of it"};
  return {};
}

// What is told in place of the right omega.
inline std::vector<std::string> slips(double told, double omega, double h) {
  if (!std::isfinite(told)) return {"told is not a finite number"};
  const double half = omega * h / 2;
  const std::pair<double, const char*> known[] = {
      {omega, "this is the omega that is wanted; told that, the rule turns it too little"},
      {2 / h * std::atan(half),
       "this is how fast the rule swings if it is told omega; asked is the way back"},
      {2 * std::tan(half), "this is an angle, and not a rate: it has not been divided by h"},
      {std::tan(2 * half) / h, "this is tan(omega h) / h: the angle was not halved"},
      {std::tan(half) / h, "half of what should be told"},
      {2 / h * std::sin(half), "a sine, where the trapezoid rule has a tangent"},
      {2 / h * std::tan(half * std::numbers::pi / 180), "an angle in degrees: tan takes radians"},
  };
  for (const auto& [value, says] : known) {
    if (std::abs(told - value) <= 1e-10 * omega) return {says};
  }
  return {};
}

}  // namespace judge::slow_suspension
