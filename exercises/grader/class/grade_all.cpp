// SPDX-License-Identifier: MIT-0
#include "class/grade_all.h"

#include <unistd.h>

#include <filesystem>
#include <map>

#include "class/pool.h"
#include "class/progress.h"
#include "judge/session.h"
#include "time_limits.h"

namespace grade {
namespace {

/// The longest that a grading can take: the compiler, and each test, which starts at most two
/// drivers; as much again for the rest.
std::chrono::milliseconds longest(const Request& request) {
  const auto tests = static_cast<double>(judge::tests_of(request.exercise.name).size());
  const double seconds = request.compile_limits.wall + 2 * tests * request.run_limits.wall;
  return std::chrono::milliseconds(static_cast<long>(2000 * seconds));
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
    all.push_back({arguments(job, work, write_limits(request)), longest(request)});
  }
  return all;
}

}  // namespace

std::optional<Obstacle> grade_all(const std::vector<Job>& jobs, const Class& work) {
  Requests requests;
  if (auto obstacle = calibrate_all(jobs, work, requests)) return obstacle;
  std::filesystem::create_directories(work.results);
  Progress progress(jobs.size(), isatty(STDOUT_FILENO) != 0);
  run_all(children(jobs, work, requests), work.jobs,
          [&](std::size_t i) { progress.done(jobs[i], kept_report(jobs[i])); });
  return std::nullopt;
}

}  // namespace grade
