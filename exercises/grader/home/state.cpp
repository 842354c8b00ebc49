// SPDX-License-Identifier: MIT-0
#include "home/state.h"

#include <unistd.h>

#include <cstdlib>
#include <system_error>

#include "own_program.h"
#include "report/files.h"

namespace grade {
namespace {

std::filesystem::path state_of_user() {
  const auto set = [](const char* name) {
    const char* const value = std::getenv(name);
    return std::filesystem::path(value ? value : "");
  };
  const std::filesystem::path own = set("XDG_STATE_HOME");
  const auto above = own.is_absolute() ? own : set("HOME") / ".local/state";
  return above.is_absolute() ? above / "one-step-at-a-time" : std::filesystem::path();
}

}  // namespace

std::filesystem::path state_file(const std::string& name) {
  const auto beside = own_program().parent_path();
  if (access(beside.c_str(), W_OK) == 0) return beside / name;
  const std::filesystem::path user = state_of_user();
  return (user.empty() ? beside : user) / name;
}

std::string read_state(const std::string& name) {
  return read_whole(state_file(name)).value_or("");
}

void write_state(const std::string& name, const std::string& text) {
  const std::filesystem::path file = state_file(name);
  try {
    std::filesystem::create_directories(file.parent_path());
    write_whole(file, text);
  } catch (const std::system_error&) {
  }
}

}  // namespace grade
