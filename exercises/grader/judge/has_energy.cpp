// SPDX-License-Identifier: MIT-0
#include <algorithm>
#include <cmath>

#include "format_values.h"
#include "judge/describe.h"
#include "judge/orbit_energy.h"
#include "judge/session.h"
#include "judge/tests.h"

namespace judge {
namespace {

using grade::number;

struct Turns {
  Orbit orbit;
  double h;
  int steps, every;

  Turns(double eccentricity, int turns, int per_turn) {
    Random random;
    orbit = Orbit::draw(random, eccentricity);
    h = orbit.period() / per_turn;
    every = std::max(1, turns * per_turn / 2000);
    steps = turns * per_turn / every * every;
  }

  Path by(Student& student, int function) const {
    return student.run(orbit.start, h, steps, every, orbit.force(), function);
  }
};

grade::Finding asked(const Turns& turns, int count, int per_turn) {
  grade::Finding finding;
  finding.asked = std::to_string(count) + " turns of " + describe(turns.orbit.force()) +
                  " with an eccentricity of " + number(turns.orbit.eccentricity) + ", " +
                  std::to_string(per_turn) + " steps a turn";
  finding.input = describe(turns.orbit.start) + ", h = " + number(turns.h, 17);
  return finding;
}

grade::Curve curve(const std::string& name, const Turns& turns, const std::vector<double>& errors) {
  grade::Curve curve{name, {}, errors};
  for (std::size_t n = 0; n < errors.size(); ++n) {
    curve.x.push_back(static_cast<double>(n) * turns.every * turns.h / turns.orbit.period());
  }
  return curve;
}

grade::Plot plot(const std::vector<grade::Curve>& curves) {
  return {"Energy", "turns", "energy error", curves};
}

double furthest_apart(const std::vector<double>& a, const std::vector<double>& b) {
  double found = 0;
  for (std::size_t n = 0; n < a.size(); ++n) {
    const double apart = std::abs(a[n] - b[n]);
    found = std::isfinite(apart) ? std::max(found, apart) : INFINITY;
  }
  return found;
}

}  // namespace

void has_energy_of(Student& student, const Method& method, double eccentricity, int count,
                   int per_turn, const std::string& hint, int function) {
  const Turns turns(eccentricity, count, per_turn);
  const Path theirs =
      run(method, turns.orbit.start, turns.h, turns.steps, turns.every, turns.orbit.force());
  const std::vector<double> expected = energy_error(turns.orbit, theirs);
  const std::vector<double> got = energy_error(turns.orbit, turns.by(student, function));
  const double tolerance = largest(expected, 0, 1) / 100;

  grade::Finding finding = asked(turns, count, per_turn);
  const double apart = furthest_apart(got, expected);
  finding.held = apart <= tolerance;
  finding.expected = "as far off as " + method.name + ": at most " +
                     number(largest(expected, 0, 1), 4) + " of the energy, " +
                     number(expected.back(), 4) + " at the end";
  finding.got =
      "at most " + number(largest(got, 0, 1), 4) + ", " + number(got.back(), 4) + " at the end";
  finding.error = number(apart, 3);
  finding.tolerance = number(tolerance, 2);
  finding.tolerance_from = "a hundredth of the largest energy error of " + method.name;
  if (!finding.held) {
    finding.hint = hint;
    finding.plot = plot({curve("yours", turns, got), curve(method.name, turns, expected)});
  }
  check(finding);
}

}  // namespace judge
