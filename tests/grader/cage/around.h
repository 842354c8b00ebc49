// SPDX-License-Identifier: MIT-0
/// @file
/// What these tests work with: the kit, a shell, and a look at what is left running.
#pragma once
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>

#include "cage/cage.h"
#include "installed.h"
#include "kit.h"

inline std::string kit_folder() {
  const char* own = std::getenv("KIT");
  return own ? own : grade::installed().kit;
}

inline cage::Kit kit() {
  return grade::kit_in(kit_folder(), kit_folder());
}

/// A program that stands beside this one.
inline std::string beside(const std::string& name) {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path() / name;
}

inline std::vector<std::string> shell(const std::string& script) {
  return {"/bin/sh", "-c", script};
}

inline cage::Limits within(double seconds) {
  cage::Limits limits;
  limits.wall = seconds;
  return limits;
}

/// A number that no other program bears in its command line.
inline std::string mark() {
  static int count = 0;
  return "1000." + std::to_string(::getpid()) + std::to_string(1000 + ++count);
}

/// Whether any process anywhere has this in its command line, this one excepted.
inline bool running(const std::string& mark) {
  for (const auto& process : std::filesystem::directory_iterator("/proc")) {
    if (process.path().filename() == std::to_string(::getpid())) continue;
    std::ifstream file(process.path() / "cmdline");
    std::ostringstream line;
    line << file.rdbuf();  // which reads nothing, and throws nothing, of one that has ended
                           // meanwhile
    if (line.str().find(mark) != std::string::npos) return true;
  }
  return false;
}

class Clock {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// A folder of its own for a test.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "cage-test-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~Folder() {
    std::error_code left;
    std::filesystem::remove_all(path_, left);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

  std::filesystem::path write(const std::string& name, const std::string& content) const {
    std::filesystem::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name, std::ios::binary) << content;
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};
