// SPDX-License-Identifier: MIT-0
#include "course/write_equal.h"

#include <algorithm>
#include <cstdio>

#include "class/grade_all.h"
#include "course/equal.h"
#include "format_values.h"
#include "given_files.h"
#include "printable.h"
#include "replace_all.h"
#include "report/files.h"

namespace grade {
namespace {

/// What is known of one exercise.
struct HandedIn {
  Exercise exercise;
  std::vector<Handed> all;
};

std::vector<HandedIn> by_exercise(const Class& work, const Participants& students,
                                  const std::vector<Job>& jobs) {
  std::vector<HandedIn> found;
  for (const Exercise& exercise : work.assigned) found.push_back({exercise, {}});
  auto job = jobs.begin();
  for (const Participant& one : students.all) {
    if (!one.folder) continue;
    for (HandedIn& handed : found) {
      if (job->asked && is_done(*job, work.seed))
        handed.all.push_back({printable_name(one.member.key), kept_report(*job)});
      ++job;
    }
  }
  return found;
}

/// No student's folder begins with a dot.
Job starter_job(const Class& work, const Exercise& exercise) {
  const std::string owner = ".starter";
  return {{owner, exercise.folder / "starter.h"}, exercise, work.results / owner / exercise.name};
}

/// Hashes of the starter, as editors save it.
std::set<std::string> starter_hashes(const Exercise& exercise) {
  const auto text = small_file(exercise.folder / "starter.h");
  if (!text || exercise.folder.empty()) return {};
  std::set<std::string> hashes;
  for (const std::string& lines : {*text, replace_all(*text, "\n", "\r\n")})
    for (const char* mark : {"", "\xef\xbb\xbf"}) hashes.insert(sha256(mark + lines));
  return hashes;
}

bool has_starter(const Exercise& exercise) {
  return !starter_hashes(exercise).empty();
}

bool has_equal_numbers(const std::vector<Handed>& all) {
  return std::ranges::any_of(equal_work(all, {}, {}),
                             [](const EqualWork& one) { return one.what == "wrong numbers"; });
}

void grade_starters(const Class& work, const std::vector<HandedIn>& exercises) {
  std::vector<Job> jobs;
  for (const HandedIn& one : exercises) {
    if (!has_equal_numbers(one.all) || !has_starter(one.exercise)) continue;
    const Job job = starter_job(work, one.exercise);
    if (!is_done(job, work.seed)) jobs.push_back(job);
  }
  if (jobs.empty()) return;
  if (const auto obstacle = grade_all(jobs, work))
    std::fprintf(stderr, "grade: equal numbers are not listed, since %s\n", obstacle->why.c_str());
}

/// The starter's report if it has one, or none can be.
std::vector<EqualWork> equal_in(const Class& work, const HandedIn& handed) {
  std::optional<Report> starter;
  const bool compared = has_equal_numbers(handed.all) && has_starter(handed.exercise);
  if (compared) {
    const Job job = starter_job(work, handed.exercise);
    if (is_done(job, work.seed)) starter = kept_report(job);
  }
  std::vector<EqualWork> found = equal_work(handed.all, starter_hashes(handed.exercise), starter);
  // Of numbers that may be the starter's nothing is said.
  if (compared && !starter)
    std::erase_if(found, [](const EqualWork& one) { return one.what != "file"; });
  return found;
}

}  // namespace

void write_equal(const Class& work, const Participants& students, const std::vector<Job>& jobs) {
  const std::vector<HandedIn> exercises = by_exercise(work, students, jobs);
  grade_starters(work, exercises);
  std::vector<EqualWork> all;
  for (const HandedIn& one : exercises) {
    const std::vector<EqualWork> found = equal_in(work, one);
    all.insert(all.end(), found.begin(), found.end());
  }
  write_whole(work.results / "equal.csv", equal_csv(all));
  if (all.empty()) return;
  std::printf("Equal work in %s, to look at: see %s\n", counted(all.size(), "place").c_str(),
              printable_name((work.results / "equal.csv").string()).c_str());
}

}  // namespace grade
