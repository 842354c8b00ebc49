// SPDX-License-Identifier: MIT-0
// Proves an exercise's tests: prove 2-euler/orbit-drift [SEEDS | caged]. Its solution and every
// right/*.h score full marks, its starter scores nothing, and every way in wrong, be it a header or
// an edit of the solution, fails the test that its first line names and is told what its line
// `Says:` promises. All of them lie in one driver, which is run without a cage, the right ones
// under one seed, the wrong ones by the test that they are named for; then the right ones and one
// that is wrong go the way of a submission. What the tests ask is within the bounds that harness.h
// names, and all of these are among it, with numbers of every size between. With a number, the
// driver alone is tried, under so many seeds; with `caged`, all go the way of a submission, through
// all tests. Prints one line for each; the exit code is 1 if any is not so.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "grade_submission.h"
#include "judge/session.h"
#include "report/shortened.h"
#include "report/words.h"
#include "ways.h"

namespace {

using grade::Report;
using grade::Verdict;

// How a header is graded: with what seed, and by which of the tests; by all, if that is empty.
using Grade = std::function<Report(const std::filesystem::path& file, std::uint64_t seed,
                                   const std::string& only)>;

// As a submission is: compiled in the cage and run there.
Grade in_the_cage(const grade::Exercise& exercise) {
  return [=](const std::filesystem::path& file, std::uint64_t seed, const std::string&) {
    grade::Request request;
    request.exercise = exercise;
    request.submission = file;
    request.seed = seed;
    request.runs = 1;
    return grade::grade_submission(request);
  };
}

bool say(const Report& report, const std::filesystem::path& file, bool as_it_should,
         const std::string& remark) {
  const std::string name =
      file.parent_path().filename() == report.exercise.substr(report.exercise.find('/') + 1)
          ? file.filename().string()
          : (file.parent_path().filename() / file.filename()).string();
  std::printf("%s  %-34s %-14s %3d/%-3d %s\n", as_it_should ? "ok   " : "WRONG", name.c_str(),
              std::string(grade::name(report.verdict)).c_str(), report.score, report.points,
              remark.c_str());
  if (!as_it_should && !report.why.empty()) std::printf("       %s\n", report.why.c_str());
  return as_it_should;
}

// Which tests it failed, by their place in the list above.
std::string failed(const Report& report) {
  std::string places;
  for (std::size_t n = 0; n < report.tests.size(); ++n) {
    places += report.tests[n].held ? " ." : " " + std::to_string(n + 1);
  }
  return "fails" + places;
}

void print_tests(const std::string& exercise) {
  std::printf("%s\n", exercise.c_str());
  int place = 0;
  for (const grade::TestResult& test : judge::tests_of(exercise)) {
    std::printf("       %d  %s\n", ++place, test.name.c_str());
  }
}

bool is_right(const Grade& grade, const std::filesystem::path& file, int seeds) {
  for (int seed = 1; seed <= seeds; ++seed) {
    const Report report = grade(file, static_cast<std::uint64_t>(seed), "");
    const bool full = report.verdict == Verdict::accepted && report.points > 0;
    if (!full || seed == seeds) {
      return say(report, file, full,
                 full ? std::to_string(seeds) + " seeds"
                      : "seed " + std::to_string(seed) + "; " + failed(report));
    }
  }
  return false;
}

// Whether it has no function of numbers, or says harness::any of each of them.
bool says_that_there_are_none(const grade::Exercise& exercise) {
  std::ifstream file(exercise.folder / "harness.h");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  return text.find("harness::Wanted<") == text.npos || text.find("harness::any") != text.npos;
}

// What a solution's drivers said of the arguments that they were given, see watch.h.
struct Asked {
  std::map<std::string, bool> within;  ///< what is to be asked, and whether it was
  std::set<std::string> outside;       ///< what was asked beyond the bounds

