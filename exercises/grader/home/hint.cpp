// SPDX-License-Identifier: MIT-0
#include "home/hint.h"

#include <cstdio>
#include <map>
#include <sstream>

#include "exit_codes.h"
#include "home/own_command.h"
#include "home/plain_formula.h"
#include "home/state.h"
#include "report/files.h"
#include "report/wrapped.h"

namespace grade {
namespace {

constexpr const char* hints_file = "hints.txt";

using Shown = std::map<std::string, std::size_t>;  // how many, by the exercise's name

Shown shown_before() {
  Shown shown;
  std::istringstream lines(read_state(hints_file));
  std::string name;
  for (std::size_t count; lines >> name >> count;) shown[name] = count;
  return shown;
}

void note_shown(const Shown& shown) {
  std::string text;
  for (const auto& [name, count] : shown) text += name + " " + std::to_string(count) + "\n";
  write_state(hints_file, text);
}

void print_hint(const std::vector<std::string>& all, std::size_t n) {
  const std::string head = std::to_string(n + 1) + " of " + std::to_string(all.size()) + "  ";
  std::printf("%s%s", head.c_str(), wrapped(all[n], head.size()).c_str());
}

}  // namespace

std::vector<std::string> hints(const Exercise& exercise) {
  std::vector<std::string> all;
  std::istringstream lines(read_whole(exercise.folder / "task.md").value_or(""));
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (line == "\\hint") all.emplace_back();
    if (inside && line != "\\endhint") all.back() += (all.back().empty() ? "" : " ") + line;
    inside = line == "\\hint" || (inside && line != "\\endhint");
  }
  for (std::string& hint : all) hint = plain_formulas(hint);
  return all;
}

int show_hint(const Exercise& exercise) {
  const std::vector<std::string> all = hints(exercise);
  if (all.empty()) return refuse(Exit::bad_input, exercise.name + " has no hints");
  Shown shown = shown_before();
  std::size_t& count = shown[exercise.name];
  if (count < all.size()) {
    print_hint(all, count++);
    note_shown(shown);
  } else {
    for (std::size_t n = 0; n < all.size(); ++n) print_hint(all, n);
    std::puts("There are no others.");
  }
  if (count < all.size())
    std::printf("Another: %s\n", own_command({"hint", exercise.task()}).c_str());
  return Exit::graded;
}

}  // namespace grade
