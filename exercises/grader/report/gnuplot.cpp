// SPDX-License-Identifier: MIT-0
#include "report/gnuplot.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <memory>

namespace grade {
namespace {

/// A file without a name: gnuplot reads one and writes the other, so neither side waits for a pipe.
using Scratch = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

Scratch scratch() {
  return {std::tmpfile(), &std::fclose};
}

bool run(int input, int output) {
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, input, 0);
  posix_spawn_file_actions_adddup2(&files, output, 1);
  posix_spawn_file_actions_addopen(&files, 2, "/dev/null", O_WRONLY, 0);
  char program[] = "gnuplot", defaults[] = "--default-settings", locale[] = "LC_ALL=C";
  const std::array<char*, 3> arguments{program, defaults, nullptr};
  const std::array<char*, 2> environment{locale, nullptr};
  pid_t child = 0;
  const int problem =
      posix_spawnp(&child, program, &files, nullptr, arguments.data(), environment.data());
  posix_spawn_file_actions_destroy(&files);
  int status = 0;
  return problem == 0 && waitpid(child, &status, 0) == child && WIFEXITED(status) &&
         WEXITSTATUS(status) == 0;
}

std::string content(std::FILE* file) {
  std::string text;
  std::array<char, 4096> piece;
  std::rewind(file);
  for (std::size_t n; (n = std::fread(piece.data(), 1, piece.size(), file)) > 0;) {
    text.append(piece.data(), n);
  }
  return text;
}

}  // namespace

std::optional<std::string> gnuplot(std::string_view script) {
  const Scratch input = scratch(), output = scratch();
  if (!input || !output) return std::nullopt;
  std::fwrite(script.data(), 1, script.size(), input.get());
  std::rewind(input.get());
  if (!run(fileno(input.get()), fileno(output.get()))) return std::nullopt;
  return content(output.get());
}

}  // namespace grade
