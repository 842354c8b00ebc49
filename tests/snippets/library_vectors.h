// SPDX-License-Identifier: MIT-0
// The vectors that readers bring from libraries.
#pragma once
#include <complex>

#include "eigen_vectors.h"
#include "kinds/glm_vec3.h"
#include "same_steps.h"

struct Complexes {
  using Vec = std::complex<double>;
  using Real = double;
  using Time = double;
  static constexpr int size = 2;
  static constexpr const char* name = "std::complex<double>";
  static Vec make(const Real* from) { return {from[0], from[1]}; }
  static Real read(const Vec& x, int i) { return i == 0 ? x.real() : x.imag(); }
};

struct Attempt {
  int wrong = 0;

  template <class Method>
  void operator()(const char* name, Method method) {
    wrong += differences<EigenVectors<Eigen::Vector3d>>(name, method);
    wrong += differences<EigenVectors<Eigen::ArrayXf>>(name, method);
    wrong += differences<kinds::glm_vec3>(name, method) + differences<Complexes>(name, method);
  }
};
