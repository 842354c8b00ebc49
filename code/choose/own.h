// SPDX-License-Identifier: MIT-0
/// @file
/// Compiles a scene of the reader's own, and runs the contest on it.
#pragma once
#include <dlfcn.h>
#include <fcntl.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cctype>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "choose/answer.h"
#include "choose/chart.h"
#include "choose/cost.h"
#include "choose/own_contest.h"

extern char** environ;

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

/// Waits for the end of a child.
/// @returns  its exit code, that of a shell if nobody reads what it writes, or -1 if it crashed
inline int exit_code_of(pid_t child) {
  int status = 0;
  if (waitpid(child, &status, 0) != child) return -1;
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGPIPE) return 128 + SIGPIPE;
  if (!WIFEXITED(status)) return -1;
  return WEXITSTATUS(status);
}

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
  return failed ? -1 : exit_code_of(child);
}

/// Does some work where a crash of it does no harm.
/// @param work  returns an exit code, and may throw what ends in one line on stderr
/// @returns  that exit code, 2 after such a line, or -1 after a crash
template <class Work>
int in_a_child(const Work& work) {
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    int code = 2;
    try {
      code = work();
    } catch (const std::exception& problem) {
      std::fprintf(stderr, "choose: %s\n", problem.what());
    }
    std::fflush(nullptr);
    _exit(code);
  }
  return exit_code_of(child);
}

/// What a compiler's messages say is wrong with a scene, in one line.
/// @param messages  the file that they are in
/// @param scene  as the reader called it
inline std::string first_error(const std::string& messages, const std::string& scene) {
  std::ifstream in(messages);
  for (std::string line; std::getline(in, line);) {
    const auto error = line.find("error: ");
    if (error == line.npos) continue;
    if (line.find("static assertion failed") != line.npos)
      return scene + " is no scene: " + line.substr(line.rfind(": ") + 2);
    if (line.starts_with("./") && !scene.starts_with("./")) line = line.substr(2);
    const bool in_ours = line.starts_with(OWN_SOURCES);
    return scene +
           " doesn't compile as a scene; it has to define Vec, acceleration(x, v, t), start_x and "
           "start_v: " +
           (in_ours ? line.substr(error) : line);
  }
  return scene + " doesn't compile, and the compiler " OWN_COMPILER " does not say why";
}

/// Compiles a source of this folder behind a scene.
/// @param source  its name
/// @param scene  the reader's header
/// @param folder  for the compiler's messages
/// @param more  flags besides those that all are compiled with
/// @param out  the file that it becomes
/// @throws std::invalid_argument  the scene doesn't compile; one line that says why
inline void compile(const std::string& source, const std::string& scene, const OwnFolder& folder,
                    const std::vector<std::string>& more, const std::string& out) {
  std::vector<std::string> command{OWN_COMPILER};
  std::istringstream flags(OWN_FLAGS);
  for (std::string flag; std::getline(flags, flag, '|');) {
    if (!flag.empty()) command.push_back(flag);
  }
  // What is precompiled has to come first. No more than the first error is told.
  command.insert(command.end(), {"-include", OWN_PRECOMPILED, "-include", scene, "-Wfatal-errors",
                                 OWN_SOURCES "/" + source});
  command.insert(command.end(), more.begin(), more.end());
  command.insert(command.end(), {"-o", out});
  const std::string messages = folder.path / "messages";
  if (run(command, messages) != 0) throw std::invalid_argument(first_error(messages, scene));
}

/// The reader's scene, from what was compiled of it. It stays loaded.
/// @throws std::runtime_error  it can't be loaded
inline OwnForce load(const std::string& library) {
  void* const loaded = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!loaded) throw std::runtime_error(dlerror());
  return reinterpret_cast<OwnForce (*)()>(dlsym(loaded, "own_force"))();
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

/// Compiles the method that was chosen for the scene alone, takes the time of a step, and prints
/// it.
inline void print_time(const std::string& scene, const std::string& function,
                       const OwnFolder& folder) {
  const std::string time = folder.path / "time";
  compile("own_time.cpp", scene, folder, {"-DMETHOD=" + type_of(function), OWN_LIBRARY}, time);
  std::printf(
      "\nCompiled for this scene alone, a step of %s takes here, of one of %zu bodies [ns]: ",
      function.c_str(), in_a_loop);
  std::fflush(stdout);
  run({time});
}

/// Compiles a scene, runs the contest, prints the answer, and takes the time of the method that it
/// chose.
/// @param scene  the reader's header
/// @param bounds  what is asked for
/// @param asked  what can be asked of such a scene alone
/// @param format  of the answer
/// @param chart  the file for the chart; empty if there shall be none
/// @param quiet  whether nobody is told how far it has got
/// @returns  the exit code of `choose`
/// @throws std::invalid_argument  one line that says what is wrong with the scene
inline int choose_for_own(const std::string& scene, Bounds bounds, const OwnAsked& asked,
                          Format format, const std::string& chart, bool quiet) {
  if (!std::filesystem::exists(scene)) throw std::invalid_argument("there is no file " + scene);
  setenv("LC_ALL", "C", 1);  // the compiler's messages are searched for a word
  const OwnFolder folder;
  const std::string library = folder.path / "scene.so";
  compile("own_shared.cpp", scene, folder, {"-shared"}, library);
  const int code = in_a_child([&] {
    const Contest found = with_progress(
        quiet, [&](const Tell& tell) { return own_contest(load(library), bounds, asked, tell); });
    const std::string name = std::filesystem::path(scene).filename().string();
    if (!chart.empty()) draw_chart(found, bounds, name, chart);
    print(found, bounds, format);
    if (!found.warning.empty()) std::fprintf(stderr, "choose: %s\n", found.warning.c_str());
    if (format == Format::text)
      print_time(scene, std::string(found.methods.front().method->function), folder);
    return is_met(found) ? 0 : 1;
  });
  if (code < 0) throw std::runtime_error("the acceleration of " + scene + " crashed");
  return code;
}
