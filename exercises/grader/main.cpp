// SPDX-License-Identifier: MIT-0
// Grades a submission, or those of a class.
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "command_line.h"
#include "exit_codes.h"
#include "grade_command.h"
#include "printable.h"
#include "report/files.h"
#include "task.h"

namespace {

using grade::Command;

void versions() {
  for (const grade::Exercise& exercise : grade::exercises()) {
    std::printf("%-40s %s\n", exercise.name.c_str(), grade::version(exercise).c_str());
  }
}

void list(const std::string& part) {
  const std::string found = grade::list_of_exercises(part);
  if (found.empty())
    throw grade::Usage("no exercise has '" + grade::printable(part, 100) +
                       "' in its name; --list alone names all");
  std::fputs(found.c_str(), stdout);
}

int run(const Command& command) {
  switch (command.what) {
    case Command::What::one:
      return grade::grade_and_report(command);
    case Command::What::whole_class:
      return grade::grade_class(command.classroom);
    case Command::What::course:
      return grade::grade_course(command.course);
    case Command::What::list:
      list(command.listed);
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
    const int code = run(grade::read_command_line(argc, argv));
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
    return grade::refuse(grade::Exit::try_again, "what it had to say could not be written");
  } catch (const grade::Usage& problem) {
    return grade::refuse(grade::Exit::bad_input, problem.what());
  } catch (const grade::NotOwn& problem) {
    return grade::refuse(grade::Exit::bad_input, problem.what());
  } catch (const std::filesystem::filesystem_error& problem) {
    return grade::refuse(grade::exit_code(problem.code()),
                         "'" + grade::printable_name(problem.path1().string()) +
                             "' cannot be used: " + problem.code().message());
  } catch (const std::system_error& problem) {
    return grade::refuse(grade::exit_code(problem.code()), problem.what());
  } catch (const std::exception& problem) {
    return grade::refuse(grade::Exit::failed, problem.what());
  }
}
