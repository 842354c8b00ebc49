// SPDX-License-Identifier: MIT-0
/// @file
/// Times as the clocks of a place show them.
#pragma once
#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace grade {

using Instant = std::chrono::sys_seconds;
using LocalTime = std::chrono::local_seconds;

/// In seconds: one in other units may not be compared with a time of another century.
Instant now();

/// The clocks of a place, by its name in the tz database. `UTC` is known on every machine, all
/// others only where tzdata is installed.
class TimeZone {
 public:
  /// @throws Usage  there is none of this name, or no tzdata
  explicit TimeZone(const std::string& name);

  const std::string& name() const { return name_; }

  /// What the clocks show then.
  LocalTime local(Instant at) const;

  /// When the clocks show this, the earlier first: twice where they are put back, never where they
  /// are put forward.
  std::vector<Instant> instants(LocalTime shown) const;

  /// The last instant of this time; of one that the clocks leap over, the instant that would have
  /// had it, had nobody put them forward.
  Instant latest(LocalTime shown) const;

 private:
  std::chrono::seconds offset(Instant at) const;

  std::string name_, variable_;  ///< the latter as TZ takes it
};

/// `2027-02-08 23:59`, with seconds if there are any.
std::string shown(LocalTime time);

/// `2027-02-08T23:59:30`, with an offset or `Z` behind it if it has one.
struct WrittenTime {
  LocalTime local;
  std::optional<std::chrono::minutes> offset;
};

/// Nothing if it is no date with a time. Parts of a second are left out.
std::optional<WrittenTime> time_from(const std::string& text);

/// `3 days 2 h 5 min`, `1 day 1 min`, `5 min 20 s`, `40 s`: seconds only below an hour.
std::string duration(std::chrono::seconds time);

}  // namespace grade
