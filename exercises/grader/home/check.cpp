// SPDX-License-Identifier: MIT-0
#include "home/check.h"

#include <unistd.h>

#include <cstdio>
#include <exception>
#include <string>

#include "exit_codes.h"
#include "grade_submission.h"
#include "home/ready.h"
#include "home/run_own.h"
#include "kit.h"
#include "report/files.h"
#include "report/plot.h"
#include "report/wrapped.h"

namespace grade {
namespace {

void say(const std::string& what, bool good, const std::string& more) {
  constexpr std::size_t width = 12;
  const std::string head =
      what + std::string(width - what.size(), ' ') + (good ? "ok   " : "no   ");
  std::fputs((head + wrapped(more, head.size())).c_str(), stdout);
}

/// Returns whether code can be compiled.
bool check_compiler() {
  try {
    make_ready();
    say("compiler", true, made_with(made_folder())->path);
    return true;
  } catch (const std::exception& problem) {
    say("compiler", false, problem.what());
    return false;
  }
}

cage::Sandbox check_cage() {
  const auto why = unsafe();
  say("cage", !why,
      why ? why->substr(0, why->find(". Your own code")) +
                ". Until then your own code is graded without it, and a class is not."
          : "what is graded can't reach your files");
  return why ? cage::Sandbox::none : cage::Sandbox::bubblewrap;
}

/// Returns whether code that reads beyond an array is told so.
bool finds_misused_memory(cage::Sandbox sandbox) {
  const auto file =
      std::filesystem::temp_directory_path() / ("beyond-" + std::to_string(getpid()) + ".h");
  write_whole(file, "#include <vector>\nint main() { return std::vector<int>(2).data()[2]; }\n");
  const Ran ran = run_own(file, sandbox);
  std::filesystem::remove(file);
  return ran.why.find("in line 2") != std::string::npos;
}

void check_checker(cage::Sandbox sandbox) {
  const bool found = finds_misused_memory(sandbox);
  say("memory", found,
      found ? "reading beyond an array is told with its line"
            : "no line is named where code reads beyond an array: AddressSanitizer does not work "
              "here");
}

void check_pictures() {
  const bool drawn = svg({"", "", "", {{"line", {0, 1}, {0, 1}}}}).has_value();
  say("pictures", drawn,
      drawn ? "drawn by gnuplot"
            : "reports have no plots without gnuplot: sudo apt install gnuplot-nox");
}

}  // namespace

int check_machine() {
  const bool compiles = check_compiler();
  if (compiles) {
    check_checker(check_cage());
  }
  check_pictures();
  return compiles ? Exit::graded : Exit::did_not_run;
}

}  // namespace grade
