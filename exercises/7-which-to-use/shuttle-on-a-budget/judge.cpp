// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "format_values.h"
#include "judge/describe.h"
#include "judge/orbit_energy.h"
#include "judge/session.h"
#include "judge/tests.h"

using namespace judge;
using grade::number;

namespace {

constexpr int budget = 1200;

// An orbit around a planet that is a little flat, with a moon that tugs.
struct Flight {
  Start start;
  double mu, flatness, tug, seconds;

  static Flight draw(Random& random) {
    const Orbit orbit = Orbit::draw(random, random.between(0.78, 0.82));
    return {orbit.start, orbit.mu, random.between(0.001, 0.003), random.between(0.01, 0.02),
            random.between(1.4, 1.6) * orbit.period()};
  }

  Vec operator()(const Vec& x, const Vec&, double t) const {
    const double r2 = dot(x, x), r = std::sqrt(r2);
    return (-mu / (r2 * r) * (1 + flatness / r2)) * x + Vec{0, 0, tug * std::cos(t)};
  }

  State by(const Method& method, int steps) const {
    return run(method, start, seconds / steps, steps, steps, *this).states.back();
  }

  // Halving its step moves this by less than a thousandth of the finest bound.
  State truth() const { return by(rk4, 60000); }

  std::string input() const {
    return describe(start) + ", " + number(seconds, 17) + " s; a pull of " + number(mu, 17) +
           " / r^2 (1 + " + number(flatness, 17) + " / r^2) and a tug of " + number(tug, 17) +
           " cos t along z";
  }
};

// How far off equal steps of the two methods are, for the whole budget; Verlet asks once to begin.
struct Equal {
  double verlet, rk4;

  explicit Equal(const Flight& flight)
      : verlet(distance(flight.by(velocity_verlet, budget - 1), flight.truth())),
        rk4(distance(flight.by(judge::rk4, budget / 4), flight.truth())) {}
};

grade::Plot evaluations(const Path& path, const Flight& flight) {
  grade::Curve steps{"yours", {}, {}};
  for (const Evaluation& asked : path.evaluations) {
    steps.x.push_back(asked.t / flight.seconds);
    steps.y.push_back(length(asked.x));
  }
  return {"Where you asked", "share of the flight", "distance from the planet [m]", {steps}};
}

void lands_within(Student& student, const Flight& flight, double bound, const std::string& from,
                  const std::string& hint) {
  const Path path = student.watch(flight.start, flight.seconds, 1, flight);
  const State truth = flight.truth();
  const double off = distance(path.states.back(), truth);
  const std::size_t count = path.evaluations.size();
  grade::Finding finding;
  finding.held = off <= bound && count <= budget;
  finding.asked = "one flight, with at most " + std::to_string(budget) + " evaluations";
  finding.input = flight.input();
  finding.expected = describe(truth) + ", to " + number(bound, 3);
  finding.got = describe(path.states.back()) + ", with " + std::to_string(count) + " evaluations";
  finding.error = number(off, 3);
  finding.tolerance = number(bound, 3) + ", and " + std::to_string(budget) + " evaluations";
  finding.tolerance_from = from;
  if (!finding.held) {
    finding.hint = hint;
    finding.plot = evaluations(path, flight);
    if (count > budget) {
      finding.diagnoses = {"it asked " + std::to_string(count - budget) + " times too often"};
    } else if (count < budget / 2) {
      finding.diagnoses = {"more than half of the evaluations were never spent"};
    }
  }
  check(finding);
}

void lands_nearer_than_rk4(double times, const std::string& hint) {
  Student student;
  Random random;
  for (int n = 0; n < 2; ++n) {
    const Flight flight = Flight::draw(random);
    const Equal equal(flight);
    lands_within(student, flight, equal.rk4 / times,
                 "RK4 in " + std::to_string(budget / 4) + " equal steps is off by " +
                     number(equal.rk4, 3) + ", and this is a share of 1/" + number(times),
                 hint);
  }
}

}  // namespace

TEST_CASE("within the budget the shuttle lands as near as equal steps bring it",
          "[7-which-to-use/shuttle-on-a-budget][3 points]") {
  Student student;
  Random random;
  for (int n = 0; n < 2; ++n) {
    const Flight flight = Flight::draw(random);
    const Equal equal(flight);
    lands_within(student, flight, 1.001 * std::max(equal.verlet, equal.rk4),
                 "the farther of velocity Verlet, off by " + number(equal.verlet, 3) +
                     ", and RK4, " + number(equal.rk4, 3) +
                     ", both in equal steps for all of the budget; and a "
                     "thousandth for the order of the sums",
                 "Take RK4, and divide the flight into equal steps for a start.");
  }
}

TEST_CASE("it lands twenty times nearer than RK4 in equal steps",
          "[7-which-to-use/shuttle-on-a-budget][3 points]") {
  lands_nearer_than_rk4(
      20, "Take short steps where the planet is near, and long ones where it is far.");
}

TEST_CASE("it lands eighty times nearer than RK4 in equal steps",
          "[7-which-to-use/shuttle-on-a-budget][4 points]") {
  lands_nearer_than_rk4(80,
                        "A circle of radius r takes a time in proportion to r^(3/2). And is all of "
                        "the budget spent?");
}
