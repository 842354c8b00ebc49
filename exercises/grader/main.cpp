// SPDX-License-Identifier: MIT-0
// Grades a submission, or those of a class.
#include <cstdio>
#include <system_error>

#include "command_line.h"
#include "exit_codes.h"
#include "grade_command.h"
#include "task.h"

namespace {

using grade::Command;

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
      std::fputs(grade::list_of_exercises(command.listed).c_str(), stdout);
      break;
    case Command::What::run:
      return grade::run_and_print(command);
    case Command::What::version:
      versions();
      break;
    case Command::What::nothing:
      break;
  }
  return grade::Exit::graded;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(grade::read_command_line(argc, argv));
  } catch (const grade::Usage& problem) {
    return grade::refuse(grade::Exit::bad_input, problem.what());
  } catch (const std::system_error& problem) {
    return grade::refuse(grade::exit_code(problem.code()), problem.what());
  } catch (const std::exception& problem) {
    return grade::refuse(grade::Exit::failed, problem.what());
  }
}
