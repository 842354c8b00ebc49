// SPDX-License-Identifier: MIT-0
// Grades a submission, or those of a class.
#include <cerrno>
#include <cstdio>
#include <system_error>

#include "command_line.h"
#include "grade_command.h"

namespace {

using grade::Command;

void list() {
  for (const grade::Exercise& exercise : grade::exercises()) {
    std::printf("%s\n", exercise.name.c_str());
  }
}

void versions() {
  for (const grade::Exercise& exercise : grade::exercises()) {
    std::printf("%-40s %s\n", exercise.name.c_str(), grade::version(exercise).c_str());
  }
}

int run(const Command& command) {
  switch (command.what) {
    case Command::What::one:
      return grade::grade_and_report(command);
    case Command::What::whole_class:
      return grade::grade_class(command.classroom);
    case Command::What::list:
      list();
      break;
    case Command::What::version:
      versions();
      break;
    case Command::What::nothing:
      break;
  }
  return grade::Exit::graded;
}

/// What the caller can mend, what may mend itself, and the rest.
int exit_code(const std::error_code& error) {
  switch (error.value()) {
    case EACCES:
    case EPERM:
    case ENOENT:
    case ENOTDIR:
    case EEXIST:
    case EISDIR:
    case EROFS:
    case ENAMETOOLONG:
      return grade::Exit::bad_input;
    case EAGAIN:
    case EMFILE:
    case ENFILE:
    case ENOMEM:
    case ENOSPC:
    case EDQUOT:
      return grade::Exit::try_again;
    default:
      return grade::Exit::failed;
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(grade::read_command_line(argc, argv));
  } catch (const grade::Usage& problem) {
    std::fprintf(stderr, "grade: %s\n", problem.what());
    return grade::Exit::bad_input;
  } catch (const std::system_error& problem) {
    std::fprintf(stderr, "grade: %s\n", problem.what());
    return exit_code(problem.code());
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "grade: %s\n", problem.what());
    return grade::Exit::failed;
  }
}
