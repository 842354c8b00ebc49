// SPDX-License-Identifier: MIT-0
#include "course/marks.h"

#include <algorithm>

#include "printable.h"

namespace grade {
namespace {

/// What the tests gave; nothing if the kept report is of another text, grader or seed.
void add_grade(Mark& mark, const Job& job, std::uint64_t seed) {
  const Report report = kept_report(job);
  const bool graded = is_done(job, seed);
  mark.verdict = graded ? name(report.verdict) : name(Verdict::grader_error);
  if (graded) mark.earned = report.score;
}

void add_lateness(Mark& mark, std::optional<Instant> handed_in, Instant due,
                  const Assignment& assignment, const TimeZone& zone) {
  mark.due = shown(zone.local(due));
  if (handed_in) mark.handed_in = shown(zone.local(*handed_in));
  mark.points = mark.earned;
  if (!handed_in) return;
  const Lateness late = lateness(*handed_in, due, assignment.late, zone);
  mark.seconds_late = late.by.count();
  mark.days_late = late.days;
  mark.taken = taken(late, assignment.late, mark.earned.value_or(0));
  mark.late = late_words(late, mark.taken);
  if (mark.earned) mark.points = *mark.earned - mark.taken;
}

Mark mark_of(const Exercise& exercise) {
  Request request;
  request.exercise = exercise;
  Mark mark;
  mark.exercise = exercise.name;
  mark.of = blank_report(request).points;
  return mark;
}

/// Of somebody who has no folder.
Mark missing(const Exercise& exercise, Instant due, const TimeZone& zone, bool all_matched) {
  Mark mark = mark_of(exercise);
  mark.due = shown(zone.local(due));
  mark.asked = all_matched && now() > due;
  if (mark.asked) mark.earned = mark.points = 0;
  return mark;
}

}  // namespace

void Total::add(const Mark& mark) {
  if (!mark.asked) return;
  any = true;
  whole = whole && mark.points.has_value();
  points += mark.points.value_or(0);
  of += mark.of;
}

Marks marks_of(const Course& course, const Assignment& assignment, const Participants& students,
               const std::vector<Job>& jobs, std::uint64_t seed, const HandedInAt& handed_in_at) {
  Marks all{course.name, assignment.name, {}, {}};
  for (const std::string& folder : students.unmatched)
    all.unmatched.push_back(printable_name(folder));
  for (const Exercise& exercise : assignment.exercises) all.exercises.push_back(exercise.name);
  auto job = jobs.begin();
  for (const Participant& one : students.all) {
    const Instant end = due(course, assignment, one.member.key);
    StudentMarks row{printable_name(one.member.key),
                     printable_name(one.member.name),
                     one.folder ? printable_name(one.folder->name) : "",
                     {}};
    for (const Exercise& exercise : assignment.exercises) {
      row.marks.push_back(missing(exercise, end, course.zone, all.unmatched.empty()));
      if (!one.folder) continue;
      Mark& mark = row.marks.back() = mark_of(exercise);
      mark.asked = job->asked;
      if (mark.asked) {
        add_grade(mark, *job, seed);
        const auto at = has(*one.folder, exercise) ? handed_in_at(one, exercise) : std::nullopt;
        add_lateness(mark, at, end, assignment, course.zone);
      }
      ++job;
    }
    all.students.push_back(row);
  }
  return all;
}

}  // namespace grade
