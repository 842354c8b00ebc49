// SPDX-License-Identifier: MIT-0
#include "class/job.h"

#include "report/files.h"
#include "report/json.h"
#include "submission.h"

namespace grade {

std::vector<Job> all_jobs(const Class& work, const std::vector<Student>& students,
                          const std::vector<Exercise>& exercises) {
  std::vector<Job> jobs;
  for (const Student& student : students) {
    const bool owed = !work.assigned.empty() && (!work.is_due || work.is_due(student));
    for (const Exercise& exercise : exercises) {
      jobs.push_back({student, exercise, work.results / student.name / exercise.name,
                      owed || has(student, exercise)});
    }
  }
  return jobs;
}

std::vector<Job> jobs_of(const std::vector<Job>& jobs, const Shard& shard) {
  std::vector<Job> part;
  for (std::size_t i = shard.part - 1; i < jobs.size(); i += shard.of) part.push_back(jobs[i]);
  return part;
}

Report kept_report(const Job& job) {
  const std::optional<std::string> text = read_whole(job.out / "report.json");
  if (const std::optional<Report> report = text ? report_from(*text) : std::nullopt) return *report;
  Report none;
  none.exercise = job.exercise.name;
  none.why = "There is no report.";
  none.try_again = true;
  return none;
}

bool is_done(const Job& job, std::uint64_t seed) {
  const Report report = kept_report(job);
  if (report.verdict == Verdict::grader_error || report.exercise != job.exercise.name ||
      report.version != version(job.exercise) || report.seed != seed ||
      report.sandbox != cage::Sandbox::bubblewrap) {
    return false;
  }
  const Submission now =
      read_submission(job.student.folder, job.exercise.chapter(), job.exercise.header());
  if (!now.refused.empty()) return report.sha256.empty() && report.why == now.refused;
  return report.sha256 == sha256(now.text);
}

std::vector<std::string> arguments(const Job& job, const Class& work, const std::string& limits) {
  std::vector<std::string> all{"grade", "--out=" + job.out.string(), "--limits=" + limits,
                               "--unchecked"};
  all.push_back(work.seed_file.empty() ? "--seed=" + std::to_string(work.seed)
                                       : "--seed-file=" + work.seed_file.string());
  if (work.emits.contains(Emit::gradescope)) all.push_back("--emit=gradescope");
  if (work.emits.contains(Emit::junit)) all.push_back("--emit=junit");
  all.insert(all.end(), {"--", job.exercise.name, job.student.folder.string()});
  return all;
}

}  // namespace grade
