// SPDX-License-Identifier: MIT-0
#include "course/equal.h"

#include <algorithm>
#include <map>
#include <regex>

#include "csv.h"
#include "printable.h"
#include "report/words.h"

namespace grade {
namespace {

using Group = std::vector<std::string>;  ///< of students, in their order

/// The numbers of a text that have so many digits that nobody comes upon them twice.
std::set<std::string> long_numbers(const std::string& text) {
  constexpr std::ptrdiff_t enough = 10;
  static const std::regex number_in(R"(\d+(\.\d+)?(e[-+]?\d+)?)");
  std::set<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), number_in), end; at != end; ++at) {
    const std::string written = at->str();
    const std::string digits = written.substr(0, written.find('e'));
    const std::size_t first = digits.find_first_of("123456789");
    if (first == digits.npos) continue;
    const std::string significant = digits.substr(first, digits.find_last_not_of(".0") + 1 - first);
    if (std::ranges::count_if(significant, [](char c) { return c != '.'; }) >= enough)
      found.insert(written);
  }
  return found;
}

bool is_own(const Finding& finding) {
  const std::set<std::string> given =
      long_numbers(finding.asked + " " + finding.input + " " + finding.expected);
  return std::ranges::any_of(long_numbers(finding.got),
                             [&](const std::string& number) { return !given.contains(number); });
}

std::vector<EqualWork> equal_files(const std::vector<Handed>& all) {
  std::map<std::string, std::vector<const Handed*>> by_hash;
  for (const Handed& one : all)
    if (!one.report.sha256.empty()) by_hash[one.report.sha256].push_back(&one);
  std::vector<EqualWork> found;
  for (const auto& [hash, same] : by_hash) {
    if (same.size() < 2) continue;
    Group students;
    for (const Handed* one : same) students.push_back(one->student);
    found.push_back(
        {same[0]->report.exercise, "file", students, std::string(name(same[0]->report.verdict))});
  }
  return found;
}

/// By the students who answered the same, the tests in which they did.
std::map<Group, std::set<std::string>> equal_numbers(
    const std::vector<Handed>& all, const std::set<std::pair<std::string, std::string>>& common) {
  std::map<std::pair<std::string, std::string>, Group> by_answer;
  for (const Handed& one : all)
    for (const auto& answer : wrong_numbers(one.report))
      if (!common.contains(answer)) by_answer[answer].push_back(one.student);
  std::map<Group, std::set<std::string>> found;
  for (const auto& [answer, students] : by_answer)
    if (students.size() > 1) found[students].insert(answer.first);
  return found;
}

std::string joined(const auto& texts) {
  std::string all;
  for (const std::string& one : texts) all += (all.empty() ? "" : "; ") + one;
  return all;
}

}  // namespace

std::set<std::pair<std::string, std::string>> wrong_numbers(const Report& report) {
  std::set<std::pair<std::string, std::string>> found;
  for (const TestResult& test : report.tests) {
    if (!test.ran || test.held) continue;
    for (const Finding& finding : test.findings)
      if (!finding.held && finding.diagnoses.empty() && is_own(finding))
        found.emplace(test.name, finding.got);
  }
  return found;
}

std::vector<EqualWork> equal_work(std::vector<Handed> all, const std::set<std::string>& starters,
                                  const std::optional<Report>& starter) {
  std::erase_if(all, [&](const Handed& one) { return starters.contains(one.report.sha256); });
  std::vector<EqualWork> found = equal_files(all);
  const auto common =
      starter ? wrong_numbers(*starter) : std::set<std::pair<std::string, std::string>>();
  for (const auto& [students, tests] : equal_numbers(all, common)) {
    const bool known = std::ranges::find(found, students, &EqualWork::students) != found.end();
    if (!known)
      found.push_back({all.front().report.exercise, "wrong numbers", students, joined(tests)});
  }
  return found;
}

std::string equal_csv(const std::vector<EqualWork>& all) {
  std::string text = csv_line({"exercise", "equal", "how many", "students", "where"});
  for (const EqualWork& one : all) {
    text += csv_line({one.exercise, one.what, std::to_string(one.students.size()),
                      joined(one.students), printable(one.where)});
  }
  return text;
}

}  // namespace grade
