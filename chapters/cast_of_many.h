// SPDX-License-Identifier: MIT-0
/// @file
/// The things of this book that are made of many: chain, ropes, cloth and planets, each once, with
/// its numbers.
#pragma once
#include "cast.h"
#include "scenes/chain.h"
#include "scenes/cloth.h"
#include "scenes/outer_solar_system.h"
#include "scenes/rope.h"

inline constexpr double bead_mass = 0.01;  ///< of each bead of chain, rope and cloth [kg]

/// Stiffness of a spring of steel: in a frame its h omega is 50 [N/m].
inline constexpr double steel_k = 2500 * bead_mass / (frame * frame);

/// A chain of beads and steel springs on a line, tied to a wall.
template <class Real = double>
scenes::Chain<Real> chain_of(int count) {
  return {.count = count, .mass = bead_mass, .k = steel_k, .stretch = 0};
}

/// A rope that hangs from its nail, at rest under its own weight.
/// @tparam Real  `double`, or a number that counts
template <class Real = double>
struct HangingRope : scenes::Rope<Real> {
  using Vec = typename scenes::Rope<Real>::Vec;  ///< three numbers a mass: right, up, to you

  /// Straight down, each spring stretched by what hangs on it.
  scenes::State<Vec> start() const {
    const Vec masses = this->masses();
    Vec x = Vec::Zero(masses.size());
    for (int i = 1; i < this->count; ++i) {
      const Real below = masses.tail(3 * (this->count - i)).sum() / 3;
      x[3 * i + 1] =
          x[3 * i - 2] - this->length / Real(this->count - 1) - below * this->g / this->k;
    }
    return {x, Vec::Zero(masses.size())};
  }

  /// Energy beyond that of the rope at rest; conserved without damping [J].
  /// @param x  positions [m]
  /// @param v  velocities [m/s]
  Real energy(const Vec& x, const Vec& v) const {
    const auto rest = start();
    return scenes::Rope<Real>::energy(x, v) - scenes::Rope<Real>::energy(rest.x, rest.v);
  }
};

/// A rope of beads a metre apart and steel springs, hanging.
template <class Real = double>
HangingRope<Real> rope_of(int count) {
  return {{.count = count, .length = count - 1.0, .mass = bead_mass, .k = steel_k}};
}

/// A square of cloth, its beads a metre apart, its springs of steel, without weight.
template <class Real = double>
scenes::Cloth<Real> cloth_of(int side) {
  return {.side = side, .width = side - 1.0, .mass = bead_mass, .k = steel_k, .g = 0};
}

/// Chain, rope and cloth of steel with 108 unknowns each.
inline const auto steel_chain = chain_of(108);
inline const auto steel_rope = rope_of(36);
inline const auto steel_cloth = cloth_of(6);

/// Two metres of rope, held level by its ends; one hand lets go, the other end hangs on its nail.
/// @param stiffness  of each of its springs [N/m]
template <class Real = double>
scenes::Rope<Real> rope_on_a_nail(double stiffness) {
  return {.count = 16, .length = 2, .mass = bead_mass, .k = stiffness};
}

/// Two metres of rope in twenty springs, so stiff that its own weight stretches it by a hundredth.
inline const scenes::Rope<> rope_of_springs{
    .count = 21, .length = 2, .mass = bead_mass, .k = 210 * bead_mass * 9.81 / 0.02};

/// The sun and the five outer planets, from Jupiter to Pluto, in days and astronomical units.
inline constexpr scenes::OuterSolarSystem<> outer_planets;
