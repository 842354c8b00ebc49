// SPDX-License-Identifier: MIT-0
#include "done.h"

#include <filesystem>
#include <sstream>
#include <system_error>

#include "report/files.h"

namespace grade {
namespace {

std::filesystem::path done_file() {
  return std::filesystem::read_symlink("/proc/self/exe").replace_filename("done.txt");
}

std::string done_names() {
  return read_whole(done_file()).value_or("");
}

}  // namespace

bool is_done(const Exercise& exercise) {
  std::istringstream lines(done_names());
  for (std::string name; std::getline(lines, name);)
    if (name == exercise.name) return true;
  return false;
}

void note_done(const Exercise& exercise) {
  try {
    write_whole(done_file(), done_names() + exercise.name + "\n");
  } catch (const std::system_error&) {
  }
}

}  // namespace grade
