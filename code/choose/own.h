// SPDX-License-Identifier: MIT-0
/// @file
/// Compiles the contest for a scene of the reader's own, and runs it.
#pragma once
#include <fcntl.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/wait.h>

#include <cctype>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "choose/cost.h"

extern char** environ;

/// The question about a scene of one's own.
struct Question {
  std::string scene;          ///< the header
  std::string hz, seconds;    ///< as numbers
  std::string error, metres;  ///< the error as a share, or in metres; the other is 0
  std::string format, chart;  ///< as in `choose`
};

/// A folder that lasts as long as this.
class OwnFolder {
 public:
  /// @throws std::runtime_error  there is no room for it
  OwnFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "choose-XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("can't make the folder " + name);
    path = name;
  }
  ~OwnFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
  OwnFolder(const OwnFolder&) = delete;
  OwnFolder& operator=(const OwnFolder&) = delete;

  std::filesystem::path path;
};

/// Runs a program and waits for its end.
/// @param command  the program and its arguments
/// @param errors  file for what it writes on stderr; empty: it goes where ours goes
/// @returns  its exit code, or -1
inline int run(const std::vector<std::string>& command, const std::string& errors = "") {
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  if (!errors.empty()) {
    posix_spawn_file_actions_addopen(&actions, 2, errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                     0600);
  }
  pid_t child = 0;
  const int failed =
      posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  int status = 0;
  if (failed || waitpid(child, &status, 0) != child || !WIFEXITED(status)) return -1;
  return WEXITSTATUS(status);
}

/// The first line of a compiler's messages that says what is wrong.
inline std::string first_error(const std::string& file) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (line.find("error:") != line.npos) return line;
  }
  return "the compiler does not say why";
}

/// Compiles a program of this folder for a scene.
/// @param program  its source
/// @param scene  the reader's header
/// @param folder  for the compiler's messages
/// @param more  flags besides those that all are compiled with
/// @param out  the file that it becomes
/// @throws std::invalid_argument  the scene doesn't compile; one line that says why
inline void compile(const std::string& program, const std::string& scene, const OwnFolder& folder,
                    const std::vector<std::string>& more, const std::string& out) {
  std::vector<std::string> command{OWN_COMPILER};
  std::istringstream flags(OWN_FLAGS);
  for (std::string flag; std::getline(flags, flag, '|');) {
    if (!flag.empty()) command.push_back(flag);
  }
  command.push_back("-DSCENE=\"" + std::filesystem::absolute(scene).string() + "\"");
  command.insert(command.end(), more.begin(), more.end());
  // No more than the first error is told.
  command.insert(command.end(),
                 {"-Wfatal-errors", OWN_SOURCES "/" + program, OWN_LIBRARY, "-o", out});
  const std::string errors = folder.path / "errors";
  if (run(command, errors) != 0) {
    throw std::invalid_argument(scene +
                                " doesn't compile as a scene; it has to define Vec, "
                                "acceleration(x, v, t), start_x and start_v: " +
                                first_error(errors));
  }
}

/// The type of a method in code/measure/methods, by its function: `velocity_verlet` is
/// `VelocityVerlet`.
inline std::string type_of(const std::string& function) {
  std::string type;
  bool first = true;
  for (const char letter : function) {
    if (letter != '_') type += first ? char(std::toupper(letter)) : letter;
    first = letter == '_';
  }
  return type;
}

/// Compiles the contest for a scene, runs it, and takes the time of the method that it chose.
/// @returns  the exit code of `choose`
/// @throws std::invalid_argument  one line that says what is wrong with the scene
inline int choose_for_own(const Question& asked) {
  if (!std::filesystem::exists(asked.scene))
    throw std::invalid_argument("there is no file " + asked.scene);
  const OwnFolder folder;
  const std::string contest = folder.path / "contest", winner = folder.path / "winner";
  compile("own_contest.cpp", asked.scene, folder, {"-O1"}, contest);
  const int code = run({contest, asked.hz, asked.seconds, asked.error, asked.metres, asked.format,
                        asked.chart, winner});
  if (code < 0) throw std::runtime_error("the acceleration of " + asked.scene + " crashed");
  std::string function;
  std::ifstream(winner) >> function;
  if (asked.format != "text" || function.empty()) return code;
  const std::string time = folder.path / "time";
  compile("own_time.cpp", asked.scene, folder, {"-O2", "-DONLY=" + type_of(function)}, time);
  std::printf(
      "\nCompiled for this scene alone, a step of %s takes here, of one of %zu bodies [ns]: ",
      function.c_str(), in_a_loop);
  std::fflush(stdout);
  run({time});
  return code;
}
