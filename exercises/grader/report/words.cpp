// SPDX-License-Identifier: MIT-0
#include "report/words.h"

#include <algorithm>
#include <cctype>

#include "printable.h"
#include "replace_all.h"
#include "report/shortened.h"

namespace grade {
namespace {

constexpr std::uint64_t public_seed = 1;

/// Text with what belongs to it in brackets, or one of the two.
std::string with_reason(const std::string& text, const std::string& reason) {
  return reason.empty() ? text : text + " (" + reason + ")";
}

bool is_plain(const std::string& file) {
  const auto plain = [](unsigned char c) {
    return std::isalnum(c) || std::string_view("._/+-").find(char(c)) != std::string_view::npos;
  };
  return std::all_of(file.begin(), file.end(), plain);
}

/// Returns whether the tests had begun, and came to no end.
bool has_ended(Verdict verdict) {
  constexpr Verdict before[] = {Verdict::compile_error, Verdict::compile_limit, Verdict::link_error,
                                Verdict::rejected, Verdict::grader_error};
  return !is_judged(verdict) && std::ranges::find(before, verdict) == std::end(before);
}

/// The place as it was called, if a shell can be told so.
Place sayable(const Place& place) {
  const Place unseen{.file = place.file};
  return shell_word(place.grade).empty() ? unseen : place;
}

/// The command that begins the exercise behind this one in the book, beside it.
std::string command_for_next(const std::string& exercise, const Place& place) {
  const std::vector<Exercise> all = exercises();
  auto next = std::ranges::find(all, exercise, &Exercise::name);
  const std::string grade = shell_word(place.grade);
  if (next == all.end() || ++next == all.end()) return grade + " list";
  const std::string beside = shell_word(std::filesystem::path(place.file).parent_path().string());
  return grade + " start " + next->task() + (beside.empty() ? "" : " " + beside);
}

}  // namespace

std::string_view sentence(Verdict verdict) {
  switch (verdict) {
    case Verdict::accepted:
      return "Every test held.";
    case Verdict::partial:
      return "Some tests held, some did not.";
    case Verdict::wrong_answer:
      return "It ran to the end, and no test held.";
    case Verdict::compile_error:
      return "The compiler refused it.";
    case Verdict::compile_limit:
      return "The compiler ran out of time, memory or output.";
    case Verdict::link_error:
      return "It compiles, and yet no program comes of it.";
    case Verdict::rejected:
      return "It was not taken.";
    case Verdict::runtime_error:
      return "It crashed, threw, or asked the system for something forbidden.";
    case Verdict::time_limit:
      return "It did not come back in time.";
    case Verdict::memory_limit:
      return "It wanted more memory than it may have.";
    case Verdict::output_limit:
      return "It printed without end.";
    case Verdict::incomplete:
      return "It ended before it had answered, without an error.";
    case Verdict::protocol_error:
      return "What came back was not an answer.";
    case Verdict::grader_error:
      return "The grader failed, not your code: this is no grade.";
  }
  return "";
}

bool is_graded(const Report& report) {
  return report.verdict != Verdict::grader_error;
}

std::string headline(const Report& report) {
  if (!is_graded(report)) return std::string(name(report.verdict)) + ", no grade";
  return std::string(name(report.verdict)) + ", " + std::to_string(report.score) + " of " +
         std::to_string(report.points) + (report.points == 1 ? " point" : " points");
}

std::string_view outcome(const Report& report, const TestResult& test) {
  const auto ended = std::ranges::find(report.tests, false, &TestResult::ran);
  if (!test.ran)
    return has_ended(report.verdict) && test.name == ended->name ? "ended here" : "not run";
  return test.held ? "held" : "did not hold";
}

bool has_failed(const TestResult& test) {
  return test.ran && !test.held;
}

int earned(const TestResult& test) {
  return test.ran && test.held ? test.points : 0;
}

bool is_size(const std::string& error) {
  const auto starts = [&](const char* word) { return error.starts_with(word); };
  return !error.empty() && (std::isdigit(static_cast<unsigned char>(error[0])) || error[0] == '-' ||
                            starts("inf") || starts("NaN"));
}

std::vector<Line> lines(const Finding& finding) {
  const auto [expected, got] = told_apart(finding.expected, finding.got);
  std::vector<Line> all{{"Asked", finding.asked},
                        {"Input", finding.input},
                        {"Expected", expected},
                        {"Got", got},
                        {is_size(finding.error) ? "Off by" : "Wrong", finding.error},
                        {"Allowed", with_reason(finding.tolerance, finding.tolerance_from)}};
  for (const std::string& diagnosis : finding.diagnoses) all.push_back({"Diagnosis", diagnosis});
  all.push_back({"Hint", finding.hint});
  std::erase_if(all, [](const Line& line) { return line.text.empty(); });
  return all;
}

bool has_plot(const Finding& finding) {
  return !finding.plot.curves.empty();
}

std::vector<std::string> next_commands(const Report& report, const Place& seen) {
  const Place place = sayable(seen);
  if (report.verdict == Verdict::accepted) return {command_for_next(report.exercise, place)};
  const std::string file = shell_word(place.file);
  const std::string own = Exercise{report.exercise, {}}.header();
  std::string command =
      shell_word(place.grade) + " " + report.exercise + " " + (file.empty() ? own : file);
  if (report.seed != public_seed) command += " --seed " + std::to_string(report.seed);
  if (report.no_cage) command += " --sandbox none";
  return {command};
}

std::string shell_word(const std::string& file) {
  if (file.empty() || printable_name(file) != file) return "";
  const std::string path = file[0] == '-' ? "./" + file : file;
  return is_plain(path) ? path : "'" + replace_all(path, "'", "'\\''") + "'";
}

std::string provenance(const Report& report) {
  return "Graded with seed " + std::to_string(report.seed) +
         (report.seed == public_seed ? ", the public one" : "") + ", by grader " + report.version +
         (report.sandbox == cage::Sandbox::none ? ", without a sandbox" : "") + ".";
}

std::string_view name(cage::Sandbox sandbox) {
  return sandbox == cage::Sandbox::bubblewrap ? "bubblewrap" : "none";
}

}  // namespace grade
