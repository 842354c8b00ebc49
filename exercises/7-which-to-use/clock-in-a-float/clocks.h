// SPDX-License-Identifier: MIT-0
/// @file
/// Clocks that go wrong, to hold a student's beside.
#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace clocks {

/// Adds the length of a tick as often as there are ticks.
template <class Real>
double sum(int rate, long ticks) {
  const Real tick = Real(1) / static_cast<Real>(rate);
  Real time = 0;
  for (long n = 0; n < ticks; ++n) time += tick;
  return time;
}

/// Counts ticks that were cut to whole parts of a second.
inline double cut(int rate, long ticks, long parts) {
  return static_cast<double>(parts / rate * ticks) / static_cast<double>(parts);
}

struct Clock {
  std::string says;
  std::function<double(int rate, long ticks)> seconds;
};

inline const std::vector<Clock>& wrong() {
  const auto cut_to = [](long parts) {
    return [=](int rate, long ticks) { return cut(rate, ticks, parts); };
  };
  static const std::vector<Clock> all{
      {"a sum in a float: the larger it is, the more of each tick is rounded away", sum<float>},
      {"a sum in doubles: a tick is rounded, and each addition rounds again, and the sum of so "
       "many ticks adds all of that up",
       sum<double>},
      {"1 / rate was rounded to seven digits, and every tick is wrong by as much: a float?",
       [](int rate, long ticks) {
         return static_cast<double>(ticks) * (1.0f / static_cast<float>(rate));
       }},
      {"each tick is cut to whole milliseconds", cut_to(1000)},
      {"each tick is cut to whole microseconds", cut_to(1000000)},
      {"each tick is cut to whole nanoseconds", cut_to(1000000000)},
      {"it stopped at tick 16 777 216: one more is none in a float",
       [](int rate, long ticks) { return static_cast<double>(std::min(ticks, 1L << 24)) / rate; }},
      {"the fraction of a second is cut off: a division of whole numbers?",
       [](int rate, long ticks) { return static_cast<double>(ticks / rate); }},
      {"one tick behind",
       [](int rate, long ticks) { return static_cast<double>(ticks - 1) / rate; }},
      {"one tick ahead",
       [](int rate, long ticks) { return static_cast<double>(ticks + 1) / rate; }},
  };
  return all;
}

/// Which of them shows this time; empty if none does.
inline std::string recognise(double got, int rate, long ticks) {
  const double right = static_cast<double>(ticks) / rate;
  if (std::abs(got - right) <= 1e-12 * right) return "";
  for (const Clock& clock : wrong()) {
    const double theirs = clock.seconds(rate, ticks);
    if (std::abs(got - theirs) <= 1e-2 * std::abs(theirs - right)) return clock.says;
  }
  const double hours = (right - got) / 3600;
  if (hours > 0.5 && std::abs(hours - std::round(hours)) < 1e-9) {
    return "whole hours are missing: it starts again, and nobody adds them up";
  }
  return "";
}

}  // namespace clocks