  void read(const std::string& printed) {
    std::istringstream lines(printed);
    for (std::string line; std::getline(lines, line);) {
      std::smatch said;
      if (!std::regex_match(line, said, std::regex("(asked|outside) (\\d+) (.*) (yes|no)")))
        continue;
      const std::string which = "harness.h:" + said.str(2) + ": " + said.str(3);
      if (said.str(1) == "asked") within[which] = within[which] || said.str(4) == "yes";
      if (said.str(1) == "outside") outside.insert(which);
    }
  }
  bool all() const {
    return std::ranges::all_of(within, [](const auto& one) { return one.second; });
  }
};

// Whether each bound and each special value that the exercise's harness.h names was asked, and each
// power of ten between, and nothing beyond. What is drawn is drawn by one seed and not by another,
// so a second and a third are tried where something is missing.
bool asks_all(const Grade& grade, const grade::Exercise& exercise) {
  Asked asked;
  for (std::uint64_t seed = 1; seed == 1 || (seed <= 3 && !asked.all()); ++seed) {
    grade(exercise.folder / "solution.h", seed, "");
    asked.read(judge::session().printed);
  }
  for (const auto& which : asked.outside)
    std::printf("WRONG  %s lies outside of its bounds, and is asked\n", which.c_str());
  for (const auto& [which, was] : asked.within)
    if (!was) std::printf("WRONG  %s is never asked\n", which.c_str());
  const bool says_something = !asked.within.empty() || says_that_there_are_none(exercise);
  if (!says_something)
    std::printf("WRONG  harness.h says of no argument what may be asked, nor harness::any\n");
  return asked.outside.empty() && asked.all() && says_something;
}

bool is_nothing(const Grade& grade, const std::filesystem::path& file) {
  const Report report = grade(file, 1, "");
  const bool ran = std::all_of(report.tests.begin(), report.tests.end(),
                               [](const grade::TestResult& test) { return test.ran; });
  return say(report, file, ran && report.score == 0, ran ? "" : "a test was not run");
}

// What the comment of that name holds, at the top of the header; empty if there is none.
std::string promised(const std::filesystem::path& file, const std::string& name) {
  const std::string mark = "// " + name + ": ";
  std::ifstream header(file);
  for (std::string line; std::getline(header, line) && line.starts_with("// ");) {
    if (line.starts_with(mark)) return line.substr(mark.size());
  }
  return "";
}

// Everything that the student is told about a test.
std::string told(const Report& report, const grade::TestResult& test) {
  std::string all = report.why;
  for (const grade::Finding& finding : test.findings) {
    for (const grade::Line& line : grade::lines(finding)) all += "\n" + line.text;
  }
  return all;
}

// Two lines that look alike teach nobody what is wrong.
bool shows_a_difference(const grade::TestResult& test) {
  for (const grade::Finding& finding : test.findings) {
    const auto [expected, got] = grade::told_apart(finding.expected, finding.got);
    if (!finding.held && !expected.empty() && expected == got) return false;
  }
  return true;
}

// A test that was never run, because the code crashed, is not one that it failed.
bool fails(const Report& report, const std::string& test) {
  const auto named = std::ranges::find(report.tests, test, &grade::TestResult::name);
  return named != report.tests.end() && !named->held &&
         (named->ran || report.verdict != Verdict::partial);
}

// Whether a test tells it these words. What a seed draws may be wrong in several ways at once, of
// which nobody knows which it is; so a second seed and a third are tried, too.
bool is_told(const Grade& grade, const std::filesystem::path& file, const Report& first,
             const std::string& test, const std::string& words) {
  const auto says = [&](const Report& report) {
    const auto named = std::ranges::find(report.tests, test, &grade::TestResult::name);
    return told(report, *named).find(words) != std::string::npos;
  };
  return says(first) || says(grade(file, 2, test)) || says(grade(file, 3, test));
}

// The first seed under which it passes its test after all; none if it never does. What is slow is
// tried for some seconds, and what takes too long under the first seed not again.
std::optional<int> lucky(const Grade& grade, const std::filesystem::path& file, const Report& first,
                         const std::string& test, int seeds) {
  if (first.verdict == Verdict::time_limit) return std::nullopt;
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::seconds(3);
  judge::session().diagnoses = false;
  std::optional<int> lucky;
  for (int seed = 2; seed <= seeds && Clock::now() < end; ++seed)
    if (!fails(grade(file, static_cast<std::uint64_t>(seed), test), test)) {
      lucky = seed;
      break;
    }
  judge::session().diagnoses = true;
  return lucky;
}

bool is_caught(const Grade& grade, const std::filesystem::path& file, int seeds) {
  const std::string name = promised(file, "Fails"), words = promised(file, "Says");
  const Report report = grade(file, 1, name);
  const auto named = std::ranges::find(report.tests, name, &grade::TestResult::name);
  if (name.empty()) return say(report, file, false, "its first line is not \"// Fails: TEST\"");
  if (named == report.tests.end())
    return say(report, file, false, "there is no test \"" + name + "\"");
  if (report.verdict == Verdict::grader_error) return say(report, file, false, "was not judged");
  const bool caught = fails(report, name);
  if (words.empty())
    return say(report, file, false,
               "has no line \"// Says: WORDS\"; is told:" + told(report, *named));
  if (caught && !is_told(grade, file, report, name, words))
    return say(report, file, false, "is not told \"" + words + "\" but:" + told(report, *named));
  if (caught && !shows_a_difference(*named))
    return say(report, file, false, "what is expected and what came look alike");
  if (const auto seed = lucky(grade, file, report, name, seeds))
    return say(report, file, false, "passes under seed " + std::to_string(*seed) + ": " + name);
  return say(report, file, caught && report.score < report.points,
             (caught ? "fails: " : "passed: ") + name);
}

// The header that the build made of an edit of the solution.
std::filesystem::path applied(const grade::Exercise& exercise, const std::filesystem::path& edit) {
  const auto made =
      std::filesystem::path(EDITED) / exercise.name / "wrong" / edit.stem().concat(".h");
  const auto newest =
      std::max(last_write_time(edit), last_write_time(exercise.folder / "solution.h"));
  if (exists(made) && last_write_time(made) >= newest) return made;
  throw std::runtime_error(edit.string() + " was not applied; cmake --build build --target prove");
}

// By their names, with headers in place of edits.
std::vector<std::filesystem::path> headers(const grade::Exercise& exercise,
                                           const std::string& folder) {
  std::vector<std::filesystem::path> found;
  for (const auto& entry : std::filesystem::directory_iterator(exercise.folder / folder)) {
    const bool is_edit = entry.path().extension() == ".txt";
    found.push_back(is_edit ? applied(exercise, entry.path()) : entry.path());
  }
  std::sort(found.begin(), found.end(),
            [](const auto& one, const auto& other) { return one.filename() < other.filename(); });
  return found;
}

bool are_enough(const std::string& what, std::size_t count, std::size_t least) {
  if (count >= least) return true;
  std::printf("WRONG  %zu %s, and there should be at least %zu\n", count, what.c_str(), least);
  return false;
}

bool prove(const Grade& grade, const grade::Exercise& exercise, int seeds,
           const std::vector<std::filesystem::path>& right,
           const std::vector<std::filesystem::path>& wrong) {
  bool good = is_right(grade, exercise.folder / "solution.h", seeds);
  for (const auto& file : right) good = is_right(grade, file, seeds) && good;
  good = is_nothing(grade, exercise.folder / "starter.h") && good;
  for (const auto& file : wrong) good = is_caught(grade, file, seeds) && good;
  return good;
}

// Which of them go through the cage: none, the right ones and one that is wrong, or all.
enum class Caged { none, few, all };

struct Trial {
  int seeds = 1;  ///< for what is in the driver; with none, only the cage is tried
  Caged caged = Caged::few;
};

int prove(const grade::Exercise& exercise, const Trial& trial) {
  print_tests(exercise.name);
  const auto right = headers(exercise, "right");
  auto wrong = headers(exercise, "wrong");
  bool good = are_enough("right ways", right.size(), 2);
  good = are_enough("wrong ways", wrong.size(), 6) && good;
  if (trial.seeds > 0) {
    const ways::Driver driver(exercise, std::filesystem::path(EDITED) / exercise.name / "ways");
    const Grade alone = [&](const auto& file, std::uint64_t seed, const std::string& only) {
      return driver.grade(file, seed, {}, only);
    };
    good = asks_all(alone, exercise) && good;
    good = prove(alone, exercise, trial.seeds, right, wrong) && good;
  }
  if (trial.caged == Caged::none) return good ? 0 : 1;
  if (trial.caged == Caged::few) wrong.resize(std::min<std::size_t>(wrong.size(), 1));
  std::printf("       in the cage\n");
  good = prove(in_the_cage(exercise), exercise, 1, right, wrong) && good;
  return good ? 0 : 1;
}

// What the second argument asks for.
std::optional<Trial> trial(const std::string& word) {
  if (word.empty()) return Trial{};
  if (word == "caged") return Trial{0, Caged::all};
  const int seeds = std::atoi(word.c_str());
  if (seeds < 1) return std::nullopt;
  return Trial{seeds, Caged::none};
}

}  // namespace

int main(int count, char** arguments) {
  const auto exercise = count > 1 ? grade::exercise(arguments[1]) : std::nullopt;
  const auto asked = trial(count > 2 ? arguments[2] : "");
  if (!exercise || !asked || count > 3) {
    std::fprintf(stderr,
                 "prove: name one exercise, such as 2-euler/orbit-drift, and perhaps behind it how "
                 "many seeds, or the word caged\n");
    return 2;
  }
  try {
    return prove(*exercise, *asked);
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "prove: %s\n", problem.what());
    return 1;
  }
}
