// SPDX-License-Identifier: MIT-0
// Runs the judges' tests one after the other, as Catch2 does elsewhere.
#include <string_view>
#include <vector>

#include "judge/attempt.h"
#include "judge/points.h"
#include "judge/session.h"
#include "page/module.h"
#include "page/registered.h"

namespace {

struct Test {
  void (*run)();
  std::string_view name, tags;
};

std::vector<Test>& all() {
  static std::vector<Test> all;
  return all;
}

// The tags are "[2-euler/orbit-drift][2 points]".
std::string_view second_tag(std::string_view tags) {
  return tags.substr(tags.rfind('[') + 1);
}

grade::TestResult described(const Test& test) {
  return {.name = std::string(test.name),
          .points = judge::points_of(second_tag(test.tags)),
          .findings = {}};
}

std::vector<Test> of(const std::string& exercise) {
  std::vector<Test> found;
  for (const Test& test : all())
    if (test.tags.starts_with("[" + exercise + "]")) found.push_back(test);
  return found;
}

}  // namespace

page::Registered::Registered(void (*run)(), const char* name, const char* tags) {
  all().push_back({run, name, tags});
}

void page::end_test() {
  __builtin_trap();
}

std::vector<grade::TestResult> judge::tests_of(const std::string& exercise) {
  std::vector<grade::TestResult> tests;
  for (const Test& test : of(exercise)) tests.push_back(described(test));
  return tests;
}

void judge::run_tests(const std::string& exercise) {
  Session& now = session();
  now.tests.clear();
  now.exercise = exercise;
  for (const Test& test : of(exercise)) {
    now.tests.push_back(described(test));
    now.programs.clear();
    now.given.clear();
    page::tell_so_far();
    const bool came_to_its_end = judge::attempt(test.run);
    grade::TestResult& result = now.tests.back();
    result.ran = !now.stopped();
    result.held = result.ran && came_to_its_end && !result.findings.empty();
  }
}
