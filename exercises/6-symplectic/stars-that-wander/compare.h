// SPDX-License-Identifier: MIT-0
/// @file
/// What the tests say of stars that are not where they should be.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>

#include "judge/session.h"
#include "mistakes.h"

namespace stars {

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

// What feels no pull keeps everything, too: the first kick must be there, to a half at least.
inline void check_kicks(const Stars& start, const Stars& yours, const Stars& right, double h,
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
    finding.diagnoses = recognised(start, yours, right, h);
    judge::check(finding);
  }
}

}  // namespace stars
