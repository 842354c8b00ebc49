// SPDX-License-Identifier: MIT-0
// The headers against numbers that others have printed. Each name is a sentence of the preface.
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <cstddef>
#include <functional>

#include "integrate/dopri5.h"
#include "measure/energy.h"
#include "measure/length.h"
#include "measure/methods.h"
#include "measure/run.h"
#include "scenes/orbit.h"
#include "scenes/outer_solar_system.h"
#include "scenes/state.h"

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using Eigen::Vector2d;
using scenes::State;

namespace {

// The ellipse of SUNDIALS, examples/arkode/C_serial/ark_kepler.c: eccentricity 0.6 from its
// nearest place, for a time of 50.
constexpr scenes::Orbit<> ellipse{.eccentricity = 0.6, .semi_major = 1, .mu = 1};

// What it prints of the energy at the end, less that of the start, with steps of 1/1000, 1/2000,
// 1/4000 and 1/8000: the files ark_kepler_*.out beside it.
using FourSteps = std::array<double, 4>;
constexpr FourSteps symplectic_euler_1_1{-1.2973337429578180e-03, -6.5221362034773023e-04,
                                         -3.2690039061167298e-04, -1.6363718517031778e-04};
constexpr FourSteps leapfrog_2_2{-1.0321183419037538e-07, -2.5832368022449259e-08,
                                 -6.4599039450996543e-09, -1.6151293635857655e-09};
constexpr FourSteps pseudo_leapfrog_2_2{3.2112992007782282e-06, 8.0215800046801178e-07,
                                        2.0049772198049709e-07, 5.0121824024529360e-08};

template <class Method>
FourSteps energies(Method method) {
  FourSteps found;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const long steps = 50'000L << i;
    const auto end = measure::after(method, ellipse, State<Vector2d>{{0.4, 0}, {0, 2}},
                                    50.0 / double(steps), steps);
    found[i] = ellipse.energy(end.x, end.v) - ellipse.energy({0.4, 0}, {0, 2});
  }
  return found;
}

// Where dopri5_adaptive gets to with a tolerance that leaves little but rounding.
template <class Vec, class Acceleration>
State<Vec> moved(State<Vec> s, double t, double duration, const Acceleration& acceleration) {
  double h = 1e-3;
  const auto length = [](const Vec& x) { return measure::length(x); };
  REQUIRE(integrate::dopri5_adaptive(s.x, s.v, t, duration, h, acceleration, length, 1e-13));
  return s;
}

// The orbit of Arenstorf, between earth and moon, in the frame that turns with them: the force
// depends on the velocity. Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I
// (1993), section II.0, and Hairer's dr_dopri5.f.
Vector2d arenstorf(const Vector2d& x, const Vector2d& v, double) {
  const double moon = 0.012277471, earth = 1 - moon;
  const Vector2d from_earth = x + Vector2d(moon, 0), from_moon = x - Vector2d(earth, 0);
  return x + 2 * Vector2d(v.y(), -v.x()) - earth / std::pow(from_earth.norm(), 3) * from_earth -
         moon / std::pow(from_moon.norm(), 3) * from_moon;
}

// Seven stars in a plane, of masses 1 to 7: Test Set for Initial Value Problem Solvers, Pleiades.
using Stars = Eigen::Matrix<double, 2, 7>;
Stars pleiades(const Stars& x, const Stars&, double) {
  Stars a = Stars::Zero();
  for (int i = 0; i < 7; ++i) {
    for (int j = 0; j < 7; ++j) {
      if (i == j) continue;
      const Vector2d way = x.col(j) - x.col(i);
      a.col(i) += double(j + 1) / std::pow(way.norm(), 3) * way;
    }
  }
  return a;
}

// The class E of DETEST, at t = 20 from x and v.
struct OfClassE {
  std::function<double(double, double, double)> acceleration;
  State<double> start, end;
};

}  // namespace

TEST_CASE("Symplectic Euler's energy on an ellipse is that of SUNDIALS to nine digits") {
  const FourSteps found = energies(measure::symplectic_euler);
  for (std::size_t i = 0; i < found.size(); ++i) {
    CHECK_THAT(found[i], WithinRel(symplectic_euler_1_1[i], 5e-10));
  }
}

