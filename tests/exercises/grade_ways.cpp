// SPDX-License-Identifier: MIT-0
// What becomes of submissions of ours that lie in one driver, outside the cage:
//
//     grade_ways 2-euler/orbit-drift DRIVER 10,30,1,3 [words] < HEADERS
//
// The limits are those of `grade --limits`, of which the last two, processor time and time on the
// clock [s], are the run's. Standard input has a header's path on each line, as ways.mjs was given
// it. For each, a line says `VERDICT score/points path`, under the public seed; with
// `words` it is the report as a page has it, with the diagnoses.
#include <cstdio>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>

#include "grade_submission.h"
#include "report/words_as_json.h"
#include "time_limits.h"
#include "ways.h"

namespace {

using grade::Report;

std::optional<cage::Limits> run_limits(const char* text) {
  grade::Request request;
  if (!grade::read_limits(text, request)) return std::nullopt;
  return request.run_limits;
}

void print(const Report& report, const std::string& header) {
  std::printf("%s %d/%d %s\n", std::string(grade::name(report.verdict)).c_str(), report.score,
              report.points, header.c_str());
  if (report.verdict == grade::Verdict::grader_error)
    std::fprintf(stderr, "grade_ways: %s: %s\n", header.c_str(), report.why.c_str());
}

int refuse(const char* why) {
  std::fprintf(stderr, "grade_ways: %s\n", why);
  return 2;
}

}  // namespace

int main(int count, char** arguments) {
  const bool words = count == 5 && std::string(arguments[4]) == "words";
  const bool complete = count == 4 || words;
  const auto exercise = complete ? grade::exercise(arguments[1]) : std::nullopt;
  const auto limits = complete ? run_limits(arguments[3]) : std::nullopt;
  if (!exercise || !limits)
    return refuse(
        "name one exercise, such as 2-euler/orbit-drift, its driver, and limits, such as "
        "10,30,1,3; the headers come by standard input");
  try {
    const ways::Driver driver(*exercise, arguments[2]);
    for (std::string header; std::getline(std::cin, header);) {
      const Report report = driver.grade(header, 1, *limits, "", words);
      words ? void(std::puts(grade::words_as_json(report).c_str())) : print(report, header);
    }
  } catch (const std::exception& problem) {
    return refuse(problem.what());
  }
}
