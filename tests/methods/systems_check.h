// SPDX-License-Identifier: MIT-0
// One answer of a linear system against elimination with full pivoting, on scenes whose springs are
// stiff.
#pragma once
#include <Eigen/Core>
#include <catch2/catch_test_macros.hpp>

#include "integrate/band_system.h"
#include "integrate/dense_system.h"
#include "integrate/sparse_system.h"
#include "scenes/chain.h"
#include "systems_try.h"

namespace systems {

// A step of 1/20 s, at which the springs below are stiff: h omega is about 10.
template <class Real>
constexpr Real h = Real(0.05);

// Twice on one system, from two states: the second answer must not see the first.
template <class System, class Scene>
void check(System system, const Scene& scene) {
  using Vec = typename Scene::Vec;
  using Real = typename Vec::Scalar;
  for (const Real seed : {Real(0.3), Real(0.7)}) {
    Vec x = scene.start().x;
    x += Real(0.01) * mixed(x, seed);
    const Vec v = mixed(x, Real(0.9) * seed);
    Vec change = mixed(x, Real(0.8) * seed);
    const Real p = -h<Real> * h<Real>, q = -h<Real>;
    const auto [y, rounding] = full_pivot(jacobian_of(scene), x, v, double(p), double(q), change);
    REQUIRE(system(x, v, Real(0), p, q, change));
    CAPTURE(seed, rounding);
    CHECK(double((change - y).norm()) <= rounding);
  }
}

template <class Real>
scenes::Chain<Real> chain(Real tip) {
  return {.count = 20, .mass = Real(0.5), .tip = tip, .k = 4000, .c = 20};
}

template <int Width, class Scene>
auto band(const Scene& scene) {
  using Real = typename Scene::Vec::Scalar;
  return integrate::BandSystem<Width, decltype(jacobian_of(scene)), Real>(jacobian_of(scene));
}
template <int Size = Eigen::Dynamic, class Real>
auto dense(const scenes::Chain<Real>& scene) {
  return integrate::DenseSystem<decltype(jacobian_of(scene)), Real, Size>(jacobian_of(scene));
}
template <class Scene, class Vec>
auto sparse(const Scene& scene, const Vec& masses) {
  using Real = typename Scene::Vec::Scalar;
  return integrate::SparseSystem<decltype(jacobian_of(scene)), Real>(jacobian_of(scene), masses);
}

}  // namespace systems
