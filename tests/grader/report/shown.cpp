// SPDX-License-Identifier: MIT-0
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <sstream>

#include "report/feedback.h"
#include "report/terminal.h"
#include "report/words.h"
#include "sample.h"

using namespace grade;

namespace {

void check_harmless(const std::string& text) {
  CHECK_FALSE(has(text, "##["));
  CHECK_FALSE(has(text, "\n::"));
  CHECK_FALSE(has(text, "\x1b"));
  CHECK_FALSE(has(text, "\a"));
  CHECK_FALSE(has(text, "\xff"));
  CHECK_FALSE(has(text, "\xe2\x80\xae"));
}

/// The text without its blocks of code.
std::string without_code(const std::string& markdown) {
  std::istringstream lines(markdown);
  std::string fence, result;
  for (std::string line; std::getline(lines, line);) {
    if (fence.empty() && line.starts_with("```")) {
      fence = line.substr(0, line.find_first_not_of('`'));
    } else if (line == fence) {
      fence.clear();
    } else if (fence.empty()) {
      result += line + "\n";
    }
  }
  CHECK(fence.empty());
  return result;
}

}  // namespace

TEST_CASE("feedback says of a failed test all that was found") {
  const std::string text = feedback(sample());
  CHECK(text.starts_with("# 2-euler/orbit-drift: PARTIAL, 3 of 10 points\n"));
  const Finding finding = failed_finding();
  for (const std::string& part :
       {finding.asked, finding.input, finding.expected, finding.got, finding.error,
        finding.tolerance, finding.tolerance_from, finding.hint, finding.diagnoses[0]}) {
    CAPTURE(part);
    CHECK(has(text, part));
    CHECK(has(terminal(sample(), false), part.substr(0, 20)));
  }
  CHECK(has(text, "| five steps are Euler's | 0 of 4 | did not hold |"));
  CHECK(has(text, "| not reached | 0 of 3 | not run |"));
  CHECK(has(text, "```text\nmy_euler.h:3:7: warning"));
  CHECK(has(text, "Not looked at: notes.txt."));
  CHECK(has(text, "grade 2-euler/orbit-drift orbit-drift.h --seed 18446744073709551615\n"));
}

TEST_CASE("feedback shows a picture, or says why there is none") {
  Report report = sample();
  CHECK(has(feedback(report), "No picture"));
  CHECK(has(terminal(report, false), "Picture    drawn by --out FOLDER"));
  report.tests[1].findings[0].plot.file = "plots/test-2.svg";
  CHECK(has(feedback(report), "![Five steps](plots/test-2.svg)"));
  CHECK(has(terminal(report, false), "Picture    plots/test-2.svg"));
  CHECK_FALSE(has(feedback(report), "No picture"));
  report.tests[1].findings[0].plot = {};
  CHECK_FALSE(has(feedback(report), "icture"));
}

TEST_CASE("a student's text does nothing in the feedback") {
  const std::string text = feedback(hostile_sample());
  check_harmless(text);
  const std::string prose = without_code(text);
  for (const char* part : {"<script", "![x]", "`` ```", "**bold**", "@teacher", "://"}) {
    CAPTURE(part);
    CHECK_FALSE(has(prose, part));
  }
  CHECK(has(text, "grade 2-euler/orbit-drift orbit-drift.h "));
}

TEST_CASE("a student's text does nothing in a line of the feedback") {
  Report report = hostile_sample();
  std::string line = hostile;
  std::ranges::replace(line, '\n', ' ');
  report.why = report.tests[1].findings[0].got = report.tests[1].findings[0].diagnoses[0] = line;
  report.warnings.clear();
  const std::string text = feedback(report);
  check_harmless(text);
  for (const char* part : {"<script", "![x]", "`` ```", "**bold**", "@teacher", "://"}) {
    CAPTURE(part);
    CHECK_FALSE(has(text, part));
  }
}

TEST_CASE("a terminal of 80 columns shows the whole report") {
  Report report = sample();
  report.tests[1].findings[0].input = std::string(30, 'x') + " " + std::string(60, 'y');
  for (int n = 0; n < 99; ++n) report.tests[1].name += " of " + std::to_string(n);
  std::istringstream lines(terminal(report, false));
  for (std::string line; std::getline(lines, line);) {
    CAPTURE(line);
    // A command stays in one piece, to be pasted.
    if (!line.starts_with("Next: ")) CHECK(line.size() <= 80);
  }
}

TEST_CASE("a terminal shows the first test that failed in full, and of the others a line") {
  Report report = sample();
  TestResult second = report.tests[1];
  second.name = "another test";
  second.findings[0].diagnoses = {"this is Heun's method", "and no other"};
  second.findings[0].hint = "Look again.";
  report.tests.push_back(second);
  const std::string text = terminal(report, false);
  CHECK(has(text, "  another test: this is Heun's method\n"));
  CHECK_FALSE(has(text, "Look again."));
  CHECK(has(text, "--all"));
  CHECK(has(terminal(report, false, true), "Look again."));
  CHECK_FALSE(has(terminal(report, false, true), "--all"));
}

