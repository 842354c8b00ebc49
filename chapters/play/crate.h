// SPDX-License-Identifier: MIT-0
/// @file
/// A crate that tumbles: chapter 6 builds it, and the level keeps it.
#pragma once
#include "../play.h"
#include "shelf/orientation.h"

namespace play {

// [crate]
/// A flat crate of a kilogram, which spins about the middle one of its axes.
struct Crate {
  Vec at;
  shelf::Vec3<double> size{2, 1.4, 0.3};
  shelf::Vec3<double> inertia = shelf::inertia_of_box(1.0, size);
  shelf::Quaternion<double> q{};
  shelf::Vec3<double> L = shelf::angular_momentum(q, {0.2, 12, 0.2}, inertia);

  void step(double h) { shelf::spin_by_rotations(q, L, inertia, h); }

  /// Half the product of spin and angular momentum [J].
  double energy() const { return 0.5 * dot(shelf::angular_velocity(q, L, inertia), L); }
  // [crate]

  /// Its eight corners, and a line between two that differ in one sign; and below it what turns it.
  void draw(Film& film, const char* colour = "velocity Verlet",
            const char* turned_by = "rotations") const {
    const auto corner = [&](int i) {
      const auto way = [i](int bit) { return i & bit ? 0.5 : -0.5; };
      const auto to = shelf::rotate(q, {way(1) * size.x, way(2) * size.y, way(4) * size.z});
      return at + Vec{to.x + 0.3 * to.z, to.y + 0.2 * to.z};
    };
    for (int i = 0; i < 8; ++i)
      for (const int bit : {1, 2, 4})
        if (!(i & bit)) film.line(corner(i), corner(i | bit), colour);
    film.label(at + Vec{0, -2}, turned_by);
  }
};

}  // namespace play
