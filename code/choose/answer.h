// SPDX-License-Identifier: MIT-0
/// @file
/// The answer of `choose`, as text and as JSON.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "choose/contest.h"
#include "choose/reasons.h"

/// The forms of an answer.
enum class Format { text, json };

/// @throws std::invalid_argument  there is none of that name
inline Format format_of(const std::string& name) {
  if (name == "text") return Format::text;
  if (name == "json") return Format::json;
  throw std::invalid_argument("there is no format '" + name + "'; there are text, json");
}

/// The steps of an entry: "4 steps a frame", or "a tolerance of 0.001".
inline std::string steps_per_frame_text(const Entry& entry) {
  const Attempt& last = entry.last;
  return last.substeps ? steps(last.substeps) + " a frame"
                       : "a tolerance of " + format_number(last.tolerance);
}

/// Microseconds, in two digits or all before the point.
inline std::string microseconds(double value) {
  char text[32];
  std::snprintf(text, sizeof text, value < 99.5 ? "%.2g" : "%.0f", value);
  return text;
}

/// Evaluations a second: whole ones, unless there are so few as of planets.
inline std::string evaluations_text(const Entry& entry) {
  char text[32];
  std::snprintf(text, sizeof text, entry.evaluations < 10 ? "%.3g" : "%.0f", entry.evaluations);
  return text;
}

/// Both prices of an entry.
inline std::string prices(const Entry& entry) {
  const bool timed = !std::isnan(entry.microseconds);
  return evaluations_text(entry) + " evaluations a second" +
         (timed ? ", " + microseconds(entry.microseconds) + " us a frame for 1000" : std::string());
}

/// An error in full.
inline std::string error_of(const Entry& entry, const Bounds& bounds) {
  const std::string unit = bounds.reach > 0 ? " m" : "";
  std::string even = "error " + format_number(in_reported_units(entry.last.error, bounds)) + unit;
  if (!is_for_even_frames(entry, bounds)) return even;
  return even +
         ", too much in uneven frames: " + format_number(in_reported_units(entry.uneven, bounds)) +
         unit;
}

/// One entry in full.
inline void print_choice(const Entry& entry, const Bounds& bounds) {
  const std::string function(entry.method->function), header(entry.method->header);
  std::printf("  %s, %s: %s, %s\n  #include \"integrate/%s\"\n\n", function.c_str(),
              steps_per_frame_text(entry).c_str(), prices(entry).c_str(),
              error_of(entry, bounds).c_str(), header.c_str());
}

/// One entry in a line.
inline void print_row(const Entry& entry, const Bounds& bounds, bool keeps_energy) {
  const std::string function(entry.method->function);
  const std::string substeps =
      entry.last.substeps ? std::to_string(entry.last.substeps) : "adaptive";
  const bool timed = !std::isnan(entry.microseconds);
  const std::string mark = is_for_even_frames(entry, bounds) ? "!" : "";
  std::printf(
      "%-30s %11s %9s %9s  %-9s %-10s %-8s %s\n", function.c_str(), substeps.c_str(),
      evaluations_text(entry).c_str(), timed ? microseconds(entry.microseconds).c_str() : "-",
      format_number(in_reported_units(entry.last.error, bounds)).c_str(),
      (format_number(in_reported_units(entry.uneven, bounds)) + mark).c_str(),
      keeps_energy ? format_number(entry.last.energy).c_str() : "-",
      entry.last.substeps ? reason(entry, bounds).c_str() : steps_per_frame_text(entry).c_str());
}

/// Says so where the two prices choose differently.
inline void print_by_time(const Entry& best, const std::vector<Entry>& entries,
                          const Bounds& bounds) {
  const Entry* quickest = cheapest_by_time(entries);
  if (!quickest || quickest == &best || !best.good) return;
  if (quickest->microseconds > 0.95 * best.microseconds) return;
  const std::string function(quickest->method->function);
  std::printf(
      "That counts evaluations. By time, if the acceleration is as short as here, take\n"
      "  %s, %s: %s, %s\n\n",
      function.c_str(), steps_per_frame_text(*quickest).c_str(), prices(*quickest).c_str(),
      error_of(*quickest, bounds).c_str());
}

