// SPDX-License-Identifier: MIT-0
/// @file
/// A box on a floor or a slope, moved by contact.h and orientation.h, for what is measured of them.
#pragma once
#include <algorithm>
#include <cmath>
#include <complex>

#include "shelf/contact.h"
#include "shelf/orientation.h"

namespace measure {

/// The products of a plane whose vectors are complex numbers, right and up.
struct FlatProducts {
  using Flat = std::complex<double>;

  static double dot(Flat p, Flat r) { return (std::conj(p) * r).real(); }

  /// Across: the turn that a push at a corner makes, and how a turn moves it.
  double operator()(Flat r, Flat push) const { return (std::conj(r) * push).imag(); }
  Flat operator()(double w, Flat r) const { return Flat(0, w) * r; }
};

/// A box whose corners may touch one plane through the origin.
template <class Real>
struct Crate {
  using Vec = shelf::Vec3<Real>;

  Vec size{Real(0.8), Real(0.6), Real(0.6)};  ///< its edges [m]
  Vec up{0, 1, 0};                            ///< normal of the plane
  Vec x{}, v{}, L{};                          ///< place, velocity, angular momentum
  shelf::Quaternion<Real> q{};
  int corners = 8;  ///< that may touch it; 4 are those below
  shelf::Contact<Vec, Real> contacts[8];

  static constexpr Real mass = 20;
  static constexpr Real g = Real(9.81);

  Vec inertia() const { return shelf::inertia_of_box(mass, size); }
  Vec spin() const { return angular_velocity(q, L, inertia()); }
  void spin_with(const Vec& w) { L = angular_momentum(q, w, inertia()); }

  /// Where its corners are, by their contacts.
  void find_corners() {
    for (int i = 0; i < corners; ++i) {
      const Vec own{i & 1 ? size.x / 2 : -size.x / 2, i & 4 ? size.y / 2 : -size.y / 2,
                    i & 2 ? size.z / 2 : -size.z / 2};
      contacts[i].r = rotate(q, own);
      contacts[i].normal = up;
      contacts[i].gap = dot(x + contacts[i].r, up);
    }
  }

  /// How far its lowest corner is above the plane [m].
  Real lowest() {
    find_corners();
    const auto less = [](const auto& p, const auto& r) { return p.gap < r.gap; };
    return std::min_element(contacts, contacts + corners, less)->gap;
  }

  /// Puts it onto the plane, or above it.
  void lift_to(Real height) { x = x + (height - lowest()) * up; }

  /// Its energy [J].
  Real energy() const { return mass * (dot(v, v) / 2 + g * x.y) + dot(L, spin()) / 2; }

  /// How fast it is: its velocity, and a metre from its centre by its spin [m/s].
  Real speed() const { return std::sqrt(dot(v, v)) + std::sqrt(dot(spin(), spin())); }

  /// One step under gravity.
  void step(Real h, const shelf::Surface<Real>& surface) {
    find_corners();
    const auto spins = [&](const Vec& now) { return angular_velocity(q, now, inertia()); };
    const auto product = [](const Vec& p, const Vec& r) { return dot(p, r); };
    const auto across = [](const Vec& p, const Vec& r) { return cross(p, r); };
    const auto way = shelf::contact_step(v, L, Vec{0, -g, 0}, h, contacts, corners, surface,
                                         1 / mass, spins, product, across);
    x = x + h * way.v;
    spin_by_rotations(q, way.L, inertia(), h);
  }
};

}  // namespace measure
