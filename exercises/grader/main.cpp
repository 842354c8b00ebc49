// SPDX-License-Identifier: MIT-0
// Grades a submission, or those of a class.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <system_error>

#include "command_line.h"
#include "exit_codes.h"
#include "grade_command.h"
#include "home/check.h"
#include "home/hint.h"
#include "home/level_own.h"
#include "home/play_own.h"
#include "home/ready.h"
#include "home/right_ways.h"
#include "home/start.h"
#include "home/watch.h"
#include "hosts/write_results.h"
#include "printable.h"
#include "report/classroom.h"
#include "report/files.h"
#include "report/gradescope.h"
#include "task.h"

namespace {

using grade::Command;
using grade::What;

void write(const std::string& bytes) {
  std::fwrite(bytes.data(), 1, bytes.size(), stdout);
}

void versions() {
  for (const grade::Exercise& exercise : grade::exercises()) {
    std::printf("%-40s %s\n", exercise.name.c_str(), grade::version(exercise).c_str());
  }
}

void list(const std::string& part) {
  const std::string found = grade::list_of_exercises(part);
  if (found.empty())
    throw grade::Usage("no exercise has '" + grade::printable(part, 100) +
                       "' in its name; grade list names all");
  std::fputs(found.c_str(), stdout);
}

int run(const Command& command) {
  constexpr What with_code[] = {What::one, What::watch, What::whole_class, What::course,
                                What::run, What::play,  What::level};
  if (std::ranges::find(with_code, command.what) != std::end(with_code)) grade::make_ready();
  switch (command.what) {
    case What::one:
      return grade::grade_and_report(command);
    case What::watch:
      return grade::watch(command);
    case What::whole_class:
      return grade::grade_class(command.classroom);
    case What::course:
      return grade::grade_course(command.course);
    case What::collect:
      return grade::collect_submissions(command.collection);
    case What::hand_back:
      return grade::hand_back(command.handed_back);
    case What::gradescope:
      return grade::write_results(command.reports, command.own, grade::gradescope);
    case What::classroom:
      return grade::write_results(command.reports, command.own, grade::classroom);
    case What::start:
      return grade::start(command.request.exercise, command.own);
    case What::hint:
      return grade::show_hint(command.request.exercise);
    case What::run:
      return grade::run_and_print(command);
    case What::play:
      return grade::play_own(command);
    case What::level:
      return grade::play_level(command);
    case What::ways:
      return grade::show_right_ways(command.request.exercise);
    case What::seal:
      write(grade::sealed_right_ways(command.request.exercise));
      break;
    case What::check:
      return grade::check_machine();
    case What::list:
      if (command.listed == "level") {
        grade::list_level();
        break;
      }
      list(command.listed);
      break;
    case What::version:
      versions();
      break;
    case What::nothing:
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
