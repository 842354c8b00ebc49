// SPDX-License-Identifier: MIT-0
/// @file
/// The answers that lie in a folder.
#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

#include "exercise.h"

namespace grade {

/// A header that has an exercise's name, as it was last saved.
struct Answer {
  Exercise exercise;
  std::filesystem::path file;
  std::filesystem::file_time_type saved;
  std::uintmax_t size = 0;

  bool operator==(const Answer& other) const {
    return file == other.file && saved == other.saved && size == other.size;
  }
};

/// Those in this folder itself and in its folders of chapters, the one that was saved last first.
std::vector<Answer> answers(const std::filesystem::path& folder);

}  // namespace grade
