// SPDX-License-Identifier: MIT-0
#include "class/results.h"

#include "report/words.h"

namespace grade {

Results collect(const std::vector<Student>& students, const std::vector<Exercise>& exercises,
                const std::vector<Job>& jobs) {
  Results results{students, exercises, {}, {}};
  for (const Job& job : jobs) {
    results.reports.push_back(job.asked ? kept_report(job) : Report());
    results.asked.push_back(job.asked);
  }
  return results;
}

std::vector<Report> Results::all() const {
  std::vector<Report> found;
  for (std::size_t i = 0; i < reports.size(); ++i)
    if (asked[i]) found.push_back(reports[i]);
  return found;
}

std::vector<Job> stale(const std::vector<Job>& jobs, const Results& results, std::uint64_t seed) {
  std::vector<Job> found;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const Report& report = results.reports[i];
    if (!jobs[i].asked || !is_graded(report)) continue;
    const bool same = report.version == version(jobs[i].exercise) && report.seed == seed;
    if (!same) found.push_back(jobs[i]);
  }
  return found;
}

}  // namespace grade
