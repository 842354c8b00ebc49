// SPDX-License-Identifier: MIT-0
/// @file
/// When something was handed in.
#pragma once
#include <functional>
#include <optional>
#include <string>

#include "course/course.h"
#include "course/roster.h"

namespace grade {

/// Says when a student handed in an exercise; nothing if nobody knows. Never asks the submission's
/// own text.
using HandedInAt =
    std::function<std::optional<Instant>(const Participant& student, const Exercise& exercise)>;

/// By the times of the files, which are the submitting system's where the archive was unpacked
/// with them, and the student's own where they were copied from the student's disk.
std::optional<Instant> time_of_file(const Participant& student, const Exercise& exercise);

/// By a table with the columns `student`, `exercise` or `assignment`, and `time`: as ISO 8601 has
/// it, with an offset, or else on the course's clocks. Of several times of one thing the last
/// counts; one of the exercise comes before one of the assignment.
/// @throws Usage  it can't be read, or a line of it is wrong
HandedInAt times_in(const Course& course, const Assignment& assignment);

/// As the course has it.
HandedInAt times_of(const Course& course, const Assignment& assignment);

}  // namespace grade
