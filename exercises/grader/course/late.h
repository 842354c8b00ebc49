// SPDX-License-Identifier: MIT-0
/// @file
/// What being late takes.
#pragma once
#include <chrono>
#include <optional>
#include <string>

#include "course/course.h"

namespace grade {

struct Lateness {
  std::chrono::seconds by{0};  ///< after the end; 0 if it was in time, or within the grace
  long days = 0;               ///< begun
  bool counts = true;          ///< not so late that nothing does
};

/// A day begins where the clocks show what they did at the end, so that a change of the clocks
/// makes no second day.
Lateness lateness(Instant handed_in, Instant due, const std::optional<LateRule>& rule,
                  const TimeZone& zone);

/// The points that are taken of these.
int taken(const Lateness& late, const std::optional<LateRule>& rule, int score);

/// What a student is told: by how much it was late, and what that took. Empty if it was in time.
std::string late_words(const Lateness& late, int taken);

}  // namespace grade
