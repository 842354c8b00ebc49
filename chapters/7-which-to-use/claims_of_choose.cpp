// SPDX-License-Identifier: MIT-0
// What `choose` answers, on fifty scenes drawn at random, against a search that has a loop, a truth
// and an error of its own.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "choose/contests.h"
#include "choose/entrants.h"
#include "choose/own_contest.h"
#include "level.h"

using Catch::Matchers::WithinRel;
using measure::Method;

namespace {

/// The places of a scene at the end of each frame: by RK4, in so many steps of each frame that they
/// are right far beyond any bound that is asked for here.
template <class Scene>
auto true_places(const Scene& scene, const Bounds& bounds) {
  const auto start = scene.start();
  auto x = start.x, v = start.v;
  std::vector<decltype(x)> places{x};
  constexpr long fine = 2000;
  const double h = 1 / bounds.hz / double(fine);
  for (long n = 0; n < bounds.frames() * fine; ++n) {
    using Vec = decltype(x);
    const double t = double(n) * h;
    const Vec a1 = scene(x, v, t);
    const Vec v2 = v + h / 2 * a1, a2 = scene(Vec(x + h / 2 * v), v2, t + h / 2);
    const Vec v3 = v + h / 2 * a2, a3 = scene(Vec(x + h / 2 * v2), v3, t + h / 2);
    const Vec v4 = v + h * a3, a4 = scene(Vec(x + h * v3), v4, t + h);
    x = x + h / 6 * (v + 2 * v2 + 2 * v3 + v4);
    v = v + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    if ((n + 1) % fine == 0) places.push_back(x);
  }
  return places;
}

/// The largest of the distances, as a share of the farthest of the true places.
template <class Places>
double share(const Places& places, const Places& truth) {
  double worst = 0, farthest = 0;
  for (std::size_t n = 0; n < truth.size(); ++n) {
    farthest = std::max(farthest, measure::length(truth[n]));
    const double error = measure::length(places[n] - truth[n]);
    if (!(error <= worst)) worst = error;
  }
  return worst / farthest;
}

/// The places of a method at the end of each frame.
template <class Scene>
auto places_of(const Method& method, const Scene& scene, const Bounds& bounds, long substeps) {
  const double h = 1 / (bounds.hz * double(substeps));
  auto memory = method.start(scene.start(), h, scene);
  std::vector places{scene.start().x};
  for (long n = 0; n < bounds.frames() * substeps; ++n) {
    method.step(memory, double(n) * h, h, scene);
    if ((n + 1) % substeps == 0)
      places.push_back(method.to_state(memory, double(n + 1) * h, h, scene).x);
  }
  return places;
}

/// Every way to be good enough for less, by name.
template <class Scene, class Places>
std::string cheaper(const Scene& scene, const Bounds& bounds, const Places& truth, double than) {
  std::string found;
  for (const Method* method : entrants_on(scene)) {
    for (long substeps = 1;
         double(substeps) * evaluations_per_step(*method) * bounds.hz < than - 1e-9; ++substeps) {
      if (share(places_of(*method, scene, bounds, substeps), truth) <= bounds.error)
        found += std::string(method->function) + " " + std::to_string(substeps) + ", ";
    }
  }
  return found;
}

/// The least evaluations a second that a tolerance takes and is good enough; infinite if
/// none is.
template <class Scene, class Places>
double least_of_adaptive(const Scene& scene, const Bounds& bounds, const Places& truth) {
  double least = INFINITY, farthest = 0;
  for (const auto& place : truth) farthest = std::max(farthest, measure::length(place));
  for (double exponent = 1; exponent <= 14; exponent += 0.5) {
    long asked = 0;
    const auto acceleration = [&](const auto& x, const auto& v, double t) {
      ++asked;
      return scene(x, v, t);
    };
    const auto start = scene.start();
    auto path = integrate::dopri5_path(start.x, start.v, 0.0, 1 / bounds.hz, acceleration);
    const auto norm = [](const auto& error) { return measure::length(error); };
    std::vector places{start.x};
    bool arrived = true;
    for (std::size_t n = 1; n < truth.size() && arrived; ++n) {
      arrived = integrate::dopri5_adaptive(path, double(n) / bounds.hz, acceleration, norm,
                                           std::pow(10, -exponent) * farthest);
      places.push_back(path.position(double(n) / bounds.hz));
    }
    if (!arrived || share(places, truth) > bounds.error) continue;
    least = std::min(least, double(asked) * bounds.hz / double(bounds.frames()));
  }
  return least;
}

/// Checks the answer for a scene.
template <class Scene>
void check(const Scene& scene, const Bounds& bounds) {
  const Contest found = full_contest(scene, bounds);
  const Entry& best = found.methods.front();
  CAPTURE(bounds.hz, bounds.seconds, bounds.error, best.method->function, best.last.substeps);
  const auto truth = true_places(scene, bounds);
  REQUIRE(best.good);
  CHECK(best.evaluations ==
        double(best.last.substeps) * evaluations_per_step(*best.method) * bounds.hz);
  CHECK(share(places_of(*best.method, scene, bounds, best.last.substeps), truth) <= bounds.error);
  CHECK(cheaper(scene, bounds, truth, best.evaluations).empty());
  const Entry& adaptive = found.undisturbed.front();
  const double least = least_of_adaptive(scene, bounds, truth);
  CHECK(adaptive.good == std::isfinite(least));
  if (adaptive.good) CHECK_THAT(adaptive.evaluations, WithinRel(least, 1e-9));
}

}  // namespace

