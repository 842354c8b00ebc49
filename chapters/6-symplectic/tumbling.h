// SPDX-License-Identifier: MIT-0
/// @file
/// The thrown body of chapter 6: what four ways of turning it make of its energy, and where it is.
#pragma once
#include <Eigen/Dense>
#include <algorithm>

#include "measure/record.h"
#include "scenes/euler_top.h"
#include "shelf/orientation.h"

/// A body with moments of 1, 2 and 3, thrown about its middle axis with 20 rad/s.
struct Tumbling {
  shelf::Vec3<double> inertia{1, 2, 3};
  shelf::Quaternion<double> q{};
  shelf::Vec3<double> L{0.2, 40, 0.6};

  /// Half the product of spin and angular momentum [J].
  double energy() const { return 0.5 * dot(shelf::angular_velocity(q, L, inertia), L); }

  /// By what angle it is turned against the exact solution [rad].
  double off(double t) const {
    using Top = scenes::EulerTop;
    const Eigen::Quaternion<Top::Real> turned(q.w, q.x, q.y, q.z);
    return double(Top::angle_between(turned.normalized().toRotationMatrix(), Top{}.orientation(t)));
  }
};

// Four ways to turn it. The angular momentum stays but in Bullet's, which gives it a new one.
inline constexpr auto by_its_spin = [](Tumbling& body, double h) {
  shelf::turn_exact(body.q, shelf::angular_velocity(body.q, body.L, body.inertia), h);
};
inline constexpr auto by_bullet = [](Tumbling& body, double h) {
  shelf::spin_by_bullet(body.q, body.L, body.inertia, h);
};
inline constexpr auto by_rotations = [](Tumbling& body, double h) {
  shelf::spin_by_rotations(body.q, body.L, body.inertia, h);
};
inline constexpr auto by_midpoint = [](Tumbling& body, double h) {
  shelf::spin_by_midpoint(body.q, body.L, body.inertia, h);
};

/// By what angle it is turned wrong at most in the first second, in sixty steps [rad].
template <class Way>
double largest_off(Way way) {
  Tumbling body;
  double largest = 0;
  for (int n = 1; n <= 60; ++n) {
    way(body, 1 / 60.0);
    largest = std::max(largest, body.off(n / 60.0));
  }
  return largest;
}

/// The thrown body after a time, in sixty steps a second.
template <class Way>
Tumbling tumbled(Way way, int seconds) {
  Tumbling body;
  for (int n = 0; n < 60 * seconds; ++n) way(body, 1 / 60.0);
  return body;
}

inline void tumbling(measure::Record& record) {
  auto& table = record.table(
      "tumbling",
      {{"turned by"}, {"energy after ten seconds", "%", 4}, {"turned wrong within one", "rad", 2}});
  const auto add = [&](const char* name, auto way) {
    const double energy = tumbled(way, 10).energy() / Tumbling{}.energy();
    table.add({name, 100 * energy, largest_off(way)});
  };
  add("its spin at the start of the step", by_its_spin);
  add("Bullet's gyroscopic step", by_bullet);
  add("midpoint rule", by_midpoint);
  add("rotations", by_rotations);
}
