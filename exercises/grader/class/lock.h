// SPDX-License-Identifier: MIT-0
/// @file
/// One grader at a time in a folder of results.
#pragma once
#include <filesystem>

#include "cage/process.h"

namespace grade {

/// Holds a folder for as long as it lives. Graders of parts may share it, one of the whole may not.
class Lock {
 public:
  /// The file that is held. It stays, and shows that a grader has been there.
  static std::filesystem::path file_in(const std::filesystem::path& results) {
    return results / ".lock";
  }

  /// Makes the folder.
  /// @throws std::system_error  it can't be written to
  /// @throws NotOwn  a link or a pipe stands in the place of the file
  Lock(const std::filesystem::path& results, bool shared);

  /// Takes away a folder that it made and that nobody wrote to.
  ~Lock();
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;

  /// Returns whether no other grader had it.
  bool held() const { return held_; }

 private:
  std::filesystem::path file_;
  bool made_;
  cage::File open_;
  bool held_ = false;
};

}  // namespace grade
