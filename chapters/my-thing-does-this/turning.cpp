// SPDX-License-Identifier: MIT-0
// What turns and tumbles.
#include <cmath>

#include "shelf/orientation.h"
#include "sketch.h"

namespace {

using Vec = shelf::Vec3<double>;
using Quaternion = shelf::Quaternion<double>;

double length(const Quaternion& q) {
  return std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
}

// Half of h w times q, added: what a derivative asks for.
Quaternion added(const Quaternion& q, const Vec& w, double h) {
  const Quaternion turns = Quaternion{0, h / 2 * w.x, h / 2 * w.y, h / 2 * w.z} * q;
  return {q.w + turns.w, q.x + turns.x, q.y + turns.y, q.z + turns.z};
}

Sketch grows() {
  Quaternion q, p;
  const Vec w{0, 6, 0};
  return {"grows",
          5,
          "t [s]",
          "times as large",
          {run("q += h/2 w q", 5, 60, 1,
               [&](double h) {
                 q = added(q, w, h);
                 return length(q) * length(q);
               }),
           run("turn_exact", 5, 60, 1, [&](double h) {
             shelf::turn_exact(p, w, h);
             return length(p) * length(p);
           })}};
}

// A book in the air, thrown about its middle axis: its energy over that of the start.
Sketch spins_faster() {
  const Vec inertia{1, 2, 3};
  const auto energy = [&](const Quaternion& q, const Vec& L) {
    return dot(L, shelf::angular_velocity(q, L, inertia)) / 2;
  };
  Quaternion q, p;
  const Vec L = shelf::angular_momentum(q, {0.2, 20, 0.2}, inertia);
  const double first = energy(q, L);
  return {"spins-faster",
          10,
          "t [s]",
          "of its energy",
          {run("by the spin of the start", 10, 60, 1,
               [&](double h) {
                 shelf::turn_exact(q, shelf::angular_velocity(q, L, inertia), h);
                 return energy(q, L) / first;
               }),
           run("spin_by_rotations", 10, 60, 1, [&](double h) {
             Vec same = L;
             shelf::spin_by_rotations(p, same, inertia, h);
             return energy(p, same) / first;
           })}};
}

// A tower at 350 degrees that is to look to 10.
Sketch long_way_round() {
  constexpr double degree = std::numbers::pi / 180;
  double angle = 350;
  Quaternion q, aim;
  Vec w;
  shelf::turn_exact(q, {0, -10 * degree, 0}, 1);
  shelf::turn_exact(aim, {0, 10 * degree, 0}, 1);
  return {"long-way-round",
          1.5,
          "t [s]",
          "degrees to turn",
          {run("the angle, smoothed", 1.5, 60, 340,
               [&](double h) {
                 angle += (1 - std::exp(-4 * h)) * (10 - angle);
                 return angle - 10;
               }),
           run("turn_damp", 1.5, 60, 20, [&](double h) {
             shelf::turn_damp(q, w, aim, Vec(), 6, h);
             return shelf::turn_between(aim, q).y / degree;
           })}};
}

}  // namespace

std::vector<Sketch> sketches_of_turning() {
  return {grows(), spins_faster(), long_way_round()};
}
