// SPDX-License-Identifier: MIT-0
/// @file
/// When something was handed in.
#pragma once
#include <filesystem>
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

/// By tables with the columns `student`, `exercise` or `assignment`, and `time`: as ISO 8601 has
/// it, with an offset, or else on the course's clocks. What the course's own table says comes
/// first, then what that of the collection does. Of several times of one thing in a table the last
/// counts; one of the exercise comes before one of the assignment; an empty one says nothing.
/// Without any table, by the times of the files.
/// @throws Usage  one can't be read, or a line of it is wrong
HandedInAt times_of(const Course& course, const Assignment& assignment);

/// The table that is to be filled in where a time is not known; empty if the files' times count.
std::filesystem::path table_of_times(const Course& course, const Assignment& assignment);

}  // namespace grade
