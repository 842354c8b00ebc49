// SPDX-License-Identifier: MIT-0
#include "shelf/orientation.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>

#include "measure/shelf_card.h"
#include "measure/tumbling.h"
#include "scenes/euler_top.h"
#include "shelf/smooth_damp.h"

namespace measure::shelf_cards {
namespace {

using scenes::EulerTop;
using Real = EulerTop::Real;
using Vec = EulerTop::Vec;
using Matrix = EulerTop::Matrix;

constexpr double frame = 1 / 60.0;

shelf::Vec3<double> vec(const Vec& v) {
  return {double(v.x()), double(v.y()), double(v.z())};
}

Eigen::Quaternion<Real> exact(const shelf::Quaternion<double>& q) {
  return {q.w, q.x, q.y, q.z};
}

// The largest change of the energy, as a share of it.
template <class Step>
double energy_off(Step step, int frames) {
  Tumbling body;
  const double first = body.energy();
  double largest = 0;
  for (int n = 0; n < frames; ++n) {
    step(body, frame);
    largest = std::max(largest, std::abs(body.energy() / first - 1));
  }
  return largest;
}

Promise behind() {
  shelf::Quaternion<double> q;
  for (int n = 0; n < 600; ++n) shelf::turn(q, {0, 20, 0}, frame);
  // Past so many whole turns as the truth has made, and less than half of one behind.
  const double late = std::remainder(200 - 2 * std::atan2(q.y, q.w), 2 * std::numbers::pi);
  return {
      "turn turns by 2*atan(h*|w|/2) instead of h*|w|: at 20 rad/s and 60 Hz it is 1.8 rad "
      "behind after ten seconds",
      std::abs(late - 1.8) < 0.05, late, 3, "rad"};
}

Promise turns_exactly() {
  double largest = 0;
  for (const Real angle : {1e-9L, 1e-6L, 1e-3L, 0.3L, 3.0L}) {
    const Vec axis = Vec(3, -2, 6) / 7;
    const shelf::Vec3<double> w = vec(60 * angle * axis);
    const Vec given = Vec(w.x, w.y, w.z) * Real(frame);
    shelf::Quaternion<double> q;
    for (int n = 0; n < 600; ++n) shelf::turn_exact(q, w, frame);
    const Eigen::AngleAxis<Real> truth(600 * given.norm(), given.normalized());
    largest = std::max(largest, Tumbling::angle_error(q, truth.toRotationMatrix()));
  }
  return {
      "turn_exact makes no error but rounding, from 1e-9 to 3 rad a step: 1e-12 rad in ten "
      "seconds",
      largest < 1e-12, largest, 1, "rad"};
}

Promise length() {
  Tumbling rotations, midpoint = rotations, bullet = rotations;
  shelf::Quaternion<double> first, exactly;
  double largest = 0;
  for (int n = 0; n < 100'000; ++n) {
    by_rotations(rotations, frame), by_midpoint(midpoint, frame), by_bullet(bullet, frame);
    shelf::turn(first, {3, 20, 4}, frame), shelf::turn_exact(exactly, {3, 20, 4}, frame);
    for (const auto& q : {first, exactly, rotations.q, midpoint.q, bullet.q})
      largest = std::max(largest, double(std::abs(exact(q).norm() - 1)));
  }
  return {"the length of q stays one, to 1e-15, for 100000 steps", largest < 1e-15, largest, 1};
}

Promise energy_by_rotations() {
  const double found = 100 * energy_off(by_rotations, 6000);
  return {
      "a body with moments of 1, 2 and 3, thrown about its middle axis with 20 rad/s, has its "
      "energy by rotations within 0.1 % at 60 Hz, for a hundred seconds",
      found < 0.1, found, 2, "%"};
}

Promise energy_by_midpoint() {
  const double found = energy_off(by_midpoint, 600);
  return {"that body keeps its energy by the midpoint rule to 1e-13, for ten seconds at 60 Hz",
          found < 1e-13, found, 1};
}

Promise energy_by_bullet() {
  const double found = 100 * energy_off(by_bullet, 600);
  return {"that body loses 88 % of its energy by Bullet's step in ten seconds at 60 Hz",
          std::abs(found - 88) < 0.5, found, 3, "%"};
}

Promise energy_by_velocity() {
  Tumbling body;
  const double first = body.energy();
  for (int n = 0; n < 600; ++n) by_its_spin(body, frame);
  const double found = body.energy() / first;
  return {
      "that body, turned by its angular velocity at the start of each step instead, has twice its "
      "energy after ten seconds",
      std::abs(found - 2) < 0.01, found, 3};
}

Promise accurate() {
  const double found = off_in_a_second(by_rotations, EulerTop{}, 60);
  return {
      "that body is turned by rotations within 0.02 rad of the exact solution for a second at 60 "
      "Hz",
      found < 0.02, found, 2, "rad"};
}

Promise less_accurate() {
  const double found = off_in_a_second(by_midpoint, EulerTop{}, 60);
  return {
      "that body is turned by the midpoint rule within 0.22 rad of the exact solution for a second",
      found < 0.22, found, 2, "rad"};
}

Promise order() {
  const EulerTop top{Vec(1.3L, 2, 2.9L), Vec(2, 3, -2.5L)};
  const auto order = [&](auto step) {
    return std::log2(off_in_a_second(step, top, 480) / off_in_a_second(step, top, 960));
  };
  const double r = order(by_rotations), m = order(by_midpoint);
  const double worse = std::abs(r - 2) > std::abs(m - 2) ? r : m;
  return {"the rotations and the midpoint rule are of order 2", std::abs(worse - 2) < 0.1, worse,
          3};
}

Promise symmetric() {
  double largest = 0;
  for (const Vec& moments : {Vec(1, 1, 2), Vec(2, 1, 2), Vec(1, 0.1L, 1)}) {
    const EulerTop top{moments, Vec(1, -2, 3)};
    Tumbling body(top);
    for (int n = 0; n < 20; ++n) by_rotations(body, 0.5);
    largest = std::max(largest, Tumbling::angle_error(body.q, top.orientation(10)));
  }
  return {
      "by rotations a body with two equal moments is turned without error in steps of half a "
      "second: 1e-12 rad in ten seconds",
      largest < 1e-12, largest, 1, "rad"};
}

Promise reversible() {
  double largest = 0;
  const auto there_and_back = [&](auto step) {
    Tumbling body;
    for (const double h : {frame, frame / 2, 3 * frame, -3 * frame, -frame / 2, -frame})
      step(body, h);
    largest = std::max(largest, Tumbling::angle_error(body.q, Matrix::Identity()));
  };
  there_and_back(by_rotations), there_and_back(by_midpoint);
  return {
      "a step by -h takes back a step by h of the rotations and of the midpoint rule, to 1e-14 "
      "rad",
      largest < 1e-14, largest, 1, "rad"};
}

Promise damped() {
  double largest = 0;
  const EulerTop coin{Vec(1, 1, 2), Vec(1, -2, 3)};
  for (const int rate : {1, 15, 60, 240}) {
    Tumbling body(coin);
    for (int n = 0; n < 2 * rate; ++n)
      shelf::spin_damped(body.q, body.L, body.inertia, 1.0 / rate, 0.7);
    const double left = double(std::exp(-1.4L));
    largest = std::max({largest, std::abs(body.L.x / left - 1), std::abs(body.L.y / left + 2),
                        std::abs(body.L.z / left - 6)});
    largest = std::max(largest,
                       Tumbling::angle_error(body.q, coin.orientation(-std::expm1(-1.4L) / 0.7L)));
  }
  return {
      "spin_damped leaves exp(-c*t) of L at any frame rate, and turns a body with two equal "
      "moments without error: 1e-13 in two seconds at 1 to 240 Hz",
      largest < 1e-13, largest, 1};
}

// A crate of 20 kg, in flight and somehow turned.
struct Crate {
  Matrix turned;
  shelf::Quaternion<double> q;
  shelf::Vec3<double> inertia = shelf::inertia_of_box(20.0, {0.8, 0.6, 0.6});
  shelf::Vec3<double> v{1, -4, 0.5}, L{3, -1, 5};

