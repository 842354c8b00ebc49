// SPDX-License-Identifier: MIT-0
// Proves an exercise's tests: prove 2-euler/orbit-drift [SEEDS | caged]. Its solution and every
// right/*.h score full marks, its starter scores nothing, and every way in wrong, be it a header or
// an edit of the solution, fails the test that its first line names and is told what its line
// `Says:` promises. All of them lie in one driver, which is run without a cage, the right ones
// under one seed, the wrong ones by the test that they are named for; then the solution and one
// that is wrong go the way of a submission. What the tests ask is within the bounds that harness.h
// names, and all of these are among it, with numbers of every size between. With a number, all are
// tried under so many seeds, without a cage; with `caged`, the other right ways, the starter and
// the wrong ways that end otherwise than by an answer go the way of a submission. Prints one line
// for each; the exit code is 1 if any is not so.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "asked.h"
#include "grade_submission.h"
#include "judge/session.h"
#include "report/shortened.h"
#include "report/words.h"
#include "seeds.h"
#include "ways.h"

namespace {

using grade::Report;
using grade::Verdict;
using ways::asks_all;
using ways::Grade;
using ways::Seeds;
using ways::Ways;

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

bool has_full_marks(const Report& report) {
  return report.verdict == Verdict::accepted && report.points > 0;
}

bool is_right(const Ways& ways, const std::filesystem::path& file, int seeds) {
  const Report first = ways.driven(file, 1, "");
  if (!has_full_marks(first)) return say(first, file, false, failed(first));
  const Seeds tried = try_seeds(ways, file, "", seeds, has_full_marks);
  const std::string count = std::to_string(tried.tried);
  if (tried.good) return say(first, file, true, count + " seeds");
  const Report wrong = ways.driven(file, static_cast<std::uint64_t>(tried.tried), "");
  return say(wrong, file, false, "seed " + count + "; " + failed(wrong));
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

bool is_caught(const Ways& ways, const std::filesystem::path& file, int seeds) {
  const std::string name = promised(file, "Fails"), words = promised(file, "Says");
  const Report report = ways.driven(file, 1, name);
  const auto named = std::ranges::find(report.tests, name, &grade::TestResult::name);
  if (name.empty()) return say(report, file, false, "its first line is not \"// Fails: TEST\"");
  if (named == report.tests.end())
    return say(report, file, false, "there is no test \"" + name + "\"");
  if (report.verdict == Verdict::grader_error) return say(report, file, false, "was not judged");
  const bool caught = fails(report, name);
  if (report.verdict == Verdict::runtime_error && promised(file, "Known").empty())
    return say(report, file, false,
               "is stopped, and has no line \"// Known: no, WHY\": it would be tried unchecked");
  if (words.empty())
    return say(report, file, false,
               "has no line \"// Says: WORDS\"; is told:" + told(report, *named));
  if (caught && !is_told(ways.driven, file, report, name, words))
    return say(report, file, false, "is not told \"" + words + "\" but:" + told(report, *named));
  if (caught && !shows_a_difference(*named))
    return say(report, file, false, "what is expected and what came look alike");
  // What takes too long under the first seed is not tried again.
  const bool slow = report.verdict == Verdict::time_limit;
  const Seeds tried = try_seeds(ways, file, name, slow ? 1 : seeds,
                                [&](const Report& other) { return fails(other, name); });
  const std::string count = std::to_string(tried.tried);
  if (!tried.good) return say(report, file, false, "passes under seed " + count + ": " + name);
  return say(report, file, caught && report.score < report.points,
             (caught ? "fails: " : "passed: ") + name +
                 (tried.tried < seeds ? " (under " + count + " seeds)" : ""));
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

bool prove(const Ways& compiled, const grade::Exercise& exercise, int seeds,
           const std::vector<std::filesystem::path>& right,
           const std::vector<std::filesystem::path>& wrong) {
  bool good = is_right(compiled, exercise.folder / "solution.h", seeds);
  for (const auto& file : right) good = is_right(compiled, file, seeds) && good;
  good = is_nothing(compiled.driven, exercise.folder / "starter.h") && good;
  for (const auto& file : wrong) good = is_caught(compiled, file, seeds) && good;
  return good;
}

// Whether it crashes, is stopped or takes too much in the test that it is named for.
bool ends_otherwise(const Grade& grade, const std::filesystem::path& file) {
  const Verdict verdict = grade(file, 1, promised(file, "Fails")).verdict;
  return verdict != Verdict::wrong_answer && verdict != Verdict::partial;
}

// Which ways go the way of a submission.
enum class Caged {
  none,
  few,   ///< the solution, and one that is wrong
  most,  ///< the other right ones, the starter, and the wrong ones that end otherwise
};

struct Trial {
  int seeds = 1;  ///< with none, only the cage is tried
  Caged caged = Caged::few;
};

// `marked` grades what is compiled, and says of no mistake which it is.
bool prove_caged(const Grade& marked, const grade::Exercise& exercise, Caged which,
                 const std::vector<std::filesystem::path>& right,
                 const std::vector<std::filesystem::path>& wrong) {
  std::printf("       in the cage\n");
  const Ways caged = {in_the_cage(exercise), {}};
  if (which == Caged::few)
    return is_right(caged, exercise.folder / "solution.h", 1) && is_caught(caged, wrong.front(), 1);
  bool good = is_nothing(caged.driven, exercise.folder / "starter.h");
  for (const auto& file : right) good = is_right(caged, file, 1) && good;
  for (const auto& file : wrong)
    if (ends_otherwise(marked, file)) good = is_caught(caged, file, 1) && good;
  return good;
}

bool prove(const grade::Exercise& exercise, const Trial& trial) {
  print_tests(exercise.name);
  const auto right = headers(exercise, "right"), wrong = headers(exercise, "wrong");
  if (!are_enough("right ways", right.size(), 2) || !are_enough("wrong ways", wrong.size(), 6))
    return false;

  const auto made = std::filesystem::path(EDITED) / exercise.name;
  const ways::Driver driver(exercise, made / "ways");
  const ways::Library library(exercise, made / "ways.so");
  const Ways compiled = {[&](const auto& file, std::uint64_t seed, const std::string& only) {
                           return driver.grade(file, seed, {}, only);
                         },
                         [&](const auto& file, std::uint64_t seed, const std::string& only) {
                           return library.grade(file, seed, only);
                         }};
  bool good = true;
  if (trial.seeds > 0) {
    good = asks_all(compiled.driven, exercise);
    good = prove(compiled, exercise, trial.seeds, right, wrong) && good;
  }
  if (trial.caged == Caged::none) return good;
  const auto marked = [&](const auto& file, std::uint64_t seed, const std::string& only) {
    return driver.grade(file, seed, {}, only, false);
  };
  return prove_caged(marked, exercise, trial.caged, right, wrong) && good;
}

// What the second argument asks for.
std::optional<Trial> trial(const std::string& word) {
  if (word.empty()) return Trial{};
  if (word == "caged") return Trial{0, Caged::most};
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
    return prove(*exercise, *asked) ? 0 : 1;
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "prove: %s\n", problem.what());
    return 1;
  }
}
