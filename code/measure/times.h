// SPDX-License-Identifier: MIT-0
/// @file
/// Times: how they were taken, and the file that keeps them.
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace measure {

/// The times that a quarter, a half and three quarters of the runs stayed below.
struct Quartiles {
  double lower = 0, median = 0, upper = 0;

  bool operator==(const Quartiles&) const = default;
};

/// @param values  at least one, in any order
Quartiles quartiles(std::vector<double> values);

/// Something whose time is taken.
struct Timed {
  std::string name;             ///< such as `shuttle/RK4`
  std::function<double()> run;  ///< runs it once and says how long one step took [s]
};

/// The times of one machine.
struct Times {
  std::string processor;                ///< as the system names it
  std::string clock;                    ///< its clock while it ran
  std::string compiler;                 ///< name, version and flags
  std::string date;                     ///< year, month and day
  int runs = 0;                         ///< of each thing that was timed
  double others = 0;                    ///< processors that other programs kept busy meanwhile
  std::map<std::string, Quartiles> of;  ///< time of a step by name [ns]

  /// Whether other programs took less than a twentieth of a processor.
  bool alone() const;

  /// The time of that name [ns].
  /// @throws std::out_of_range  there is none
  const Quartiles& at(const std::string& name) const;
};

/// Runs all of them in turn, many times over, so that what else the machine does for a while slows
/// none more than the others.
/// @param all  what is timed
/// @param compiler  goes into the result
/// @param turns  how often
Times take_times(const std::vector<Timed>& all, const std::string& compiler, int turns);

/// Writes a file that `read_times` reads; it is whole or not there.
/// @throws std::runtime_error  one line that says which file could not be written
void write_times(const Times& times, const std::filesystem::path& file);

/// @throws std::runtime_error  one line that says what is wrong with the file
Times read_times(const std::filesystem::path& file);

/// Times that the book was written with, as kept in chapters/recorded.
/// @param file  `times.csv`, all that the book times itself, or `libraries.csv`, what tests/peers
///              does
const Times& recorded_times(const char* file = "times.csv");

}  // namespace measure
