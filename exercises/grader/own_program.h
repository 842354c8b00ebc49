// SPDX-License-Identifier: MIT-0
#pragma once
#include <filesystem>

namespace grade {

/// The file of this program.
inline std::filesystem::path own_program() {
  return std::filesystem::read_symlink("/proc/self/exe");
}

}  // namespace grade
