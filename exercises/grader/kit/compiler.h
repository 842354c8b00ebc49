// SPDX-License-Identifier: MIT-0
/// @file
/// The compiler of the machine that grades.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace grade {

/// What a kit was made with, and what a cage has to show of it.
struct Compiler {
  std::string path;                    ///< without links
  std::string identity;                ///< of its file: another one has another
  std::vector<std::string> shown;      ///< folders that it needs in its cage
  std::vector<std::string> libraries;  ///< files that a checked program needs in its own
};

/// The g++ of the system, or else the first in the PATH: no cache in front of it, as may be there.
std::optional<std::filesystem::path> find_compiler();

/// The identity of the compiler that lies there now; empty if there is none.
std::string identity_of(const std::filesystem::path& compiler);

/// The folders of its parts, of the headers and the libraries that it looks through, by its own
/// account; and those of the system's programs, with the libraries that they are linked to. No
/// variable of whoever asks has a say, since none has one in the cage. A folder within another is
/// not named again.
/// @throws std::runtime_error if it does not answer
std::vector<std::string> folders_of(const std::string& compiler);

/// The shared libraries of a program that is compiled with these flags.
/// @param folder  where one may be compiled
/// @throws std::runtime_error if it can't be
std::vector<std::string> libraries_of(const std::string& compiler,
                                      const std::vector<std::string>& flags,
                                      const std::filesystem::path& folder);

}  // namespace grade
