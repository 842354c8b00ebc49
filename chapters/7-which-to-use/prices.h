// SPDX-License-Identifier: MIT-0
/// @file
/// What a step of each method costs in time, as it was recorded: names of times, and where they are
/// looked up.
#pragma once
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

#include "loops.h"
#include "measure/method.h"
#include "measure/times.h"

/// What the time of a step of one of so many bodies is called.
/// @param thing  of the level, such as "shuttle", or a layout, such as "packs of float"
/// @param function  of the method
inline std::string step_name(std::string_view thing, std::size_t bodies,
                             std::string_view function) {
  return std::string(thing) + "/" + std::to_string(bodies) + "/" + std::string(function);
}

/// The recorded time of a step of one of so many bodies [ns]; NaN if nobody took it, as of a method
/// that is new.
inline double step_time(std::string_view thing, std::size_t bodies, const measure::Method& method) {
  const auto& times = measure::recorded_times().of;
  const auto time = times.find(step_name(thing, bodies, method.function));
  return time == times.end() ? NAN : time->second.median;
}
