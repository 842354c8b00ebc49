// SPDX-License-Identifier: MIT-0
/// @file
/// Places beside those where they should be.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "format_values.h"
#include "judge/describe.h"
#include "judge/numbers.h"
#include "judge/session.h"
#include "judge/tests.h"

namespace judge::verlet {

/// A path, place after place, and how a message calls it.
struct Places {
  std::string name;
  std::vector<Vec> x;  ///< [m]
};

/// The question of a test, apart from the places themselves.
struct Asked {
  std::string what;
  std::string input;
  Tolerance tolerance;
  std::string hint;
  std::vector<double> times;  ///< of the places [s]; none if a picture would say nothing
};

inline grade::Curve curve(const Places& places, const std::vector<double>& times) {
  grade::Curve curve{places.name, times, {}};
  for (const Vec& x : places.x) curve.y.push_back(x.y);
  return curve;
}

inline std::vector<std::string> not_finite(const std::vector<Vec>& yours) {
  for (std::size_t n = 0; n < yours.size(); ++n) {
    if (!std::isfinite(length(yours[n])))
      return {"the first place that is not a finite number is number " + std::to_string(n + 1)};
  }
  return {};
}

/// The name of place n in a message.
inline std::string name_of(std::size_t n, std::size_t count) {
  return count == 1 ? "" : "place " + std::to_string(n + 1) + ": ";
}

/// Checks that each of the places is where it should be.
inline void are_places(const Asked& asked, const std::vector<Vec>& yours, const Places& expected) {
  std::size_t n = 0;
  while (n < yours.size() && length(yours[n] - expected.x[n]) <= asked.tolerance.value) ++n;
  grade::Finding finding;
  finding.held = n == expected.x.size();
  finding.asked = asked.what;
  finding.input = asked.input;
  finding.tolerance = grade::number(asked.tolerance.value, 2);
  finding.tolerance_from = asked.tolerance.from;
  if (finding.held) return check(finding);
  const std::string which = name_of(n, yours.size());
  finding.expected = which + describe(expected.x[n], 12);
  finding.got = which + describe(yours[n], 12);
  finding.error = grade::number(length(yours[n] - expected.x[n]), 3);
  finding.hint = asked.hint;
  finding.diagnoses = not_finite(yours);
  if (!asked.times.empty()) {
    finding.plot = {"Where it goes",
                    "time [s]",
                    "place along y [m]",
                    {curve({"yours", yours}, asked.times), curve(expected, asked.times)}};
  }
  check(finding);
}

}  // namespace judge::verlet
