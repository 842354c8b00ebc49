// SPDX-License-Identifier: MIT-0
#include "home/own_command.h"

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <system_error>

#include "own_program.h"
#include "report/words.h"

namespace grade {
namespace {

/// Returns whether a shell that is told the name alone finds this very file.
bool is_found_by_name(const std::filesystem::path& program) {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const auto found = std::filesystem::path(folder) / program.filename();
    std::error_code none;
    if (!folder.empty() && std::filesystem::exists(found, none))
      return std::filesystem::equivalent(found, program, none);
  }
  return false;
}

}  // namespace

std::string own_name() {
  const auto program = own_program();
  if (is_found_by_name(program)) return program.filename().string();
  const auto from_here = std::filesystem::proximate(program);
  return (from_here.has_parent_path() ? from_here : "." / from_here).string();
}

std::string own_command(std::initializer_list<std::string> words) {
  std::string command = shell_word(own_name());
  for (const std::string& word : words) command += " " + shell_word(word);
  return command;
}

}  // namespace grade