/// What the column of uneven frames is.
inline void print_uneven(const Bounds& bounds) {
  const std::vector<double>& log = bounds.log.lengths;
  if (log.empty()) {
    std::printf(
        "\nuneven: the error in frames as uneven as 600 that a browser took on one busy machine, "
        "one "
        "in 50 of\n"
        "them late, with the same mean; with a ! where it is more than was asked for. Yours may be "
        "others.\n");
    return;
  }
  const auto [shortest, longest] = std::minmax_element(log.begin(), log.end());
  const bool all = std::size_t(bounds.frames()) >= log.size();
  const std::string stretch = all ? "" : ", the roughest " + std::to_string(bounds.frames());
  std::printf(
      "\nuneven: the error in frames as uneven as the %zu of %s%s, which take %s to %s ms,\n"
      "with the same mean; with a ! where it is more than was asked for.\n",
      log.size(), bounds.log.name.c_str(), stretch.c_str(),
      format_number(1e3 * *shortest, 3).c_str(), format_number(1e3 * *longest, 3).c_str());
}

/// The answer for a person.
inline void print_text(const Contest& found, const Bounds& bounds) {
  const bool exact = !found.exact.empty() && found.exact[0].good;
  const Entry& best = found.methods[0];
  if (exact) {
    std::printf("This scene has an exact step. Take it:\n");
    for (const Entry& entry : found.exact) print_choice(entry, bounds);
  }
  for (const std::string& remark : found.remarks) {
    if (!remark.empty()) std::printf("%s\n\n", remark.c_str());
  }
  const char* said = best.good ? exact ? "If other forces act as well, the cheapest within the "
                                         "bounds is"
                                       : "The cheapest within the bounds:"
                     : exact   ? "If other forces act as well, nothing meets the bounds; the "
                                 "nearest is"
                               : "Nothing meets the bounds. The nearest:";
  std::printf("%s\n", said);
  print_choice(best, bounds);
  print_by_time(best, found.methods, bounds);
  for (const Entry& entry : found.undisturbed) {
    if (!entry.good) continue;
    std::printf("If nothing disturbs the motion, take steps that do not end with the frames:\n");
    print_choice(entry, bounds);
  }
  const bool metres = bounds.reach > 0;
  std::printf("%-30s %11s %9s %9s  %-9s %-10s %-8s %s\n", "", "steps/frame", "evals/s", "us/frame",
              metres ? "error [m]" : "error", metres ? "uneven [m]" : "uneven", "energy",
              "with fewer steps");
  for (const Entry& entry : found.methods) print_row(entry, bounds, found.keeps_energy);
  for (const Entry& entry : found.undisturbed) print_row(entry, bounds, found.keeps_energy);
  const measure::Times& times = measure::recorded_times();
  const bool timed = cheapest_by_time(found.methods) != nullptr;
  if (timed) {
    std::printf("\nus/frame: a thousand such bodies in a loop on %s, %s, %s.",
                times.processor.c_str(), times.compiler.c_str(), times.date.c_str());
  }
  print_uneven(bounds);
}

/// All entries: the exact step, the methods, the best first, and adaptive steps.
inline std::vector<Entry> all_of(const Contest& found) {
  std::vector<Entry> all = found.exact;
  all.insert(all.end(), found.methods.begin(), found.methods.end());
  all.insert(all.end(), found.undisturbed.begin(), found.undisturbed.end());
  return all;
}

/// All entries as a list of objects. What is not known, or not finite, is null.
inline void print_json(const Contest& found) {
  auto entries = nlohmann::ordered_json::array();
  for (const Entry& entry : all_of(found)) {
    const Attempt& last = entry.last;
    const nlohmann::ordered_json none;
    entries.push_back(
        {{"function", entry.method->function},
         {"header", entry.method->header},
         {"good", entry.good},
         {"steps_per_frame", last.substeps ? nlohmann::ordered_json(last.substeps) : none},
         {"tolerance", last.substeps ? none : nlohmann::ordered_json(last.tolerance)},
         {"evaluations_per_second", entry.evaluations},
         {"microseconds_per_frame_for_1000", entry.microseconds},
         {"error", last.error},
         {"error_in_uneven_frames", entry.uneven},
         {"energy_change", found.keeps_energy ? nlohmann::ordered_json(last.energy) : none}});
  }
  std::printf("%s\n", entries.dump(2).c_str());
}

/// Writes the answer to the standard output.
/// @throws std::runtime_error  that can't be written to
inline void print(const Contest& found, const Bounds& bounds, Format format) {
  if (format == Format::text) print_text(found, bounds);
  if (format == Format::json) print_json(found);
  if (std::fflush(stdout) != 0) throw std::runtime_error("can't write the answer");
}
