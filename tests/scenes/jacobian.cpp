// SPDX-License-Identifier: MIT-0
// Every scene that hands the derivatives of its acceleration on, against differences.
#include <Eigen/Core>
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators_range.hpp>
#include <cmath>
#include <type_traits>

#include "differences.h"
#include "integrate/dense_system.h"
#include "measure/eigenvalues.h"
#include "scenes/chain.h"
#include "scenes/circle.h"
#include "scenes/cloth.h"
#include "scenes/linear_drag.h"
#include "scenes/orbit.h"
#include "scenes/pendulum.h"
#include "scenes/rope.h"
#include "scenes/spring.h"

using differences::random;
using differences::Slopes;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

template <class Scene>
typename Scene::Vec as_scene_has_it(const VectorXd& all) {
  if constexpr (std::is_arithmetic_v<typename Scene::Vec>) {
    return all[0];
  } else {
    return all;
  }
}

template <class Scene>
VectorXd acceleration(const Scene& scene, const VectorXd& x, const VectorXd& v) {
  const auto a = scene(as_scene_has_it<Scene>(x), as_scene_has_it<Scene>(v), 0.3);
  if constexpr (std::is_arithmetic_v<typename Scene::Vec>) {
    return VectorXd::Constant(1, a);
  } else {
    return a;
  }
}

struct Jacobian {
  MatrixXd dadx, dadv;
};

template <class Scene>
Jacobian own(const Scene& scene, const VectorXd& x, const VectorXd& v) {
  const MatrixXd zero = MatrixXd::Zero(x.size(), x.size());
  Jacobian all{zero, zero};
  scene.jacobian(as_scene_has_it<Scene>(x), as_scene_has_it<Scene>(v), 0.3,
                 [&](Eigen::Index i, Eigen::Index j, double dadx, double dadv) {
                   all.dadx(i, j) += dadx;
                   all.dadv(i, j) += dadv;
                 });
  return all;
}

template <class Scene>
Slopes by_position(const Scene& scene, const VectorXd& x, const VectorXd& v) {
  return differences::slopes([&](const VectorXd& there) { return acceleration(scene, there, v); },
                             x);
}

template <class Scene>
Slopes by_velocity(const Scene& scene, const VectorXd& x, const VectorXd& v) {
  return differences::slopes([&](const VectorXd& w) { return acceleration(scene, x, w); }, v);
}

void check_equal(const MatrixXd& mine, const Slopes& wanted) {
  CHECK((mine - wanted.matrix).cwiseAbs().maxCoeff() <= wanted.rounding);
}

template <class Scene>
void check(const Scene& scene, const VectorXd& x, const VectorXd& v) {
  const Jacobian mine = own(scene, x, v);
  check_equal(mine.dadx, by_position(scene, x, v));
  check_equal(mine.dadv, by_velocity(scene, x, v));
}

// What the other nodes feel of a held one does not matter, since it does not move.
template <class Net>
MatrixXd without_held(const Net& net, MatrixXd all) {
  for (int i = 0; i < net.nodes(); ++i) {
    if (net.held(i)) all.middleCols(3 * i, 3).setZero();
  }
  return all;
}

template <class Net>
void check_net(const Net& net, const VectorXd& x, const VectorXd& v) {
  Net by_springs = net;
  by_springs.c = 0;
  Slopes dadx = by_position(by_springs, x, v), dadv = by_velocity(net, x, v);
  dadx.matrix = without_held(net, dadx.matrix);
  dadv.matrix = without_held(net, dadv.matrix);
  const Jacobian mine = own(net, x, v);
  check_equal(mine.dadx, dadx);
  check_equal(mine.dadv, dadv);
}

template <class Net>
VectorXd stretched(const Net& net, double by, unsigned seed) {
  return by * net.start().x + random(3 * net.nodes(), 0.2, seed);
}

double largest_eigenvalue(const MatrixXd& symmetric) {
  double largest = -INFINITY;
  for (const auto& each : measure::eigenvalues(symmetric)) {
    largest = std::max(largest, each.real());
  }
  return largest;
}

