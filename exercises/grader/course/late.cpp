// SPDX-License-Identifier: MIT-0
#include "course/late.h"

#include <algorithm>

#include "format_values.h"

namespace grade {
namespace {

long days_begun(Instant handed_in, Instant due, const TimeZone& zone) {
  const LocalTime end = zone.local(due);
  // A day has 23 hours to 25, and a file may say that it is of another century.
  long days = std::max(1L, long((handed_in - due) / std::chrono::hours(26)));
  while (handed_in > zone.latest(end + std::chrono::days(days))) ++days;
  return days;
}

}  // namespace

Lateness lateness(Instant handed_in, Instant due, const std::optional<LateRule>& rule,
                  const TimeZone& zone) {
  if (handed_in <= due + (rule ? rule->grace : std::chrono::minutes(0))) return {};
  const long days = days_begun(handed_in, due, zone);
  return {handed_in - due, days, !rule || !rule->days || days <= *rule->days};
}

int taken(const Lateness& late, const std::optional<LateRule>& rule, int score) {
  if (!rule || late.days == 0) return 0;
  if (!late.counts) return score;
  return int(std::min<long>(score, rule->points_a_day * late.days));
}

std::string late_words(const Lateness& late, int taken) {
  if (late.days == 0) return "";
  const std::string by = "Handed in " + duration(late.by) + " after the end";
  if (!late.counts) return by + ", when nothing counted any more.";
  if (taken == 0) return by + "; that takes nothing.";
  return by + ": " + counted(std::size_t(taken), "point") + (taken == 1 ? " is" : " are") +
         " taken, for " + counted(std::size_t(late.days), "day") + " begun.";
}

}  // namespace grade
