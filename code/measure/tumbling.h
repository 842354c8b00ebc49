// SPDX-License-Identifier: MIT-0
/// @file
/// A thrown body, turned by the ways of orientation.h, beside where it exactly goes.
#pragma once
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "scenes/euler_top.h"
#include "shelf/orientation.h"

namespace measure {

/// The memory of a spinning body, begun as an exact one is.
struct Tumbling {
  shelf::Vec3<double> inertia, L;
  shelf::Quaternion<double> q{};

  explicit Tumbling(const scenes::EulerTop& top = {})
      : inertia(vec(top.inertia)), L(vec(top.inertia.cwiseProduct(top.w))) {}

  /// Its energy, in more digits than its own [J].
  double energy() const {
    const Vec spin(L.x, L.y, L.z), moments(inertia.x, inertia.y, inertia.z);
    const Vec own = exact(q).conjugate() * spin;
    return double(own.cwiseProduct(own).cwiseQuotient(moments).sum() / 2);
  }

  /// By what angle an orientation is turned against the truth [rad].
  static double angle_error(const shelf::Quaternion<double>& q,
                            const scenes::EulerTop::Matrix& truth) {
    return double(scenes::EulerTop::angle_between(exact(q).toRotationMatrix(), truth));
  }

 private:
  using Vec = scenes::EulerTop::Vec;

  static shelf::Vec3<double> vec(const Vec& v) {
    return {double(v.x()), double(v.y()), double(v.z())};
  }
  static Eigen::Quaternion<scenes::EulerTop::Real> exact(const shelf::Quaternion<double>& q) {
    return Eigen::Quaternion<scenes::EulerTop::Real>(q.w, q.x, q.y, q.z).normalized();
  }
};

/// Turns a body, which has q, L and inertia, by its spin at the start of the step; L stays.
inline constexpr auto by_its_spin = [](auto& body, auto h) {
  shelf::turn_exact(body.q, shelf::angular_velocity(body.q, body.L, body.inertia), h);
};
/// Turns it by Bullet's gyroscopic step, which gives it a new L.
inline constexpr auto by_bullet = [](auto& body, auto h) {
  shelf::spin_by_bullet(body.q, body.L, body.inertia, h);
};
/// Turns it by the gyroscopic step of Jolt and Avian: Euler's step of the spin, in the body's own
/// axes, and then L is made as long as it was. Its direction in the room changes.
/// @see MotionProperties::ApplyGyroscopicForceInternal, github.com/jrouwe/JoltPhysics 3b47ec3
inline constexpr auto by_jolt = [](auto& body, auto h) {
  const auto& [x, y, z] = body.inertia;
  const auto own = shelf::rotate_back(body.q, body.L);
  const decltype(own) spin{own.x / x, own.y / y, own.z / z};
  const auto longer = own + (-h) * cross(spin, own);
  const auto end = std::sqrt(dot(own, own) / dot(longer, longer)) * longer;
  shelf::turn_exact(body.q, shelf::rotate(body.q, {end.x / x, end.y / y, end.z / z}), h);
  body.L = shelf::rotate(body.q, end);
};
/// Turns it by five rotations; L stays.
inline constexpr auto by_rotations = [](auto& body, auto h) {
  shelf::spin_by_rotations(body.q, body.L, body.inertia, h);
};
/// Turns it by the midpoint rule; L stays.
inline constexpr auto by_midpoint = [](auto& body, auto h) {
  shelf::spin_by_midpoint(body.q, body.L, body.inertia, h);
};

/// The largest error at the frames of the first second, sixty of them [rad].
/// @param way  one of the ways above, called as `way(body, h)`
/// @param top  the body, and the truth
/// @param rate  steps in the second, a multiple of sixty
template <class Way>
double off_in_a_second(Way way, const scenes::EulerTop& top = {}, int rate = 60) {
  Tumbling body(top);
  double largest = 0;
  for (int n = 1; n <= rate; ++n) {
    way(body, 1.0 / rate);
    if (n % (rate / 60) == 0) {
      const auto truth = top.orientation(n / scenes::EulerTop::Real(rate));
      largest = std::max(largest, Tumbling::angle_error(body.q, truth));
    }
  }
  return largest;
}

}  // namespace measure
