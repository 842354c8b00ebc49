// SPDX-License-Identifier: MIT-0
#include "scenes/outer_solar_system.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>

#include "runge_kutta.h"

using Catch::Matchers::WithinRel;
using System = scenes::OuterSolarSystem<>;

namespace {

// Half the long axis [AU] and the eccentricity of the orbit of each body but the sun, from
// almanacs.
constexpr struct {
  double axis, eccentricity;
} seen[] = {{5.20, 0.048}, {9.55, 0.055}, {19.2, 0.047}, {30.1, 0.009}, {39.5, 0.249}};

}  // namespace

TEST_CASE("The outer solar system starts with the published data, digit for digit") {
  std::ifstream published(OUTER_SOLAR_SYSTEM_CSV);
  std::string line;
  while (std::getline(published, line) && !line.starts_with("body")) continue;
  const auto start = System().start();
  for (int body = 0; body < System::bodies; ++body) {
    REQUIRE(std::getline(published, line));
    std::istringstream row(line);
    const auto cell = [&row] {
      std::string text;
      std::getline(row, text, ',');
      return text;
    };
    CHECK(cell() == System::names[body]);
    CHECK(std::stod(cell()) == System::masses[body]);
    for (int axis = 0; axis < 3; ++axis) CHECK(std::stod(cell()) == start.x(axis, body));
    for (int axis = 0; axis < 3; ++axis) CHECK(std::stod(cell()) == start.v(axis, body));
  }
}

TEST_CASE("The outer bodies are on the orbits that astronomers see") {
  const auto start = System().start();
  for (int body = 1; body < System::bodies; ++body) {
    CAPTURE(System::names[body]);
    const Eigen::Vector3d x = start.x.col(body) - start.x.col(0);
    const Eigen::Vector3d v = start.v.col(body) - start.v.col(0);
    const double mu = System::G * (System::masses[0] + System::masses[body]);
    const double axis = 1 / (2 / x.norm() - v.squaredNorm() / mu);
    const Eigen::Vector3d spin = x.cross(v);
    const double eccentricity = std::sqrt(1 - spin.squaredNorm() / (mu * axis));
    CHECK_THAT(axis, WithinRel(seen[body - 1].axis, 0.01));
    CHECK(std::abs(eccentricity - seen[body - 1].eccentricity) < 0.008);
  }
  // Gauss's constant, and the sun with Mercury, Venus, Earth, Moon and Mars added.
  CHECK_THAT(std::sqrt(System::G), WithinRel(0.01720209895, 1e-10));
  const double inner_planets = 1 / 6023600.0 + 1 / 408523.5 + 1 / 328900.5 + 1 / 3098710.0;
  CHECK_THAT(System::masses[0] - 1, WithinRel(inner_planets, 1e-4));
}

// Leapfrogs extrapolated at 25 digits: see reference.py.
TEST_CASE("After 4000 days the outer bodies are where Newton's law takes them") {
  System::Vec known;
  known.transpose() << 0.029076235039893871289, -0.015029320034203032013, -0.0072994159523863427553,
      -4.9435585951104338544, -2.1126281417711540672, -0.78533143071798730792,  //
      -4.757104887078530233, 7.0490308754771504268, 3.1163923811415603608,      //
      18.706601098964842091, -6.6405165166985625748, -3.1732112199750124544,    //
      21.718030076294600299, -19.083625625735091017, -8.3521512084407359562,    //
      -3.4487011314999520526, -29.694929940151520171, -8.2229269749172853748;
  const auto end = runge_kutta(System(), System().start(), 4000, 4000);
  CHECK((end.x - known).colwise().norm().maxCoeff() < 1e-11);
}

TEST_CASE("The outer solar system has the energy that its data says, and keeps what Newton keeps") {
  const System system;
  const auto start = system.start();
  const auto end = runge_kutta(system, start, 20'000, 2000);
  CHECK_THAT(system.energy(start.x, start.v), WithinRel(-3.2154531832081635676e-8, 1e-14));
  CHECK_THAT(system.energy(end.x, end.v), WithinRel(system.energy(start.x, start.v), 1e-9));
  CHECK((system.momentum(end.v) - system.momentum(start.v)).norm() < 1e-13 * 7.5e-6);
  const Eigen::Vector3d spin = system.angular_momentum(start.x, start.v);
  CHECK((system.angular_momentum(end.x, end.v) - spin).norm() < 1e-9 * spin.norm());
  // Bodies on circles of the axes that are seen would have mass * sqrt(G * axis) each.
  double circles = 0;
  for (int body = 1; body < System::bodies; ++body) {
    circles += System::masses[body] * std::sqrt(System::G * seen[body - 1].axis);
  }
  CHECK_THAT(spin.norm(), WithinRel(circles, 0.003));
  // Its axis is close to that of the ecliptic, which leans 23.4 degrees towards -y.
  CHECK(spin.dot(Eigen::Vector3d(0, -0.398, 0.917)) > 0.999 * spin.norm());
}
