// SPDX-License-Identifier: MIT-0
#include "report/junit.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "report/escape.h"
#include "report/words.h"

namespace grade {
namespace {

std::string attribute(const char* name, std::string_view value) {
  return std::string(" ") + name + "=\"" + html(value) + "\"";
}

std::string element(const char* name, std::string_view message, std::string_view type,
                    std::string_view text) {
  return std::string("      <") + name + attribute("message", message) + attribute("type", type) +
         ">" + html(text) + "</" + name + ">\n";
}

std::string testcase(const Report& report, std::string_view name, const std::string& inside) {
  return "    <testcase" + attribute("classname", report.exercise) + attribute("name", name) +
         (inside.empty() ? "/>\n" : ">\n" + inside + "    </testcase>\n");
}

std::string of_whole(const Report& report) {
  if (is_judged(report.verdict)) return "";
  return element("error", sentence(report.verdict), name(report.verdict), report.why);
}

std::string failure(const Report& report, const TestResult& test) {
  std::string message, text;
  for (const Finding& finding : test.findings) {
    if (finding.held) continue;
    message = finding.asked;
    for (const Line& line : lines(finding)) text += line.label + ": " + line.text + "\n";
  }
  return element("failure", message, name(report.verdict), text);
}

std::string of_test(const Report& report, const TestResult& test) {
  if (!test.ran) return "      <skipped message=\"not run\"/>\n";
  return test.held ? "" : failure(report, test);
}

std::string count(const Report& report, bool (*counts)(const TestResult&)) {
  return std::to_string(std::count_if(report.tests.begin(), report.tests.end(), counts));
}

std::string time(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", std::isfinite(seconds) ? seconds : 0);
  return text;
}

std::string counts(const Report& report) {
  return attribute("tests", std::to_string(report.tests.size() + 1)) +
         attribute("failures",
                   count(report, [](const TestResult& t) { return t.ran && !t.held; })) +
         attribute("errors", is_judged(report.verdict) ? "0" : "1") +
         attribute("skipped", count(report, [](const TestResult& t) { return !t.ran; })) +
         attribute("time", time(report.seconds));
}

}  // namespace

std::string junit(const Report& report) {
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n  <testsuite" +
                     attribute("name", report.exercise) + counts(report) + ">\n" +
                     testcase(report, "is taken, compiles and runs to its end", of_whole(report));
  for (const TestResult& test : report.tests) {
    text += testcase(report, test.name, of_test(report, test));
  }
  return text + "  </testsuite>\n</testsuites>\n";
}

}  // namespace grade
