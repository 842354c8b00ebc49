// SPDX-License-Identifier: MIT-0
/// @file
/// What the tests say of stars that are not where they should be.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>

#include "judge/session.h"
#include "stars.h"

namespace stars {

inline double apart(const Stars& a, const Stars& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.at.size(); ++i) {
    const double now = judge::distance(a.at[i], b.at[i]);
    largest = std::isfinite(now) ? std::max(largest, now) : INFINITY;
  }
  return largest;
}

inline double velocities_apart(const Stars& a, const Stars& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.at.size(); ++i) {
    largest = std::max(largest, length(a.at[i].v - b.at[i].v));
  }
  return largest;
}

inline void compare(const Stars& yours, const Stars& expected, double tolerance,
                    grade::Finding& finding) {
  finding.held = apart(yours, expected) <= tolerance;
  finding.tolerance = grade::number(tolerance, 2);
  std::string right, wrong;
  for (std::size_t i = 0; i < expected.at.size(); ++i) {
    const std::string name = "star " + std::to_string(i + 1);
    if (judge::distance(yours.at[i], expected.at[i]) <= tolerance) {
      right += (right.empty() ? "" : ", ") + name;
      continue;
    }
    if (wrong.empty()) {
      finding.expected = name + ": " + judge::describe(expected.at[i]);
      finding.got = name + ": " + judge::describe(yours.at[i]);
      finding.error = grade::number(judge::distance(yours.at[i], expected.at[i]), 3);
    }
    wrong += (wrong.empty() ? "" : ", ") + name;
  }
  if (finding.held) return;
  finding.diagnoses = {"right: " + (right.empty() ? "none" : right) + "; wrong: " + wrong};
  if (!std::isfinite(apart(yours, expected))) {
    finding.diagnoses.push_back(
        "there are numbers that are not finite: is a star pulled by itself?");
  } else if (velocities_apart(yours, expected) <= tolerance) {
    finding.diagnoses.push_back("all velocities are right: with which did the stars move?");
  }
}

inline grade::Finding asked(const std::string& what, const Stars& start, double h) {
  grade::Finding finding;
  finding.asked = what;
  finding.input = describe(start, h);
  return finding;
}

// What feels no pull keeps everything, too: the first kick must be there, to a half at least.
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
    judge::check(finding);
  }
}

}  // namespace stars
