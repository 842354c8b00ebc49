// SPDX-License-Identifier: MIT-0
#pragma once
#include <cmath>
#include <limits>
#include <string>

#include "grade_submission.h"

/// What a hostile submission gets into a report: a command for a CI service, Markdown, HTML, a
/// bell, colours, bytes that are no text, and a turn of the direction of writing.
inline const std::string hostile =
    "::error::forged\n##[error]forged\n<script>alert(1)</script> ![x](http://example.org/x.png) "
    "`` ``` ```` | **bold** @teacher \x1b[31mred\x1b[0m \a \xff \xe2\x80\xae]]>";

inline grade::Curve curve(const std::string& name, double growth, int points) {
  grade::Curve curve{name, {}, {}};
  for (int n = 0; n < points; ++n) {
    const double angle = 0.05 * n, radius = std::exp(growth * angle);
    curve.x.push_back(radius * std::cos(angle));
    curve.y.push_back(radius * std::sin(angle));
  }
  return curve;
}

inline grade::Finding failed_finding() {
  grade::Finding finding;
  finding.asked = "five steps of Euler's method";
  finding.input = "x = (1, 0), v = (0, 1), h = 0.1";
  finding.expected = "x = (1, 0.1)";
  finding.got = "x = (0.99, 0.1)";
  finding.error = "0.01";
  finding.tolerance = "1e-12";
  finding.tolerance_from = "rounding of forty operations";
  finding.hint = "Both lines use the state at the start of the step.";
  finding.diagnoses = {"this is symplectic Euler to 1e-16"};
  finding.plot = {"Five steps",
                  "x [m]",
                  "y [m]",
                  {curve("yours", 0, 200), curve("Euler's method", 0.05, 200)},
                  true};
  return finding;
}

/// Two tests held, one did not, one was not run.
inline grade::Report sample() {
  grade::Report report;
  report.exercise = "2-euler/orbit-drift";
  report.version = "0123456789abcdef";
  report.submission = "my_euler.h";
  report.sha256 = std::string(64, 'a');
  report.seed = std::numeric_limits<std::uint64_t>::max();
  report.verdict = grade::Verdict::partial;
  report.warnings = "my_euler.h:3:7: warning: unused variable 'k'\n    3 |   int k;";
  report.ignored = {"notes.txt"};
  report.tests = {{"the first of four", 1, true, true, {}},
                  {"five steps are Euler's", 4, true, false, {failed_finding()}},
                  {"the third of four", 2, true, true, {}},
                  {"not reached", 3, false, false, {}}};
  report.score = 3;
  report.points = 10;
  report.seconds = 0.75;
  report.compile_seconds = 0.5;
  report.run_seconds = 0.25;
  return report;
}

/// The same with a student's text wherever it may come from.
inline grade::Report hostile_sample() {
  grade::Report report = sample();
  report.verdict = grade::Verdict::runtime_error;
  report.submission = hostile;
  report.why = hostile;
  report.warnings = hostile;
  report.ignored = {hostile};
  report.tests[1].findings[0].got = hostile;
  report.tests[1].findings[0].diagnoses = {hostile};
  return report;
}

inline bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}
