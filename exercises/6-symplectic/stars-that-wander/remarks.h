// SPDX-License-Identifier: MIT-0
/// @file
/// Diagnoses of stars that are not where they should be, and what the tests say of them.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "judge/session.h"
#include "scene.h"

namespace stars {

/// Diagnoses of a student's first step.
inline std::vector<std::string> what_is_wrong(const Stars& yours, const Stars& right) {
  const double off = apart(yours, right);
  if (!std::isfinite(off))
    return {"there are numbers that are not finite: is a star pulled by itself?"};
  std::string good, bad;
  for (std::size_t i = 0; i < right.at.size(); ++i) {
    const bool held = judge::distance(yours.at[i], right.at[i]) <= 1e-10;
    (held ? good : bad) += (held ? good : bad).empty() ? "" : ", ";
    (held ? good : bad) += "star " + std::to_string(i + 1);
  }
  if (good.empty()) return {};
  if (bad.empty())
    return {"all stars are off by a share of about " +
            grade::number(off / length(right.at[0].x), 1) +
            ": is something added under the root, or to the mu?"};
  return {"right after the first step: " + good + "; wrong: " + bad};
}

inline void compare(const Stars& yours, const Stars& expected, double tolerance,
                    grade::Finding& finding) {
  finding.held = apart(yours, expected) <= tolerance;
  finding.tolerance = grade::number(tolerance, 2);
  if (finding.held) return;
  std::size_t i = 0;
  while (judge::distance(yours.at[i], expected.at[i]) <= tolerance) ++i;
  const std::string name = "star " + std::to_string(i + 1) + ": ";
  finding.expected = name + judge::describe(expected.at[i]);
  finding.got = name + judge::describe(yours.at[i]);
  finding.error = grade::number(judge::distance(yours.at[i], expected.at[i]), 3);
}

inline grade::Finding asked(const std::string& what, const Stars& start, double h) {
  grade::Finding finding;
  finding.asked = what;
  finding.input = describe(start, h);
  return finding;
}

// Checks that stars are kicked, since what feels no pull keeps everything, too: the first kick must
// be there, to a half at least.
inline void check_kicks(const Stars& start, const Stars& yours, const Stars& right,
                        grade::Finding finding) {
  for (std::size_t i = 0; i < start.at.size(); ++i) {
    const Vec kick = right.at[i].v - start.at[i].v, got = yours.at[i].v - start.at[i].v;
    if (length(got - kick) <= length(kick) / 2) continue;
    finding.held = false;
    finding.expected = "star " + std::to_string(i + 1) + " kicked by " + judge::describe(kick);
    finding.got = "by " + judge::describe(got);
    finding.error = grade::number(length(got - kick), 3);
    finding.tolerance = grade::number(length(kick) / 2, 2);
    finding.tolerance_from = "half the kick, since what feels no pull keeps everything, too";
    finding.hint = "Every star is pulled by every other one, and by the other's mu.";
    finding.diagnoses = what_is_wrong(yours, right);
    judge::check(finding);
  }
}

}  // namespace stars
