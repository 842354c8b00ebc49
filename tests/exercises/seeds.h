// SPDX-License-Identifier: MIT-0
/// @file
/// A way of an exercise under many seeds.
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "grade_submission.h"

namespace ways {

/// How a header is graded: with what seed, and by which of the tests; by all, if that is empty.
using Grade = std::function<grade::Report(const std::filesystem::path& file, std::uint64_t seed,
                                          const std::string& only)>;

/// The ways of an exercise, compiled into one driver and one library.
struct Ways {
  Grade driven, called;
};

/// The seeds that a way was tried under, and whether it was as it should be under the last of them.
struct Seeds {
  int tried = 1;
  bool good = true;
};

/// Tries a way under the seeds from the second on, for some seconds, and whatever seems wrong once
/// more in the driver.
Seeds try_seeds(const Ways& ways, const std::filesystem::path& file, const std::string& only,
                int seeds, const std::function<bool(const grade::Report&)>& as_it_should);

/// The whole text of a file.
std::string read(const std::filesystem::path& path);

}  // namespace ways