constexpr scenes::Rope<> rope{.count = 5, .length = 4, .mass = 2, .tip = 3, .k = 7, .c = 0.7};
constexpr scenes::Cloth<> cloth{.side = 4, .width = 3, .mass = 2, .k = 7, .c = 0.7};

}  // namespace

TEST_CASE("The Jacobian of every small scene is the derivative of its acceleration") {
  const unsigned seed = GENERATE(range(1u, 6u));
  const VectorXd x = random(2, 2, seed), v = random(2, 2, seed + 100);
  check(scenes::Spring<>{.omega = 3, .zeta = 0.2}, x.head(1), v.head(1));
  check(scenes::LinearDrag<>{.c = 0.7}, x.head(1), v.head(1));
  check(scenes::Pendulum<>{.length = 0.5}, x.head(1), v.head(1));
  check(scenes::Circle<>{.omega = 3, .radius = 2}, x, v);
  check(scenes::Orbit<>{.mu = 3}, x, v);
  check(scenes::Chain<>{.count = 1, .mass = 2, .k = 3, .c = 0.7}, x.head(1), v.head(1));
  check(scenes::Chain<>{.count = 2, .mass = 2, .tip = 5, .k = 3, .c = 0.7}, x, v);
  check(scenes::Chain<>{.count = 7, .mass = 2, .tip = 5, .k = 3, .c = 0.7}, random(7, 2, seed),
        random(7, 2, seed + 100));
}

TEST_CASE("The Jacobian of a stretched rope or cloth is the derivative of its acceleration") {
  const unsigned seed = GENERATE(range(1u, 6u));
  scenes::Rope<> both_held = rope;
  both_held.last_held = true;
  check_net(rope, stretched(rope, 2, seed), random(15, 2, seed + 100));
  check_net(both_held, stretched(rope, 2, seed), random(15, 2, seed + 100));
  check_net(cloth, stretched(cloth, 2, seed), random(48, 2, seed + 100));
}

TEST_CASE("A held node does not change what an implicit step does to the others") {
  const VectorXd x = stretched(cloth, 2, 1), v = VectorXd::Zero(48);
  const Slopes all = by_position(cloth, x, v);
  CHECK((all.matrix - without_held(cloth, all.matrix)).cwiseAbs().maxCoeff() > 1);
  const auto solve = [&](auto jacobian) {
    integrate::DenseSystem<decltype(jacobian)> system(jacobian);
    VectorXd change = cloth(x, v, 0.0);
    REQUIRE(system(x, v, 0.0, -4.0, 0.0, change));
    return change;
  };
  const VectorXd with_held = solve([&](const auto&, const auto&, double, auto add) {
    for (int i = 0; i < 48; ++i) {
      for (int j = 0; j < 48; ++j) add(i, j, all.matrix(i, j), 0.0);
    }
  });
  const VectorXd mine = solve([](const auto& at, const auto& speed, double t, auto add) {
    cloth.jacobian(at, speed, t, add);
  });
  CHECK((with_held - mine).norm() < 1e-10 * mine.norm());
}

// Random places within 0.2 of a grid shrunk by half: no two neighbours are as far apart as at rest.
TEST_CASE("Of a compressed rope or cloth, the Jacobian leaves out what pushes its masses aside") {
  const unsigned seed = GENERATE(range(1u, 6u));
  const auto check_compressed = [seed](auto net) {
    const VectorXd x = stretched(net, 0.5, seed), v = VectorXd::Zero(x.size());
    net.for_each_link([&](int i, int j, const auto& link) {
      CHECK((scenes::node(x, j) - scenes::node(x, i)).norm() < link.length);
    });
    const MatrixXd mine = own(net, x, v).dadx;
    const Slopes all = by_position(net, x, v);
    const MatrixXd aside = without_held(net, all.matrix) - mine;
    CHECK(mine == mine.transpose());
    CHECK(largest_eigenvalue(mine) < all.rounding);
    CHECK(largest_eigenvalue(-aside) < double(x.size()) * all.rounding);
    CHECK(largest_eigenvalue(mine + aside) > 1);
  };
  scenes::Rope<> equal_masses = rope;
  equal_masses.tip = equal_masses.mass;
  check_compressed(equal_masses);
  check_compressed(cloth);
}
