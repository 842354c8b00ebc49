// SPDX-License-Identifier: MIT-0
#include <array>
#include <cctype>
#include <cstdio>

#include "class/page_style.h"
#include "class/summary.h"
#include "format_values.h"
#include "printable.h"
#include "report/escape.h"
#include "report/words.h"

namespace grade {
namespace {

/// The bytes of a path as a link.
std::string link(const std::string& path) {
  std::string result;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain =
        std::isalnum(byte) != 0 || std::string_view("-._~/").find(c) != std::string::npos;
    char encoded[4];
    std::snprintf(encoded, sizeof encoded, "%%%02X", byte);
    result += plain ? std::string(1, c) : encoded;
  }
  return "./" + result;
}

std::string percent(std::size_t part, std::size_t whole) {
  return std::to_string(whole == 0 ? 0 : (100 * part + whole / 2) / whole);
}

std::string bar(const TestCount& test, std::size_t judged) {
  const std::string share = percent(test.held, judged);
  return "<tr><th scope=\"row\">" + html(test.name) + "</th><td class=\"number\">" +
         std::to_string(test.points) + "</td><td class=\"number\">" + std::to_string(test.held) +
         " of " + std::to_string(judged) +
         "</td><td class=\"bar\"><svg viewBox=\"0 0 100 10\" preserveAspectRatio=\"none\" "
         "role=\"img\" aria-label=\"" +
         share + " percent\"><rect width=\"" + share + "\" height=\"10\"></rect></svg></td></tr>\n";
}

std::string verdicts(const ExerciseCount& all) {
  std::string text = "<ul class=\"verdicts\">\n";
  for (const auto& [verdict, number] : all.verdicts) {
    text += "<li><b>" + std::to_string(number) + "</b> " + std::string(name(verdict)) + "</li>\n";
  }
  return text + "</ul>\n";
}

std::string section(const Results& results, std::size_t exercise) {
  const ExerciseCount all = count(results, exercise);
  std::string text = "<section>\n<h2>" + html(results.exercises[exercise].name) + "</h2>\n" +
                     verdicts(all) +
                     "<div class=\"wide\" tabindex=\"0\">\n<table>\n<thead><tr>"
                     "<th scope=\"col\">Test</th><th scope=\"col\">Points</th>"
                     "<th scope=\"col\">Held</th><th scope=\"col\" "
                     "class=\"bar\">Share</th></tr></thead>\n<tbody>\n";
  for (const TestCount& test : all.tests) text += bar(test, all.judged);
  return text + "</tbody>\n</table>\n</div>\n</section>\n";
}

std::string grade_cell(const Results& results, std::size_t student, std::size_t exercise) {
  if (!results.is_asked(student, exercise)) return "<td></td>";
  const Report& report = results.report(student, exercise);
  const std::string path =
      results.students[student].name + "/" + results.exercises[exercise].name + "/feedback.md";
  const std::string score = is_graded(report)
                                ? std::to_string(report.score) + "/" + std::to_string(report.points)
                                : "no grade";
  return "<td><a href=\"" + link(path) + "\">" + score + "</a> <span class=\"verdict\">" +
         std::string(name(report.verdict)) + "</span></td>";
}

std::string student_row(const Results& results, std::size_t student) {
  int total = 0, of = 0;
  bool whole = true;
  std::string cells;
  for (std::size_t e = 0; e < results.exercises.size(); ++e) {
    cells += grade_cell(results, student, e);
    if (!results.is_asked(student, e)) continue;
    of += results.report(student, e).points;
    total += results.report(student, e).score;
    whole = whole && is_graded(results.report(student, e));
  }
  return "<tr><th scope=\"row\">" + html(printable_name(results.students[student].name)) +
         "</th><td class=\"number\">" +
         (whole ? std::to_string(total) + "/" + std::to_string(of) : "no grade") + "</td>" + cells +
         "</tr>\n";
}

std::string students(const Results& results) {
  std::string text =
      "<section>\n<h2>Students</h2>\n<div class=\"wide\" tabindex=\"0\">\n<table "
      "class=\"students\">\n"
      "<thead><tr><th scope=\"col\">Student</th><th scope=\"col\">Total</th>";
  for (const Exercise& exercise : results.exercises) {
    text += "<th scope=\"col\">" + html(exercise.name) + "</th>";
  }
  text += "</tr></thead>\n<tbody>\n";
  for (std::size_t s = 0; s < results.students.size(); ++s) text += student_row(results, s);
  return text + "</tbody>\n</table>\n</div>\n</section>\n";
}

}  // namespace

std::string summary_html(const Results& results, const std::string& title) {
  const std::string seed = results.all().empty() ? "" : std::to_string(results.all().front().seed);
  return std::string(
             "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
             "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
             "<title>") +
         html(title) + "</title>\n<style>" + page_style +
         "</style>\n</head>\n<body>\n<main>\n<h1>" + html(title) + "</h1>\n<p>" +
         counted(results.students.size(), "student") + ", " +
         counted(results.exercises.size(), "exercise") + ", seed " + seed +
         ". Shares are of those whose submission was taken.</p>\n" +
         [&] {
           std::string sections;
           for (std::size_t e = 0; e < results.exercises.size(); ++e)
             sections += section(results, e);
           return sections;
         }() +
         students(results) + "</main>\n</body>\n</html>\n";
}

}  // namespace grade
