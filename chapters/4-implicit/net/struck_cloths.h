// SPDX-License-Identifier: MIT-0
/// @file
/// Three light cloths in chapter 4 under one blow, each moved by a method of its own.
#pragma once
#include <Eigen/Core>
#include <array>
#include <cmath>

#include "integrate/bdf2.h"
#include "integrate/symplectic_euler.h"
#include "nets.h"
#include "substeps.h"

inline constexpr double light_k = 100;  ///< stiffness of a light cloth's springs [N/m]

/// A blow with something round and soft, straight away from the eye.
struct Blow {
  double x = 0, y = -0.55;  ///< of its middle, from the middle of the upper edge [m]
  double speed = 3;         ///< there [m/s]
  double radius = 0.45;     ///< beyond which it moves nothing [m]
};

/// Three cloths of a metre that hang from two corners, at rest until one blow hits them all.
class StruckCloths {
 public:
  static constexpr int side = 8;  ///< masses along an edge

  /// Hangs the cloths up and strikes them.
  /// @param k  stiffness of each spring [N/m]
  /// @param h  length of a frame [s]
  StruckCloths(double k, double h, const Blow& blow) : cloth_{.side = side, .k = k}, h_(h) {
    // Twice as many as hold it: with the fewest the energy still swings.
    substeps_ = int(std::ceil(h_ * highest_frequency(cloth_)));
    MassSpringState s = at_rest();
    rest_ = cloth_.energy(s.x, s.v);
    strike(s, blow);
    given_ = cloth_.energy(s.x, s.v) - rest_;
    backward_euler_ = bdf2_ = substepped_ = s;
    previous_ = integrate::bdf2_start(s.x, s.v, 0.0, h_, cloth_);
  }
  StruckCloths(const StruckCloths&) = delete;  // system_ refers to the cloth
  StruckCloths& operator=(const StruckCloths&) = delete;

  /// One frame of each: a solve of backward Euler, a solve of BDF2, substeps of symplectic Euler.
  /// A cloth that can't be solved is not a number from then on.
  void frame() {
    auto& [x, v] = backward_euler_;
    if (!integrate::backward_euler(x, v, 0.0, h_, cloth_, system_)) x.setConstant(NAN);
    auto& [x2, v2] = bdf2_;
    if (!integrate::bdf2(x2, v2, previous_, 0.0, h_, h_, cloth_, system_)) x2.setConstant(NAN);
    for (int n = 0; n < substeps_; ++n) {
      integrate::symplectic_euler(substepped_.x, substepped_.v, 0.0, h_ / substeps_, cloth_);
    }
  }

  /// Energies beyond that at rest, over what the blow gave: of backward Euler, BDF2 and substeps.
  std::array<double, 3> energies() const {
    const auto share = [this](const MassSpringState& s) {
      return (cloth_.energy(s.x, s.v) - rest_) / given_;
    };
    return {share(backward_euler_), share(bdf2_), share(substepped_)};
  }

  const MassSpringState& backward_euler() const { return backward_euler_; }  ///< one of the three
  const MassSpringState& bdf2() const { return bdf2_; }                      ///< one of the three
  const MassSpringState& substepped() const { return substepped_; }          ///< one of the three
  int substeps() const { return substeps_; }                                 ///< in a frame

 private:
  // Hanging, each spring stretched by its load: long steps of backward Euler lead there.
  MassSpringState at_rest() {
    MassSpringState s = cloth_.start();
    for (int i = 0; i < cloth_.nodes(); ++i) {
      auto place = s.x.segment<3>(3 * i);
      place = Eigen::Vector3d(place.x() - cloth_.width / 2, -place.z(), 0);
    }
    for (int n = 0; n < 12; ++n) {
      if (!integrate::backward_euler(s.x, s.v, 0.0, 1.0, cloth_, system_)) s.x.setConstant(NAN);
    }
    s.v.setZero();
    return s;
  }

  void strike(MassSpringState& s, const Blow& blow) const {
    for (int i = 0; i < cloth_.nodes(); ++i) {
      const double x = s.x[3 * i] - blow.x, y = s.x[3 * i + 1] - blow.y;
      const double near = 1 - (x * x + y * y) / (blow.radius * blow.radius);
      if (near > 0 && !cloth_.held(i)) s.v[3 * i + 2] = -blow.speed * near * near;
    }
  }

  scenes::Cloth<> cloth_;
  double h_, rest_ = 0, given_ = 1;
  int substeps_ = 1;
  // In a band as wide as two rows, which for so few masses takes no longer than a sparse system,
  // and a third of the room in the page.
  using Jacobian = decltype(jacobian_of(cloth_));
  integrate::BandSystem<3 * (side + 1) + 2, Jacobian> system_{jacobian_of(cloth_)};
  MassSpringState backward_euler_, bdf2_, substepped_;
  integrate::Bdf2Previous<Eigen::VectorXd> previous_;
};

/// Their energies some frames after the blow; see StruckCloths::energies().
inline std::array<double, 3> cloths_after(int frames, double h = frame, const Blow& blow = {},
                                          double k = light_k) {
  StruckCloths cloths(k, h, blow);
  for (int n = 0; n < frames; ++n) cloths.frame();
  return cloths.energies();
}
