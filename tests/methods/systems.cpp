// SPDX-License-Identifier: MIT-0
// The linear systems of the implicit methods, against elimination with full pivoting.
#include <Eigen/Core>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include "integrate/band_system.h"
#include "integrate/dense_system.h"
#include "integrate/sparse_system.h"
#include "scenes/chain.h"
#include "scenes/cloth.h"
#include "scenes/rope.h"
#include "systems_try.h"

using namespace systems;
using integrate::BandSystem;
using integrate::DenseSystem;
using integrate::SparseSystem;
using scenes::Chain;
using scenes::Cloth;
using scenes::Rope;

namespace {

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
Chain<Real> chain(Real tip) {
  return {.count = 20, .mass = Real(0.5), .tip = tip, .k = 4000, .c = 20};
}

template <class Real>
Rope<Real> rope(Real tip) {
  return {.count = 12, .mass = Real(0.01), .tip = tip, .k = 200, .c = Real(0.3)};
}

template <int Width, class Scene>
auto band(const Scene& scene) {
  using Real = typename Scene::Vec::Scalar;
  return BandSystem<Width, decltype(jacobian_of(scene)), Real>(jacobian_of(scene));
}
template <int Size = Eigen::Dynamic, class Real>
auto dense(const Chain<Real>& scene) {
  return DenseSystem<decltype(jacobian_of(scene)), Real, Size>(jacobian_of(scene));
}
template <class Scene, class Vec>
auto sparse(const Scene& scene, const Vec& masses) {
  using Real = typename Scene::Vec::Scalar;
  return SparseSystem<decltype(jacobian_of(scene)), Real>(jacobian_of(scene), masses);
}

}  // namespace

TEMPLATE_TEST_CASE("On a chain of twenty masses each system finds what full pivoting finds", "",
                   double, float) {
  for (const TestType tip : {TestType(0.5), TestType(30)}) {
    CAPTURE(tip);
    const Chain<TestType> scene = chain(tip);
    check(dense(scene), scene);
    check(band<1>(scene), scene);
    check(band<3>(scene), scene);
    check(sparse(scene, scene.masses()), scene);
  }
}

TEMPLATE_TEST_CASE("On a rope in space each system finds what full pivoting finds", "", double,
                   float) {
  for (const TestType tip : {TestType(0.01), TestType(2)}) {
    CAPTURE(tip);
    const Rope<TestType> scene = rope(tip);
    check(band<5>(scene), scene);
    check(sparse(scene, scene.masses()), scene);
  }
}

TEMPLATE_TEST_CASE("Equal masses need not be given to a SparseSystem", "", double, float) {
  const Chain<TestType> in_a_row = chain(TestType(0.5));
  check(sparse(in_a_row, Many<TestType>()), in_a_row);
  const Rope<TestType> in_space = rope(TestType(0.01));
  check(sparse(in_space, Many<TestType>()), in_space);
  const Cloth<TestType> net{.side = 5, .mass = TestType(0.01), .k = 200, .c = TestType(0.3)};
  check(sparse(net, Many<TestType>()), net);
}

TEMPLATE_TEST_CASE("A DenseSystem may have a fixed size", "", double, float) {
  // With a Jacobian that is as full and as lopsided as can be.
  using Vec = Eigen::Matrix<TestType, 3, 1>;
  const auto jacobian = [](const auto&, const auto&, TestType, auto&& add) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) add(i, j, TestType(1 + 2 * i - j * j), TestType(3 * j - i));
    }
  };
  const Vec x = Vec::Zero();
  Vec change{TestType(1), TestType(-2), TestType(0.5)};
  const auto [y, rounding] = full_pivot(jacobian, x, x, -0.25, -0.5, change);
  DenseSystem<decltype(jacobian), TestType, 3> system(jacobian);
  REQUIRE(system(x, x, TestType(0), TestType(-0.25), TestType(-0.5), change));
  CHECK(double((change - y).norm()) <= rounding);
}

TEST_CASE("The systems take the Jacobian at the place, speed and time that they are given") {
  const auto jacobian = [](const auto& x, const auto& v, double t, auto&& add) {
    add(0, 0, -x[0] * t, -v[0]);
  };
  const Eigen::VectorXd x{{2.0}}, v{{5.0}};
  const auto check_one = [&](auto system) {
    Eigen::VectorXd change{{34.0}};
    REQUIRE(system(x, v, 3.0, -2.0, -1.0, change));  // 1 + 2 * 2 * 3 + 5 = 18
    CHECK(change[0] == 34.0 / 18);
  };
  check_one(DenseSystem<decltype(jacobian)>(jacobian));
  check_one(BandSystem<1, decltype(jacobian)>(jacobian));
  check_one(SparseSystem<decltype(jacobian)>(jacobian));
}
