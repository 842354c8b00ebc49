// SPDX-License-Identifier: MIT-0
// Why nobody could be graded if the solution of 2-euler/orbit-drift were this file: own_solution
// FILE. Prints nothing if it would do; "at home" for FILE if there is none.
#include <cstdio>
#include <filesystem>
#include <string>

#include "grade_submission.h"

namespace fs = std::filesystem;

int main(int, char** arguments) {
  grade::Request request;
  request.exercise = *grade::exercise("2-euler/orbit-drift");
  std::string name = (fs::temp_directory_path() / "own-solution-XXXXXX").string();
  const fs::path folder = ::mkdtemp(name.data());
  for (const char* file : {"harness.h", "starter.h"})
    fs::copy(request.exercise.folder / file, folder);
  if (arguments[1] != std::string("at home")) fs::copy(arguments[1], folder / "solution.h");
  request.exercise.folder = folder;
  const auto obstacle = grade::calibrate(request);
  fs::remove_all(folder);
  if (obstacle) std::printf("%s\n", obstacle->why.c_str());
}
