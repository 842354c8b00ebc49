// SPDX-License-Identifier: MIT-0
#include "report/terminal.h"

#include <algorithm>
#include <sstream>
#include <vector>

#include "printable.h"
#include "report/plot.h"
#include "report/shortened.h"
#include "report/words.h"
#include "report/wrapped.h"

namespace grade {
namespace {

constexpr std::size_t label_width = 11;

/// Lines as they are, each behind a bar.
std::string barred(const std::string& text) {
  std::istringstream lines(printable(text));
  std::string result;
  for (std::string line; std::getline(lines, line);) result += "  | " + line + "\n";
  return result;
}

std::string paragraph(const std::string& text) {
  if (text.empty()) return "";
  return text.find('\n') == std::string::npos ? wrapped(text, 0) : barred(text);
}

class Paint {
 public:
  explicit Paint(bool colour) : colour_(colour) {}
  std::string good(const std::string& text) const { return in("32", text); }
  std::string bad(const std::string& text) const { return in("31", text); }
  std::string strong(const std::string& text) const { return in("1", text); }

 private:
  std::string in(const char* code, const std::string& text) const {
    return colour_ ? std::string("\x1b[") + code + "m" + text + "\x1b[0m" : text;
  }
  bool colour_;
};

std::string points(const TestResult& test) {
  return std::to_string(earned(test)) + "/" + std::to_string(test.points);
}

std::string row(const Report& report, const TestResult& test, const Paint& paint) {
  const std::string text(outcome(report, test));
  const std::string label = text + std::string(14 - text.size(), ' ');
  const std::string score =
      std::string(6 - std::min<std::size_t>(6, points(test).size()), ' ') + points(test) + "  ";
  constexpr std::size_t before = 2 + 14 + 8;
  return "  " + (test.held ? paint.good(label) : paint.bad(label)) + score +
         wrapped(test.name, before);
}

std::string labelled(const Line& line) {
  const std::string label = "    " + line.label + std::string(label_width - line.label.size(), ' ');
  if (line.text.find('\n') == std::string::npos) {
    return label + wrapped(line.text, 4 + label_width);
  }
  return label + "\n" + barred(line.text);
}

std::string where(const Plot& plot) {
  if (!plot.file.empty()) return plot.file;
  return can_be_drawn(plot) ? "drawn by --out FOLDER, if gnuplot is installed"
                            : std::string(why_no_picture(plot));
}

std::string section(const TestResult& test, const Paint& paint) {
  std::string text = "\n" + paint.strong("  " + wrapped(test.name, 2));
  for (const Finding& finding : test.findings) {
    if (finding.held) continue;
    for (Line& line : lines(finding)) {
      const bool compared = line.label == "Expected" || line.label == "Got";
      if (!compared) line.text = shortened(line.text);  // these two have the digits that they need
      text += labelled(line);
    }
    if (has_plot(finding)) text += labelled({"Picture", where(finding.plot)});
  }
  return text;
}

/// The outcome of a failed test, in a line.
std::string in_short(const TestResult& test) {
  for (const Finding& finding : test.findings) {
    if (finding.held) continue;
    const std::string off = (is_size(finding.error) ? "off by " : "") + finding.error;
    const std::string said = finding.diagnoses.empty() ? off : finding.diagnoses.front();
    return said.substr(0, said.find('\n'));
  }
  return "";
}

std::string failures(const Report& report, const Paint& paint, bool all) {
  std::vector<TestResult> failed;
  for (const TestResult& test : report.tests)
    if (has_failed(test)) failed.push_back(test);
  std::string text;
  for (std::size_t i = 0; i < failed.size(); ++i) {
    if (all || i == 0) {
      text += section(failed[i], paint);
    } else {
      text += (i == 1 ? "\n" : "") +
              ("  " + wrapped(failed[i].name + ": " + shortened(in_short(failed[i])), 4));
    }
  }
  return failed.size() > 1 && !all ? text + "  --all shows each of them in full.\n" : text;
}

std::string ignored(const Report& report) {
  std::string text;
  for (const std::string& file : report.ignored) {
    text += (text.empty() ? "Not looked at: " : ", ") + printable_name(file);
  }
  return text.empty() ? "" : "\n" + wrapped(text + ".", 0);
}

}  // namespace

std::string terminal(const Report& report, bool colour, bool all, const Place& place) {
  const Paint paint(colour);
  const bool full = report.verdict == Verdict::accepted;
  // The checker of memory says of a crash what is more exact than what its signal tells.
  const bool stopped = report.verdict == Verdict::runtime_error && !report.memory.empty();
  std::string text = printable(report.exercise) + ": " +
                     (full ? paint.good(headline(report)) : paint.bad(headline(report))) + "\n" +
                     std::string(sentence(report.verdict)) + "\n" +
                     (stopped ? wrapped(report.memory, 0) : "") + paragraph(report.why);
  if (!report.tests.empty()) text += "\n";
  for (const TestResult& test : report.tests) text += row(report, test, paint);
  text += failures(report, paint, all);
  if (!report.memory.empty() && !stopped) text += "\n" + wrapped(report.memory, 0);
  if (!report.warnings.empty()) text += "\nThe compiler warns:\n" + barred(report.warnings);
  text += ignored(report) + "\n" + wrapped(provenance(report), 0);
  for (const std::string& command : next_commands(report, place)) {
    text += "Next: " + command + "\n";
  }
  return text;
}

std::string on_one_screen(const Report& report, bool colour) {
  const auto failed = std::ranges::find_if(report.tests, has_failed);
  if (!is_judged(report.verdict) || failed == report.tests.end()) return terminal(report, colour);
  TestResult first = *failed;
  for (Finding& finding : first.findings) {
    finding.tolerance.clear();
    finding.tolerance_from.clear();
    finding.plot = {};
  }
  const Paint paint(colour);
  const auto held = std::ranges::count_if(report.tests, &TestResult::held);
  return section(first, paint) + "\n" + printable(report.exercise) + ": " +
         paint.bad(headline(report)) + ", " + std::to_string(held) + " of " +
         std::to_string(report.tests.size()) + " tests held\n";
}

}  // namespace grade