TEST_CASE("a terminal shows numbers to six digits, and feedback all of them") {
  Report report = sample();
  report.tests[1].findings[0].input =
      "h = 0.11537892918036234, t = 2, n = 1234567, e = 1.2345678e-11";
  CHECK(has(terminal(report, false), "h = 0.115379, t = 2, n = 1234567, e = 1.23457e-11"));
  CHECK(has(feedback(report), "h = 0.11537892918036234"));
}

TEST_CASE("full marks lead to the next exercise of the book") {
  Report report = sample();
  report.verdict = Verdict::accepted;
  report.exercise = exercises().front().name;
  const Exercise next = exercises()[1];
  const std::vector<std::string> starts{"build/exercises/grade start " + next.task()};
  CHECK(next_commands(report) == starts);
  CHECK(next_commands(report, {.file = "a.h"}) == starts);
  // It lies beside the last one.
  CHECK(next_commands(report, {.file = "my work/a.h"}) ==
        std::vector<std::string>{starts.front() + " 'my work'"});
  report.exercise = exercises().back().name;
  CHECK(next_commands(report) == std::vector<std::string>{"build/exercises/grade list"});
}

TEST_CASE("where no cage can be had, the next command does without") {
  Report report = sample();
  report.verdict = Verdict::grader_error;
  CHECK_FALSE(has(next_commands(report).front(), "--sandbox"));
  report.no_cage = true;
  CHECK(next_commands(report).front().ends_with(" --sandbox none"));
}

TEST_CASE("a command names the file and the grader as they were called") {
  const Report report = sample();
  const auto command = [&](const std::string& file, Place place = {}) {
    place.file = file;
    return next_commands(report, place).front();
  };
  const auto names = [&](const std::string& file, const std::string& word) {
    return command(file).starts_with("build/exercises/grade 2-euler/orbit-drift " + word + " ");
  };
  CHECK(names("t/my drift.h", "'t/my drift.h'"));
  CHECK(names("a;b.h", "'a;b.h'"));
  CHECK(names("L\xc3\xb6sung.h", "'L\xc3\xb6sung.h'"));
  CHECK(names("$(reboot).h", "'$(reboot).h'"));
  CHECK(names("a'b.h", "'a'\\''b.h'"));
  CHECK(names("-x.h", "./-x.h"));
  CHECK(command("drift.h", {"../build/exercises/grade"})
            .starts_with("../build/exercises/grade 2-euler/orbit-drift drift.h "));
  CHECK(command("drift.h", {"/home/j\xc3\xbcrgen/grade"})
            .starts_with("'/home/j\xc3\xbcrgen/grade' 2-euler/orbit-drift drift.h "));
  CHECK(command("drift.h", {"a\nb/grade"})
            .starts_with("build/exercises/grade 2-euler/orbit-drift drift.h "));
  for (const char* strange : {"", "a\nb.h", "a\xe2\x80\xae.h", "\x1b.h"}) {
    CAPTURE(strange);
    CHECK(names(strange, "orbit-drift.h"));
  }
}

TEST_CASE("feedback names the same command as the terminal") {
  const Place seen{"../grade", "mine/drift.h"};
  const std::string command = next_commands(sample(), seen).front();
  CHECK(has(command, "mine/drift.h"));
  CHECK(has(feedback(sample(), seen), "\n" + command + "\n"));
  CHECK(has(terminal(sample(), false, false, seen), "Next: " + command + "\n"));
}

TEST_CASE("what is expected and what came differ in the digits that are shown") {
  Report report = sample();
  Finding& finding = report.tests[1].findings[0];
  finding.expected = "32212.254720000001 s, as it should be";
  finding.got = "32212.254721640001";
  const std::string text = terminal(report, false);
  CHECK(has(text, "32212.25472 s"));
  CHECK(has(text, "32212.254722\n"));
}

TEST_CASE("of a program that ended, the test in which it did is named") {
  Report report = sample();
  report.verdict = Verdict::runtime_error;
  report.memory = "Your code reads outside of the memory that it has, in line 3.";
  report.why = "Your code crashed.";
  const std::string text = terminal(report, false);
  CHECK(has(text, "ended here"));
  CHECK(text.find("in line 3") < text.find("Your code crashed."));
  report.verdict = Verdict::compile_error;
  CHECK_FALSE(has(terminal(report, false), "ended here"));
}

TEST_CASE("a student's text does nothing in a terminal") {
  check_harmless(terminal(hostile_sample(), false));
  const std::string coloured = terminal(hostile_sample(), true);
  CHECK(has(coloured, "\x1b[31mdid not hold"));
  CHECK_FALSE(has(coloured, "\x1b[31mred"));
}

TEST_CASE("every verdict has a sentence") {
  for (int code = 0; code <= int(Verdict::grader_error); ++code) {
    const Verdict verdict = Verdict(code);
    CHECK_FALSE(sentence(verdict).empty());
    CHECK(verdict_named(name(verdict)) == verdict);
  }
}
