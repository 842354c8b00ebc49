// SPDX-License-Identifier: MIT-0
// Long trajectories have the same bits from every compiler, at every -O, on every machine.
#include <bit>
#include <catch2/catch_test_macros.hpp>
#include <cstdint>

#include "measure/run.h"
#include "scenes/orbit.h"
#include "scenes/outer_solar_system.h"
#include "scenes/pendulum.h"

namespace {

// FNV-1a, one double at a time.
struct Hash {
  std::uint64_t value = 0xcbf29ce484222325;

  void add(double x) { value = (value ^ std::bit_cast<std::uint64_t>(x)) * 0x100000001b3; }

  template <class Vec>
  void add(const Vec& x) {
    for (const double coordinate : x.reshaped()) add(coordinate);
  }
};

template <class Step, class Scene, class Vec>
std::uint64_t hash_of_run(Step step, const Scene& scene, scenes::State<Vec> s, double h,
                          int steps) {
  Hash hash;
  measure::run(step, scene, s, h, steps, [&hash](double, const scenes::State<Vec>& now) {
    hash.add(now.x);
    hash.add(now.v);
  });
  return hash.value;
}

const scenes::Pendulum<> pendulum{.angle = 3};
const scenes::State<Eigen::Vector2d> perihelion{{0.4, 0}, {0, 2}};
const scenes::OuterSolarSystem<> planets;

}  // namespace

TEST_CASE("A long run of Euler has the same bits everywhere") {
  CHECK(hash_of_run(measure::euler, pendulum, pendulum.start(), 1e-3, 100'000) ==
        0xca3730641a5583c7);
  CHECK(hash_of_run(measure::euler, scenes::Orbit<>(), perihelion, 1e-3, 100'000) ==
        0xdc140d29f294789d);
  CHECK(hash_of_run(measure::euler, planets, planets.start(), 10.0, 2000) == 0xa0f33b171bfdd187);
}

TEST_CASE("A long run of symplectic Euler has the same bits everywhere") {
  CHECK(hash_of_run(measure::symplectic_euler, pendulum, pendulum.start(), 1e-3, 100'000) ==
        0xc841e137cd723256);
  CHECK(hash_of_run(measure::symplectic_euler, scenes::Orbit<>(), perihelion, 1e-3, 100'000) ==
        0x412fc400032ff1f9);
  CHECK(hash_of_run(measure::symplectic_euler, planets, planets.start(), 10.0, 2000) ==
        0x3f2555ec196ee37d);
}

TEST_CASE("A long run of constant accelerations has the same bits everywhere") {
  const auto step = measure::constant_acceleration;
  CHECK(hash_of_run(step, pendulum, pendulum.start(), 1e-3, 100'000) == 0x203c7408c3b84d4c);
  CHECK(hash_of_run(step, scenes::Orbit<>(), perihelion, 1e-3, 100'000) == 0x4ced0df9a4a27e14);
  CHECK(hash_of_run(step, planets, planets.start(), 10.0, 2000) == 0x96dc6b8ed143800c);
}
