// SPDX-License-Identifier: MIT-0
/// @file
/// A thing that spins in the air in chapter 6: gyroscopic torque and nothing else.
#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>

#include "../cast.h"
#include "measure/methods.h"
#include "measure/record.h"
#include "measure/run.h"
#include "scenes/state.h"

/// The matrix that does to a vector what a cross product with w does.
inline Eigen::Matrix3d cross(const Eigen::Vector3d& w) {
  return (Eigen::Matrix3d() << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0).finished();
}

// [thrown]
/// A body without a torque, seen from itself: I w' = -w x (I w).
///
/// Its angular velocity w is what the methods call v; what they call x does not matter.
struct Thrown {
  using Vec = Eigen::Vector3d;
  Vec inertia{1, 2, 3};  ///< about its own axes [kg m^2]; only their ratios matter

  Vec operator()(const Vec&, const Vec& w, double) const {
    return -w.cross(inertia.cwiseProduct(w)).cwiseQuotient(inertia);
  }

  template <class Add>
  void jacobian(const Vec&, const Vec& w, double, Add&& add) const {
    const Vec spin = inertia.cwiseProduct(w);
    const Eigen::Matrix3d by_w = cross(spin) - cross(w) * inertia.asDiagonal();
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) add(i, j, 0.0, by_w(i, j) / inertia[i]);
    }
  }
  // [thrown]

  /// About the middle axis, and a little beside it.
  scenes::State<Vec> start() const { return {Vec::Zero(), Vec(0.2, 20, 0.2)}; }

  /// Energy of the spin [J]; conserved.
  double energy(const Vec& w) const { return w.dot(inertia.cwiseProduct(w)) / 2; }

  /// Size of the angular momentum [kg m^2/s]; conserved.
  double momentum(const Vec& w) const { return inertia.cwiseProduct(w).norm(); }
};

/// The gyroscopic step as Bullet's btRigidBody.cpp has it, written out again.
inline Eigen::Vector3d as_in_bullet(const Thrown& body, const Eigen::Vector3d& w, double h) {
  const Eigen::Matrix3d inertia = body.inertia.asDiagonal();
  const Eigen::Vector3d residual = h * w.cross(inertia * w);
  const Eigen::Matrix3d jacobian = inertia + h * (cross(w) * inertia - cross(inertia * w));
  return w - jacobian.inverse() * residual;
}

/// The time of the frame in which a thrown body has turned over for the first time [s].
/// @param step  a method, called as `step(x, v, t, h, scene)`
/// @param parts  steps in a frame
template <class Step>
double first_flip_time(Step step, int parts) {
  const Thrown body;
  auto s = body.start();
  for (int n = 1;; ++n) {
    s = measure::after(step, body, s, frame / parts, parts);
    if (s.v.y() < 0) return n * frame;
  }
}

/// Records ten seconds of a thrown body.
inline void record_free_rigid_body(measure::Record& record) {
  auto& spin = record.table(
      "spin", {{"t", "s"}, {"Euler"}, {"backward Euler"}, {"trapezoid"}, {"RK4", "", 6}});
  const Thrown body;
  auto e = body.start(), b = e, tr = e, r = e;
  const double first = body.energy(e.v);
  // A run that exploded ends as NaN, and compilers do not agree on its sign.
  const auto share = [&](const auto& s) {
    const double found = body.energy(s.v) / first;
    return std::isnan(found) ? INFINITY : found;
  };
  for (int n = 0; n <= 600; ++n) {
    spin.add({n * frame, share(e), share(b), share(tr), share(r)});
    measure::euler(e.x, e.v, 0.0, frame, body);
    measure::backward_euler(b.x, b.v, 0.0, frame, body);
    measure::trapezoid(tr.x, tr.v, 0.0, frame, body);
    measure::rk4(r.x, r.v, 0.0, frame, body);
  }
  const auto blown = std::find_if(spin.rows.begin(), spin.rows.end(),
                                  [](const auto& row) { return !(row[1].value < 1e6); });
  record.number("spin-euler", blown->at(0).value, 2, "s");
  record.number("spin-second", 100 * spin.rows[60][2].value, 2, "%");
  record.number("spin-ten", 100 * spin.rows[600][2].value, 2, "%");
  record.number("spin-rk4", 100 * (1 - spin.rows[600][4].value), 2, "%");
  record.number("spin-over", first_flip_time(measure::backward_euler, 1), 2, "s");
  record.number("spin-over-true", first_flip_time(measure::rk4, 20), 2, "s");
}
