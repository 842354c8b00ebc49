// SPDX-License-Identifier: MIT-0
#include "class/work.h"

#include <unistd.h>

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

/// Limits are calibrated once for each exercise, before anything else runs.
std::vector<Task> tasks(const std::vector<Job>& jobs, const Class& work) {
  std::map<std::string, Request> requests;
  std::vector<Task> all;
  for (const Job& job : jobs) {
    const auto [found, is_new] = requests.try_emplace(job.exercise.name);
    Request& request = found->second;
    if (is_new) {
      request.exercise = job.exercise;
      request.seed = work.seed;
      calibrate(request);
    }
    all.push_back({arguments(job, work, write_limits(request)), longest(request)});
  }
  return all;
}

}  // namespace

void grade_all(const std::vector<Job>& jobs, const Class& work) {
  Progress progress(jobs.size(), isatty(STDOUT_FILENO) != 0);
  run_all(tasks(jobs, work), work.jobs,
          [&](std::size_t i) { progress.done(jobs[i], kept_report(jobs[i])); });
}

}  // namespace grade
