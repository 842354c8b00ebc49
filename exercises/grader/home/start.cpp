// SPDX-License-Identifier: MIT-0
#include "home/start.h"

#include <cstdio>

#include "exit_codes.h"
#include "home/own_command.h"
#include "installed.h"
#include "printable.h"
#include "report/files.h"
#include "report/wrapped.h"
#include "task.h"

namespace grade {
namespace {

constexpr const char* flags_name = "compile_flags.txt";

bool is_known_to_editors(const std::filesystem::path& folder) {
  for (auto above = std::filesystem::absolute(folder); above.has_relative_path();
       above = above.parent_path()) {
    if (std::filesystem::exists(above / flags_name)) return true;
  }
  return false;
}

/// Where given.h is, and that a header is C++: for clangd, and for Visual Studio Code.
void tell_editors(const std::filesystem::path& folder) {
  if (is_known_to_editors(folder)) return;
  const auto given = std::filesystem::proximate(
      std::filesystem::absolute(installed().exercises) / "grader/harness", folder);
  write_whole(folder / flags_name, "-xc++\n-std=c++20\n-I" + given.string() + "\n");
  const auto code = folder / ".vscode";
  if (std::filesystem::exists(code)) return;
  std::filesystem::create_directory(code);
  write_whole(code / "settings.json", R"({"files.associations": {"*.h": "cpp"}})"
                                      "\n");
  write_whole(code / "c_cpp_properties.json",
              R"({"configurations": [{"name": "Linux", "compilerPath": "/usr/bin/g++", )"
              R"("cppStandard": "c++20", "includePath": ["${workspaceFolder}/)" +
                  given.string() + "\"]}], \"version\": 4}\n");
}

/// The exercise on its page of the book, as students have it or the build makes it; empty if it is
/// in neither place.
std::string page_of(const Exercise& exercise) {
  const std::filesystem::path project = std::filesystem::path(installed().exercises) / "..";
  for (const char* book : {"book", "build/book"}) {
    const auto page = (project / book / (exercise.chapter() + ".html")).lexically_normal();
    if (std::filesystem::exists(page))
      return std::filesystem::proximate(page).string() + "#exercise-" + exercise.task();
  }
  return "";
}

}  // namespace

int start(const Exercise& exercise, const std::filesystem::path& folder) {
  const auto there = folder.empty() ? std::filesystem::path(".") : folder;
  const auto header = (there / exercise.header()).lexically_normal();
  if (std::filesystem::exists(std::filesystem::symlink_status(header)))
    return refuse(Exit::bad_input, "'" + printable_name(header.string()) +
                                       "' is there already, and stays as it is; " +
                                       own_command({header.string()}) + " grades it");
  const auto starter = read_whole(exercise.folder / "starter.h");
  if (!starter)
    return refuse(Exit::failed, "there is no " + (exercise.folder / "starter.h").string());
  std::filesystem::create_directories(there);
  write_whole(header, *starter);
  tell_editors(there);
  const Task about = task(exercise);
  const std::string page = page_of(exercise);
  std::printf("%s: %s, level %s, %s min\n%s\n%s%s\nWrite your code into %s, and call\n  %s\n",
              exercise.name.c_str(), about.title.c_str(), about.difficulty.c_str(),
              about.minutes.c_str(), wrapped(about.goal, 0).c_str(),
              page.empty() ? "" : "The task: ", page.c_str(),
              printable_name(header.string()).c_str(), own_command({header.string()}).c_str());
  return Exit::graded;
}

}  // namespace grade
