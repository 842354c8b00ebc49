// SPDX-License-Identifier: MIT-0
#include "report/feedback.h"

#include "printable.h"
#include "report/escape.h"
#include "report/plot.h"
#include "report/words.h"

namespace grade {
namespace {

bool has_lines(const std::string& text) {
  return text.find('\n') != std::string::npos;
}

/// One line stands in the text; what has more, such as a compiler's message, in a block of its own.
std::string in_markdown(const std::string& text) {
  if (text.empty()) return "";
  return (has_lines(text) ? markdown_code(text) : markdown(text) + "\n") + "\n";
}

std::string table(const Report& report) {
  if (report.tests.empty()) return "";
  std::string text = "| Test | Points | |\n|:-----|-------:|:--|\n";
  for (const TestResult& test : report.tests) {
    text += "| " + markdown(test.name) + " | " + std::to_string(earned(test)) + " of " +
            std::to_string(test.points) + " | " + std::string(outcome(report, test)) + " |\n";
  }
  return text + "\n";
}

std::string item(const Line& line) {
  if (!has_lines(line.text)) return "- **" + line.label + ":** " + markdown(line.text) + "\n";
  return "- **" + line.label + ":**\n\n" + markdown_code(line.text) + "\n";
}

std::string picture(const Finding& finding) {
  const Plot& plot = finding.plot;
  if (!plot.file.empty()) return "![" + markdown(plot.title) + "](" + plot.file + ")\n\n";
  return has_plot(finding) ? "*No picture: " + std::string(why_no_picture(plot)) + ".*\n\n" : "";
}

std::string section(const TestResult& test) {
  std::string text = "## " + markdown(test.name) + "\n\n";
  for (const Finding& finding : test.findings) {
    if (finding.held) continue;
    for (const Line& line : lines(finding)) text += item(line);
    text += "\n" + picture(finding);
  }
  return text;
}

std::string list_of_ignored(const Report& report) {
  std::string text;
  for (const std::string& file : report.ignored) {
    text += (text.empty() ? "Not looked at: " : ", ") + markdown(printable_name(file));
  }
  return text.empty() ? "" : text + ".\n\n";
}

std::string next(const Report& report, const Place& place) {
  std::string text = "## Next\n\n```sh\n";
  for (const std::string& command : next_commands(report, place)) text += command + "\n";
  return text + "```\n\n" + markdown(provenance(report)) + "\n";
}

}  // namespace

std::string feedback(const Report& report, const Place& place) {
  std::string text = "# " + markdown(report.exercise) + ": " + headline(report) + "\n\n" +
                     std::string(sentence(report.verdict)) + "\n\n" + in_markdown(report.why) +
                     table(report);
  for (const TestResult& test : report.tests) {
    if (has_failed(test)) text += section(test);
  }
  if (!report.memory.empty()) text += "## Memory\n\n" + in_markdown(report.memory);
  if (!report.warnings.empty()) {
    text += "## The compiler warns\n\n" + markdown_code(report.warnings) + "\n";
  }
  return text + list_of_ignored(report) + next(report, place);
}

}  // namespace grade
