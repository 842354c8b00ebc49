// SPDX-License-Identifier: MIT-0
#include "course/student_page.h"

#include <cctype>
#include <cstdio>

#include "class/page_style.h"
#include "course/base64.h"
#include "format_values.h"
#include "printable.h"
#include "report/escape.h"
#include "report/files.h"
#include "report/plot.h"
#include "report/words.h"

namespace grade {
namespace {

constexpr const char* student_style = R"css(
main { max-width: 46rem; }
h3 { font-size: 1rem; margin: 1.5rem 0 .3rem; }
p.said { color: var(--ink); }
dl { margin: .3rem 0; }
dt { color: var(--soft); font-size: .85rem; }
dd { margin: 0 0 .5rem; overflow-wrap: anywhere; }
pre { margin: .3rem 0; padding: .6rem .8rem; background: var(--back); overflow-x: auto; font-size: .85rem; }
pre:focus-visible { outline: 2px solid var(--accent); }
img { display: block; max-width: 100%; height: auto; margin: .6rem 0; background: #fff; border-radius: 3px; }
section { border-top: 1px solid var(--line); margin-top: 2rem; }
)css";

bool is_block(const std::string& text) {
  return text.find('\n') != text.npos;
}

/// One line as a paragraph, more as they are.
std::string paragraph(const std::string& text) {
  if (text.empty()) return "";
  if (is_block(text)) return "<pre tabindex=\"0\">" + html(text) + "</pre>\n";
  return "<p class=\"said\">" + html(text) + "</p>\n";
}

std::string entry_of(const Line& line) {
  const std::string text =
      is_block(line.text) ? "<pre tabindex=\"0\">" + html(line.text) + "</pre>" : html(line.text);
  return "<dt>" + html(line.label) + "</dt><dd>" + text + "</dd>\n";
}

/// Only a file that the grader draws.
bool is_own_picture(const std::string& file) {
  constexpr std::string_view front = "plots/test-";
  return file.starts_with(front) && file.ends_with(".svg") &&
         file.find('/', front.size()) == file.npos;
}

std::string picture_of(const Finding& finding, const std::filesystem::path& folder) {
  const Plot& plot = finding.plot;
  if (!is_own_picture(plot.file) || no_folder(folder / "plots")) return "";
  const auto drawn = read_whole(folder / plot.file);
  if (!drawn) return "";
  return "<img alt=\"" + html(plot.title) + "\" src=\"data:image/svg+xml;base64," + base64(*drawn) +
         "\">\n";
}

std::string failed_test(const TestResult& test, const std::filesystem::path& folder) {
  std::string text = "<h3>" + html(test.name) + "</h3>\n";
  for (const Finding& finding : test.findings) {
    if (finding.held) continue;
    std::string entries;
    for (const Line& line : lines(finding)) entries += entry_of(line);
    if (!entries.empty()) text += "<dl>\n" + entries + "</dl>\n";
    text += picture_of(finding, folder);
  }
  return text;
}

std::string table_of_tests(const Report& report) {
  if (report.tests.empty()) return "";
  std::string text =
      "<div class=\"wide\" tabindex=\"0\">\n<table>\n<thead><tr><th scope=\"col\">Test</th><th "
      "scope=\"col\">Points</th><th scope=\"col\">Outcome</th></tr></thead>\n<tbody>\n";
  for (const TestResult& test : report.tests) {
    text += "<tr><th scope=\"row\">" + html(test.name) + "</th><td class=\"number\">" +
            std::to_string(earned(test)) + " of " + std::to_string(test.points) + "</td><td>" +
            std::string(outcome(report, test)) + "</td></tr>\n";
  }
  return text + "</tbody>\n</table>\n</div>\n";
}

std::string not_looked_at(const Report& report) {
  std::string text;
  for (const std::string& file : report.ignored)
    text += (text.empty() ? "Not looked at: " : ", ") + html(printable_name(file));
  return text.empty() ? "" : "<p>" + text + ".</p>\n";
}

std::string what_next(const Report& graded, bool show_seed) {
  Report report = graded;
  if (!show_seed) report.seed = Request().seed;
  std::string commands;
  for (const std::string& command : next_commands(report)) commands += command + "\n";
  const std::string by =
      show_seed ? provenance(report) : "Graded by grader " + report.version + ".";
  return "<h3>Next</h3>\n<pre tabindex=\"0\">" + html(commands) + "</pre>\n<p>" + html(by) +
         "</p>\n";
}

std::string all_of_report(const PageExercise& one, bool show_seed) {
  const Report& report = one.report;
  std::string text = "<p class=\"said\">" + html(headline(report)) + ". " +
                     html(sentence(report.verdict)) + "</p>\n" + paragraph(report.why) +
                     paragraph(one.mark.late) + table_of_tests(report);
  for (const TestResult& test : report.tests)
    if (has_failed(test)) text += failed_test(test, one.folder);
  if (!report.memory.empty()) text += "<h3>Memory</h3>\n" + paragraph(report.memory);
  if (!report.warnings.empty())
    text +=
        "<h3>The compiler warns</h3>\n<pre tabindex=\"0\">" + html(report.warnings) + "</pre>\n";
  return text + not_looked_at(report) + what_next(report, show_seed);
}

std::string points_of(const Mark& mark) {
  if (!mark.asked) return "not yet due";
  if (!mark.points) return "no grade";
  return std::to_string(*mark.points) + " of " + std::to_string(mark.of);
}

std::string section_of(const PageExercise& one, bool show_seed) {
  const Mark& mark = one.mark;
  std::string text = "<section>\n<h2>" + html(mark.exercise) + ": " + points_of(mark) + "</h2>\n";
  if (!mark.asked) {
    text += "<p>Nothing was handed in so far.</p>\n";
  } else if (!mark.earned) {
    text += paragraph(std::string(sentence(Verdict::grader_error)));
  } else {
    text += all_of_report(one, show_seed);
  }
  return text + "</section>\n";
}

std::string sum_of(const std::vector<PageExercise>& exercises) {
  Total total;
  for (const PageExercise& one : exercises) total.add(one.mark);
  return total.whole
             ? std::to_string(total.points) + " of " + counted(std::size_t(total.of), "point")
             : "no sum, since the grader failed";
}

}  // namespace

std::string student_page(const PageHead& head, const std::vector<PageExercise>& exercises) {
  const std::string title = html(head.assignment) + ": " + html(head.student);
  std::string text =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
      "style-src 'unsafe-inline'\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
      title + "</title>\n<style>" + page_style + student_style +
      "</style>\n</head>\n<body>\n<main>\n<h1>" + title + "</h1>\n<p>" + html(head.course) + ": " +
      sum_of(exercises) + "</p>\n";
  for (const PageExercise& one : exercises) text += section_of(one, head.show_seed);
  return text + "</main>\n</body>\n</html>\n";
}

std::string page_name(const std::string& key) {
  constexpr std::size_t longest_name = 200;
  std::string name;
  for (const char c : key) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = std::isalnum(byte) != 0 ||
                       std::string_view("@_+-").find(c) != std::string_view::npos ||
                       (c == '.' && !name.empty());
    char spelled[4];
    std::snprintf(spelled, sizeof spelled, "%%%02X", byte);
    name += plain ? std::string(1, c) : spelled;
  }
  if (name.size() > longest_name) name = name.substr(0, 100) + "-" + sha256(key);
  return name + ".html";
}

}  // namespace grade