TEST_CASE("The energies of both leapfrogs on an ellipse are those of SUNDIALS to rounding") {
  // The energies are differences of numbers near 3 at the start, and a step rounds some ten times;
  // 400 000 roundings at random add up to as much as the root of their number. At the longest step
  // that leaves eight digits of the one and six of the other.
  const double rounding = 1e-15 * std::sqrt(400'000.0);
  const FourSteps kick_first = energies(measure::velocity_verlet);
  const FourSteps drift_first = energies(measure::leapfrog_drift);
  for (std::size_t i = 0; i < kick_first.size(); ++i) {
    CHECK_THAT(kick_first[i], WithinAbs(pseudo_leapfrog_2_2[i], rounding));
    CHECK_THAT(drift_first[i], WithinAbs(leapfrog_2_2[i], rounding));
  }
  CHECK_THAT(kick_first[0], WithinRel(pseudo_leapfrog_2_2[0], 2e-8));
  CHECK_THAT(drift_first[0], WithinRel(leapfrog_2_2[0], 5e-7));
}

TEST_CASE("Arenstorf's orbit goes through the nine places that are printed") {
  const Vector2d places[] = {{-0.5798767232, 0.6090783555},  {-0.1983328832, 1.137637824},
                             {-0.4735743108, 0.2239077929},  {-1.174553507, -0.2759450770},
                             {-0.8398071663, 0.4468314171},  {0.01314377269, -0.8385747019},
                             {-0.6031162761, -0.9912585277}, {0.2427044376, -0.3899991215}};
  State<Vector2d> s{{0.994, 0}, {0, -2.00158510637908252240537862224}};
  double t = 0;
  for (const Vector2d& place : places) {
    s = moved(s, t, 2.0, arenstorf);
    t += 2;
    CHECK((s.x - place).lpNorm<Eigen::Infinity>() < 2e-9);
  }
  s = moved(s, t, 17.0652165601579625588917206249 - t, arenstorf);
  CHECK((s.x - Vector2d(0.994, 0)).norm() < 1e-9);
}

TEST_CASE("The seven stars of the Pleiades problem end where the test set has them") {
  State<Stars> s;
  s.x << 3, 3, -1, -3, 2, -2, 2, 3, -3, 2, 0, 0, -4, 4;
  s.v << 0, 0, 0, 0, 0, 1.75, -1.5, 0, 0, 0, -1.25, 1, 0, 0;
  Stars end;
  end << 0.3706139143970502, 3.237284092057233, -3.222559032418324, 0.6597091455775310,
      0.3425581707156584, 1.562172101400631, -0.7003092922212495, -3.943437585517392,
      -3.271380973972550, 5.225081843456543, -2.590612434977470, 1.198213693392275,
      -0.2429682344935824, 1.091449240428980;
  CHECK((moved(s, 0, 3.0, pleiades).x - end).lpNorm<Eigen::Infinity>() < 1e-9);
}

TEST_CASE("The ellipses of DETEST end where Enright and Pryce have them") {
  // W. H. Enright and J. D. Pryce, Two FORTRAN packages for assessing initial value methods, ACM
  // Transactions on Mathematical Software 13 (1987): D1 to D5 at t = 20, position and velocity.
  const State<Vector2d> ends[] = {
      {{0.2198835352008397, 0.9427076846341813}, {-0.9787659841058176, 0.3287977990962036}},
      {{-0.1777027357140412, 0.9467784719905892}, {-1.030294163192969, 0.1211074890053952}},
      {{-0.5780432953035361, 0.8633840009194193}, {-0.9595083730380727, -0.06504915126712089}},
      {{-0.9538990293416394, 0.6907409024219432}, {-0.8212674270877433, -0.1539574259125825}},
      {{-1.295266250987574, 0.4003938963792321}, {-0.6775390924707566, -0.1270838154278686}}};
  double e = 0.1;
  for (const auto& end : ends) {
    CAPTURE(e);
    const State<Vector2d> start{{1 - e, 0}, {0, std::sqrt((1 + e) / (1 - e))}};
    const auto found = moved(start, 0, 20.0, ellipse);
    CHECK((found.x - end.x).norm() < 1e-9);
    CHECK((found.v - end.v).norm() < 1e-9);
    e += 0.2;
  }
}

TEST_CASE("The four equations of DETEST's class E end where Enright and Pryce have them") {
  const OfClassE problems[] = {
      {[](double x, double v, double) { return (1 - x * x) * v - x; },  // E2, van der Pol
       {2, 0},
       {2.008149762174948, -0.04250887527320057}},
      {[](double x, double, double t) { return x * x * x / 6 - x + 2 * std::sin(2.78535 * t); },
       {0, 0},
       {-0.1004178858647128, 0.2411400132095954}},
      {[](double, double v, double) { return 0.032 - 0.4 * v * v; },
       {30, 0},
       {33.95091444646555, 0.2767822659672869}},
      {[](double, double v, double t) { return std::sqrt(1 + v * v) / (25 - t); },
       {0, 0},
       {14.11797390542629, 2.400000000000002}}};
  for (const OfClassE& problem : problems) {
    const auto found = moved(problem.start, 0, 20.0, problem.acceleration);
    CHECK_THAT(found.x, WithinAbs(problem.end.x, 1e-10));
    CHECK_THAT(found.v, WithinAbs(problem.end.v, 1e-10));
  }
}

TEST_CASE("Euler loses the outer planets; symplectic Euler keeps them at steps ten times as long") {
  // Hairer, Lubich and Wanner, Geometric Numerical Integration (2006), section I.2.4, draw 200 000
  // days: with Euler's method at ten days the planets spiral outwards, with symplectic Euler at 100
  // and Verlet's method at 200 they stay.
  const scenes::OuterSolarSystem<> planets;
  struct Seen {
    double lost, jupiter;  // of the energy, relative; farthest from the sun [AU]
  };
  const auto seen = [&](auto method, double h) {
    Seen found{};
    const long steps = std::lround(200'000 / h);
    const auto energy = [&](const auto& x, const auto& v) { return planets.energy(x, v); };
    found.lost = measure::drift(method, planets, h, steps, energy).largest;
    auto s = planets.start();
    measure::run(method, planets, s, h, steps, [&](double, const auto& now) {
      found.jupiter = std::max(found.jupiter, (now.x.col(1) - now.x.col(0)).norm());
    });
    return found;
  };
  const Seen euler = seen(measure::euler, 10.0);
  const Seen symplectic = seen(measure::symplectic_euler, 100.0);
  const Seen verlet = seen(measure::velocity_verlet, 200.0);
  CAPTURE(euler.jupiter, symplectic.jupiter, verlet.jupiter);
  CHECK(euler.jupiter > 10);
  CHECK(symplectic.jupiter < 6);  // Jupiter's aphelion is at 5.46
  CHECK(verlet.jupiter < 6);
  CHECK_THAT(euler.lost, WithinAbs(0.66, 0.005));
  CHECK_THAT(symplectic.lost, WithinAbs(2.527e-2, 5e-6));
  CHECK_THAT(verlet.lost, WithinAbs(1.96e-3, 5e-6));
  CHECK_THAT(seen(measure::yoshida4, 100.0).lost, WithinAbs(3.7e-5, 5e-7));
}

TEST_CASE("On an ellipse drift, kick, drift errs by about a sixth of what kick, drift, kick does") {
  const auto energy = [](const auto& x, const auto& v) { return ellipse.energy(x, v); };
  const auto largest = [&](auto method, double h) {
    return measure::drift(method, ellipse, h, std::lround(50 / h), energy).largest;
  };
  for (const double h : {1e-3, 1e-2, 2e-2}) {
    const double ratio = largest(measure::velocity_verlet, h) / largest(measure::leapfrog_drift, h);
    CHECK_THAT(ratio, WithinAbs(5.8, 0.05));
  }
}