  explicit Crate(int n) {
    const Eigen::Quaternion<Real> way(Eigen::AngleAxis<Real>(0.7L * n, Vec(3, -2, 6) / 7));
    q = {double(way.w()), double(way.x()), double(way.y()), double(way.z())};
    turned = exact(q).normalized().toRotationMatrix();
  }

  Vec momentum() const { return {L.x, L.y, L.z}; }
  Vec velocity() const { return {v.x, v.y, v.z}; }
  Vec spin() const {
    const Vec moments(inertia.x, inertia.y, inertia.z);
    return turned * (turned.transpose() * momentum()).cwiseQuotient(moments);
  }
  Real rises(const Vec& r) const { return (velocity() + spin().cross(r)).y(); }
  Real energy() const { return 10 * velocity().squaredNorm() + spin().dot(momentum()) / 2; }
  Vec momentum_about(const Vec& r) const { return momentum() - r.cross(20 * velocity()); }

  // As the header says.
  void push(const shelf::Vec3<double>& r, double e) {
    const shelf::Vec3<double> up{0, 1, 0};
    const double speed = -dot(v + cross(shelf::angular_velocity(q, L, inertia), r), up);
    const double J = (1 + e) * speed / shelf::inverse_mass_at(q, inertia, 1 / 20.0, r, up);
    v = v + (J / 20) * up;
    L = L + cross(r, J * up);
  }
};

// The most that `found` finds at a push at a corner.
template <class Found>
double at_corners(Found found) {
  double largest = 0;
  for (int n = 0; n < 800; ++n) {
    const Crate crate(n / 8);
    const shelf::Vec3<double> r =
        shelf::rotate(crate.q, {n & 1 ? 0.4 : -0.4, n & 2 ? 0.3 : -0.3, n & 4 ? 0.3 : -0.3});
    largest = std::max(largest, found(crate, r));
  }
  return largest;
}

Promise pushed() {
  const double largest = at_corners([](Crate crate, const shelf::Vec3<double>& at) {
    const Vec r(at.x, at.y, at.z);
    const Real speed = -crate.rises(r);
    crate.push(at, 0.5);
    return double(std::abs(crate.rises(r) / speed - 0.5L));
  });
  return {
      "a corner that is pushed with (1 + e) times its speed over inverse_mass_at leaves with e "
      "times that speed, to 1e-14 of it",
      largest < 1e-14, largest, 1};
}

Promise push_keeps() {
  const double largest = at_corners([](Crate crate, const shelf::Vec3<double>& at) {
    const Vec r(at.x, at.y, at.z), momentum = crate.momentum_about(r);
    const Real energy = crate.energy();
    Crate softer = crate;
    crate.push(at, 1), softer.push(at, 0.3);
    const Real off = std::max((crate.momentum_about(r) - momentum).norm(),
                              (softer.momentum_about(r) - momentum).norm());
    return double(std::max(off / momentum.norm(), std::abs(crate.energy() / energy - 1)));
  });
  return {
      "such a push keeps the angular momentum about the corner, and with e = 1 the energy, to "
      "1e-14",
      largest < 1e-14, largest, 1};
}

// One axis, and a target that turns about it.
double off_one_axis(int rate, double omega, double target_speed) {
  const shelf::Vec3<double> axis{0.6, 0, 0.8};
  shelf::Quaternion<double> q, target;
  shelf::Vec3<double> w = 2 * axis;
  shelf::turn_exact(target, 1.5 * axis, 1);
  double x = 0, v = 2, off = 0;
  for (int n = 1; n <= rate; ++n) {
    const double h = 1.0 / rate;
    shelf::turn_exact(target, target_speed * axis, h);
    shelf::turn_damp(q, w, target, target_speed * axis, omega, h);
    shelf::smooth_damp(x, v, 1.5 + target_speed * (n * h), target_speed, omega, h);
    off = std::max(
        {off, std::abs(dot(shelf::turn_between(q, {}), axis) - x), std::abs(dot(w, axis) - v)});
  }
  return off;
}

Promise aims_exactly() {
  double off = 0;
  for (const int rate : {15, 30, 60, 120, 240})
    for (const double omega : {1.0, 4.0, 30.0})
      for (const double speed : {0.0, 0.5}) off = std::max(off, off_one_axis(rate, omega, speed));
  return {
      "turn_damp about one axis ends where smooth_damp does, to 1e-13 rad in a second at 15 to 240 "
      "Hz, towards what turns evenly, too",
      off < 1e-13, off, 2, "rad"};
}

Promise aims_at_any_rate() {
  double off = 0;
  shelf::Quaternion<double> first;
  for (const int rate : {15, 30, 60, 120, 240}) {
    shelf::Quaternion<double> q, target;
    shelf::Vec3<double> w{0.5, 3, -1};
    shelf::turn_exact(target, {1.5, 0, 0.2}, 1);
    for (int n = 0; n < rate; ++n) shelf::turn_damp(q, w, target, {0, 0, 0}, 4, 1.0 / rate);
    if (rate == 15) first = q;
    const auto apart = shelf::turn_between(q, first);
    off = std::max(off, std::sqrt(dot(apart, apart)));
  }
  return {
      "towards what rests it ends a second in the same place at 15, 30, 60, 120 and 240 Hz, to "
      "1e-12 rad, whatever the axis of its spin",
      off < 1e-12, off, 2, "rad"};
}

Promise aims_the_shorter_way() {
  bool kept = true;
  double least = 10;
  for (const double angle : {-3.1, -1.0, 0.5, 3.1}) {
    shelf::Quaternion<double> q, target;
    shelf::Vec3<double> w;
    shelf::turn_exact(target, {0, angle, 0}, 1);
    double before = std::abs(angle);
    for (int n = 0; n < 120; ++n) {
      shelf::turn_damp(q, w, target, {0, 0, 0}, 5, 1 / 60.0);
      const double left = shelf::turn_between(target, q).y * (angle < 0 ? -1 : 1);
      kept = kept && left >= 0 && left < before;
      before = left;
    }
    least = std::min(least, before);
  }
  return {"it goes the shorter way round, from rest past no target, for turns of up to 3.1 rad",
          kept, least, 2, "rad"};
}

}  // namespace

ShelfCard orientation() {
  return {"orientation",
          {behind(), turns_exactly(), length(), energy_by_rotations(), accurate(),
           energy_by_midpoint(), less_accurate(), energy_by_bullet(), energy_by_velocity(), order(),
           symmetric(), reversible(), damped(), aims_exactly(), aims_at_any_rate(),
           aims_the_shorter_way(), pushed(), push_keeps()}};
}

}  // namespace measure::shelf_cards
