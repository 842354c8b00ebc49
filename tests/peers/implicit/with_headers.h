// SPDX-License-Identifier: MIT-0
// The headers of this book, and what else can be plugged into them.
#pragma once
#include <Eigen/SparseCholesky>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "implicit/variants.h"
#include "integrate/backward_euler.h"
#include "integrate/band_system.h"
#include "integrate/dense_system.h"
#include "integrate/sparse_system.h"
#include "integrate/symplectic_euler.h"

namespace implicit {

template <class Scene>
auto jacobian_of(const Scene& scene) {
  return
      [scene](const auto& x, const auto& v, double t, auto&& add) { scene.jacobian(x, v, t, add); };
}

template <class Scene, class System>
Step backward_euler(const Scene& scene, std::shared_ptr<System> system) {
  return [scene, system](State& s, double step) {
    if (!integrate::backward_euler(s.x, s.v, 0.0, step, scene, *system)) {
      throw std::runtime_error("a step could not be solved");
    }
  };
}

template <int Width, class Scene>
Step band(const Scene& scene) {
  const auto jacobian = jacobian_of(scene);
  using System = integrate::BandSystem<Width, std::decay_t<decltype(jacobian)>>;
  return backward_euler(scene, std::make_shared<System>(jacobian));
}

template <class Scene>
Step dense(const Scene& scene) {
  const auto jacobian = jacobian_of(scene);
  using System = integrate::DenseSystem<std::decay_t<decltype(jacobian)>>;
  return backward_euler(scene, std::make_shared<System>(jacobian));
}

template <class Scene>
Step sparse(const Scene& scene) {
  const auto jacobian = jacobian_of(scene);
  using System = integrate::SparseSystem<std::decay_t<decltype(jacobian)>>;
  return backward_euler(scene, std::make_shared<System>(jacobian));
}

/// What everyone writes first: a new list of entries for every step.
template <class Jacobian>
class Triplets {
 public:
  Triplets(Jacobian jacobian, bool analyse_each_step)
      : jacobian_(std::move(jacobian)), analyse_(true), analyse_each_step_(analyse_each_step) {}

  bool operator()(const Eigen::VectorXd& x, const Eigen::VectorXd& v, double t, double p, double q,
                  Eigen::VectorXd& change) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < int(x.size()); ++i) entries.emplace_back(i, i, 1.0);
    jacobian_(x, v, t, [&](int i, int j, double dadx, double dadv) {
      entries.emplace_back(i, j, p * dadx + q * dadv);
    });
    Eigen::SparseMatrix<double> matrix(x.size(), x.size());
    matrix.setFromTriplets(entries.begin(), entries.end());
    if (analyse_) solver_.analyzePattern(matrix);
    analyse_ = analyse_each_step_;
    solver_.factorize(matrix);
    change = solver_.solve(change).eval();
    return solver_.info() == Eigen::Success;
  }

 private:
  Jacobian jacobian_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
  bool analyse_, analyse_each_step_;
};

template <class Scene>
Step triplets(const Scene& scene, bool analyse_each_step) {
  const auto jacobian = jacobian_of(scene);
  using System = Triplets<std::decay_t<decltype(jacobian)>>;
  return backward_euler(scene, std::make_shared<System>(jacobian, analyse_each_step));
}

/// The frequency of the fastest mode, from below, by the power method [rad/s].
template <class Scene>
double fastest_frequency(const Scene& scene, const State& s) {
  Eigen::VectorXd mode = s.v;
  double squared = 0;
  for (int n = 0; n < 100; ++n) {
    Eigen::VectorXd pushed = Eigen::VectorXd::Zero(mode.size());
    scene.jacobian(s.x, s.v, 0.0,
                   [&](int i, int j, double dadx, double) { pushed[i] -= dadx * mode[j]; });
    squared = pushed.norm();
    mode = pushed / squared;
  }
  return std::sqrt(squared);
}

/// How many steps of symplectic Euler it takes to be stable, too, with a tenth to spare.
template <class Scene>
int stable_substeps(const Scene& scene, const State& s) {
  return int(1.1 * h * fastest_frequency(scene, s) / 2) + 1;
}

template <class Scene>
Step substeps(const Scene& scene, int count) {
  return [scene, count](State& s, double step) {
    for (int n = 0; n < count; ++n) {
      integrate::symplectic_euler(s.x, s.v, 0.0, step / count, scene);
    }
  };
}

}  // namespace implicit