TEST_CASE("Of two that cost the same choose names the one that holds in uneven frames") {
  const scenes::Spring<> spring{.omega = 50, .zeta = 0.1};
  const Bounds bounds{.hz = 60, .seconds = 2, .error = 0.005};
  const Contest found = full_contest(spring, bounds);
  const Entry &dopri5 = entry_of(found, method::dopri5),
              &verlet = entry_of(found, method::velocity_verlet);
  CHECK(dopri5.evaluations == verlet.evaluations);
  CHECK(dopri5.last.error < verlet.last.error / 5);
  CHECK(dopri5.uneven > 10 * bounds.error);
  CHECK(verlet.uneven < bounds.error);
  CHECK(found.methods.front().method == &method::velocity_verlet);
}

TEST_CASE(
    "Where in its step a force switches changes the error of RK4 and velocity Verlet tenfold or "
    "more") {
  // A wheel on a spring, at a kerb
  const scenes::Spring<> spring{.omega = 10, .zeta = 0.1, .x0 = -1, .v0 = 0};
  constexpr double h = 1.0 / 60;
  for (const Method* method : {&method::rk4, &method::velocity_verlet}) {
    double least = INFINITY, most = 0;
    for (double part = 0.05; part < 1; part += 0.05) {
      const double kerb = 1 + part * h;
      const auto force = [&](double x, double v, double t) {
        return spring(x - (t > kerb ? 1.0 : 0.0), v, t);
      };
      auto memory = method->start(scenes::State<double>{0, 0}, h, force);
      double worst = 0;
      for (int n = 0; n < 180; ++n) {
        method->step(memory, n * h, h, force);
        const double t = (n + 1) * h, truth = t > kerb ? 1 + spring.exact(t - kerb).x : 0;
        worst = std::max(worst, std::abs(method->to_state(memory, t, h, force).x - truth));
      }
      least = std::min(least, worst), most = std::max(most, worst);
    }
    CAPTURE(method->name, least, most);
    CHECK(most > 10 * least);
  }
}

namespace {

/// A wheel on a spring that meets a kerb so many quarters of a frame after a second, at 60 Hz, as a
/// scene of one's own.
template <int quarters>
OwnForce kerb_after() {
  return {1, false,
          [](double* x, double* v) {
            *x = 0.1;
            *v = 0;
          },
          [](const double* x, const double* v, double t, double* a) {
            const double road = t > 1 + quarters / 240.0 ? 1 : 0;
            *a = -400 * (*x - road) - 4 * *v;
          }};
}

/// The best of such a contest, and whether a warning goes with it.
struct Told {
  long steps;
  bool warned;
};

Told told(const OwnForce& force, bool phases) {
  Bounds bounds{.seconds = 2};
  const Contest found = own_contest(force, bounds, {.phases = phases}, {});
  return {found.methods.front().last.substeps, !found.warning.empty()};
}

}  // namespace

TEST_CASE(
    "At a kerb two or three steps a frame seem enough, with a warning, and with phases eight or "
    "nine are needed wherever it lies") {
  for (const OwnForce& force :
       {kerb_after<0>(), kerb_after<1>(), kerb_after<2>(), kerb_after<3>()}) {
    const Told at_once = told(force, false), sure = told(force, true);
    CHECK((at_once.steps == 2 || at_once.steps == 3));
    CHECK(at_once.warned);
    CHECK((sure.steps == 8 || sure.steps == 9));
    CHECK_FALSE(sure.warned);
  }
}

TEST_CASE("On fifty scenes drawn at random nothing is cheaper than what choose answers") {
  std::mt19937 draw(7);
  const auto between = [&](double low, double high) {  // by factors
    return low * std::pow(high / low, double(draw()) / double(std::mt19937::max()));
  };
  const double rates[] = {15, 30, 60, 120};
  for (int n = 0; n < 50; ++n) {
    const Bounds bounds{.hz = rates[draw() % 4],
                        .seconds = std::round(between(1, 4)),
                        .error = between(3e-4, 0.03)};
    CAPTURE(n);
    switch (n % 5) {
      case 0:
        check(scenes::Spring<>{.omega = between(2, 40), .zeta = between(0.01, 2)}, bounds);
        break;
      case 1:
        check(scenes::Orbit<>{.eccentricity = between(0.05, 0.7), .mu = between(0.5, 20)}, bounds);
        break;
      case 2:
        check(scenes::Pendulum<>{.g = between(2, 60), .angle = between(0.1, 3)}, bounds);
        break;
      case 3:
        check(scenes::LinearDrag<>{.c = between(0.1, 15)}, bounds);
        break;
      default:
        check(scenes::Spring<>{.omega = between(2, 20)}, bounds);
    }
  }
}
