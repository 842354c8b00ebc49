// SPDX-License-Identifier: MIT-0
#include "class/grade_all.h"

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <map>

#include "class/pool.h"
#include "class/progress.h"
#include "report/words.h"
#include "time_limits.h"

namespace grade {
namespace {

std::chrono::milliseconds deadline(const Request& request) {
  return std::chrono::milliseconds(std::llround(1000 * longest_grading(request)));
}

/// By the names of the exercises.
using Requests = std::map<std::string, Request>;

/// Each exercise's solution is graded once, before anything else runs.
std::optional<Obstacle> calibrate_all(const std::vector<Job>& jobs, const Class& work,
                                      Requests& requests) {
  for (const Job& job : jobs) {
    const auto [found, is_new] = requests.try_emplace(job.exercise.name);
    if (!is_new) continue;
    Request& request = found->second;
    request.exercise = job.exercise;
    request.seed = work.seed;
    if (auto obstacle = calibrate(request)) return obstacle;
  }
  return std::nullopt;
}

std::vector<ChildProcess> children(const std::vector<Job>& jobs, const Class& work,
                                   const Requests& requests) {
  std::vector<ChildProcess> all;
  for (const Job& job : jobs) {
    const Request& request = requests.at(job.exercise.name);
    all.push_back(
        {job.student.name, arguments(job, work, write_limits(request)), deadline(request)});
  }
  return all;
}

/// Whatever held up the grader until it was killed, the points that it had come to are kept.
void note_late(const Job& job, const Class& work) {
  Report report = kept_report(job);
  const bool under_way = report.verdict == Verdict::grader_error && !report.version.empty();
  if (!under_way) return;
  report.verdict = Verdict::time_limit;
  report.why = "Grading was stopped at its deadline. What had held by then counts.";
  report.try_again = false;
  for (const TestResult& test : report.tests) report.score += earned(test);
  keep(report, job.out, work.emits);
}

}  // namespace

std::optional<Obstacle> grade_all(const std::vector<Job>& jobs, const Class& work) {
  Requests requests;
  if (auto obstacle = calibrate_all(jobs, work, requests)) return obstacle;
  std::filesystem::create_directories(work.results);
  Progress progress(jobs.size(), isatty(STDOUT_FILENO) != 0);
  run_all(children(jobs, work, requests), work.jobs, [&](std::size_t i, bool late) {
    if (late) note_late(jobs[i], work);
    progress.done(jobs[i], kept_report(jobs[i]));
  });
  return std::nullopt;
}

}  // namespace grade
