// SPDX-License-Identifier: MIT-0
// The methods that solve a linear system in each step, with each of the solver objects, whose
// headers come first.
#pragma once
#include "diagonal.h"
#include "eigen_vectors.h"

struct Attempt {
  int wrong = 0;

  template <class Method>
  void operator()(const char* name, Method method) {
    using Jacobian = std::decay_t<decltype(diagonal)>;
    integrate::DenseSystem<Jacobian, double, 3> dense(diagonal);
    integrate::BandSystem<2, Jacobian, float> band(diagonal);
    integrate::SparseSystem<Jacobian> sparse(diagonal, Eigen::Vector3d(1, 2, 3));
    wrong += differences_with(dense, name, method);
    wrong += differences_with(band, name, method);
    wrong += differences_with(sparse, name, method);
  }

  template <class System, class Method>
  int differences_with(System& system, const char* name, Method method) {
    using Vec = typename System::Vec;
    return differences<EigenVectors<Vec>>(name, method, rounding<typename Vec::Scalar>(), system);
  }
};
