// SPDX-License-Identifier: MIT-0
#include "course/round.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>
#include <system_error>

#include "class/class.h"
#include "class/job.h"
#include "class/print_some.h"
#include "command_line.h"
#include "course/handed_in_at.h"
#include "course/marks.h"
#include "course/student_page.h"
#include "course/write_equal.h"
#include "course/zip.h"
#include "exit_codes.h"
#include "format_values.h"
#include "given_files.h"
#include "hosts/store.h"
#include "hosts/times.h"
#include "printable.h"
#include "report/files.h"

namespace grade {
namespace {

/// @throws NotOwn  a link or the like stands in the place of a file of the round
void refuse_foreign_round(const std::filesystem::path& results) {
  if (no_folder(results)) throw NotOwn(results);
  for (const char* name : {"marks.json", "late.csv", "equal.csv", "pages.zip"})
    if (no_file(results / name)) throw NotOwn(results / name);
  if (no_folder(results / "pages")) throw NotOwn(results / "pages");
}

std::string folder_of(const Assignment& assignment) {
  return "'" + printable_name(assignment.submissions.string()) + "'";
}

/// What a table of times does not say is not guessed.
void check_times(const Course& course, const Assignment& assignment, const Participants& students,
                 const HandedInAt& handed_in_at) {
  for (const Participant& one : students.all) {
    for (const Exercise& exercise : assignment.exercises) {
      if (!one.folder || !has(*one.folder, exercise) || handed_in_at(one, exercise)) continue;
      throw Usage(printable_name(table_of_times(course, assignment).string()) + ": when did '" +
                  printable_name(one.member.key) + "' hand in " + exercise.name +
                  "? Fill it in, in a line with student, exercise and time; or write  times = "
                  "\"files\"  in the course, where the files' own times are those");
    }
  }
}

/// @throws Usage  these are no students' folders, but the submissions of rounds
void refuse_collections(const std::vector<Student>& folders, const Assignment& assignment) {
  for (const Student& one : folders) {
    if (!is_collection(one.folder)) continue;
    throw Usage(
        folder_of(assignment) + " holds '" + printable_name(one.name) +
        "', which grade collect made, and not the folders of students; write  submissions = "
        "\"" +
        printable_name(one.folder.string()) + "\"  in its [[assignment]]");
  }
}

/// Where there is no roster that knew better.
void print_unused_extensions(const Course& course, const Assignment& assignment,
                             const Participants& students) {
  std::vector<std::string> names;
  for (const Extension& one : course.extensions) {
    const bool known = std::ranges::any_of(
        students.all, [&](const Participant& other) { return other.member.key == one.student; });
    if (one.assignment == assignment.name && !known) names.push_back(one.student);
  }
  print_some("An extension of nobody who has a folder", names);
}

Class class_of(const Course& course, const Assignment& assignment, const Participants& students,
               const CourseWork& asked) {
  std::map<std::string, bool> due_by_folder;
  for (const Participant& one : students.all)
    if (one.folder)
      due_by_folder[one.folder->name] = now() > due(course, assignment, one.member.key);
  Class work;
  work.submissions = assignment.submissions;
  work.results = course.results / assignment.name;
  work.assigned = assignment.exercises;
  work.seed_file = assignment.seed_file;
  if (!work.seed_file.empty()) work.seed = seed_in(work.seed_file);
  work.jobs = asked.jobs;
  work.shard = asked.shard;
  work.round = course.name + ", " + assignment.name;
  work.takes_part = [=](const Student& student) { return due_by_folder.contains(student.name); };
  work.is_due = [=](const Student& student) { return due_by_folder.at(student.name); };
  return work;
}

/// Folder by folder, in the order of those who take part.
std::vector<Job> jobs_of(const Class& work, const Participants& students) {
  std::vector<Student> folders;
  for (const Participant& one : students.all)
    if (one.folder) folders.push_back(*one.folder);
  return all_jobs(work, folders, work.assigned);
}

/// A page for each student who has a folder, and an archive of all of them by the names of these
/// folders, for whoever sends each folder back to where it came from.
void write_pages(const Course& course, const Participants& students, const Marks& marks,
                 const std::vector<Job>& jobs, const std::filesystem::path& results) {
  std::vector<ZipFile> archive;
  std::filesystem::create_directories(results / "pages");
  auto job = jobs.begin();
  for (std::size_t s = 0; s < students.all.size(); ++s) {
    const Participant& one = students.all[s];
    if (!one.folder) continue;
    std::vector<PageExercise> exercises;
    for (const Mark& mark : marks.students[s].marks) {
      exercises.push_back({mark, kept_report(*job), job->out});
      ++job;
    }
    const std::string called = one.member.name.empty() ? one.member.key : one.member.name;
    const std::string page = student_page(
        {course.name, marks.assignment, printable_name(called), course.show_seed}, exercises);
    write_whole(results / "pages" / page_name(one.member.key), page);
    archive.push_back({one.folder->name + "/feedback.html", page});
  }
  write_whole(results / "pages.zip", zip(archive));
}

void write_round(const Course& course, const Assignment& assignment, const Class& work,
                 const Participants& students, const HandedInAt& handed_in_at) {
  const std::vector<Job> jobs = jobs_of(work, students);
  const Marks marks = marks_of(course, assignment, students, jobs, work.seed, handed_in_at);
  std::filesystem::create_directories(work.results);
  write_whole(work.results / "late.csv", late_csv(marks));
  write_equal(work, students, jobs);
  write_pages(course, students, marks, jobs, work.results);
  write_whole(marks_file(course, assignment), marks_json(marks));
}

/// What is somebody's and nobody's at once may be anybody's.
int refuse_unmatched(const Course& course, const std::vector<std::string>& folders) {
  print_some("Not graded, since on no line of the roster", folders);
  return refuse(Exit::bad_input,
                counted(folders.size(), "folder") +
                    " of nobody on the roster; so whoever has no folder has no mark, and not 0. "
                    "Collect Moodle's with --worksheet, or call them by the roster's keys, or name "
                    "them in " +
                    printable_name(course.file.string()) + " by  guests = [\"FOLDER\"]");
}

}  // namespace

std::filesystem::path marks_file(const Course& course, const Assignment& assignment) {
  return course.results / assignment.name / "marks.json";
}

int grade_round(const Course& course, const Assignment& assignment,
                const std::optional<std::vector<Member>>& roster, const CourseWork& asked) {
  refuse_foreign_round(course.results / assignment.name);
  ClassList list;
  try {
    list = read_students(assignment.submissions);
  } catch (const std::filesystem::filesystem_error& error) {
    if (!asked.round.empty() || error.code() != std::errc::no_such_file_or_directory)
      return refuse(Exit::unreadable, assignment.name + ": can't read the folder " +
                                          folder_of(assignment) + ": " + error.code().message() +
                                          "; collect into it, or name another in " +
                                          printable_name(course.file.string()));
    std::printf("%s: nothing is collected yet, since there is no folder %s\n",
                assignment.name.c_str(), folder_of(assignment).c_str());
    return Exit::graded;
  }
  refuse_collections(list.students, assignment);
  const Participants students =
      roster ? match(*roster, list.students, people_in(assignment.submissions / people_table),
                     course.guests)
             : with_folders(list.students);
  const HandedInAt handed_in_at = times_of(course, assignment);
  if (!table_of_times(course, assignment).empty())
    check_times(course, assignment, students, handed_in_at);
  std::printf("%s\n", assignment.name.c_str());
  print_unused_extensions(course, assignment, students);
  const Class work = class_of(course, assignment, students, asked);
  const bool anybody = std::ranges::any_of(
      students.all, [](const Participant& one) { return one.folder.has_value(); });
  const int code = anybody ? grade_class(work) : int(Exit::graded);
  if (code == Exit::bad_input || code == Exit::unreadable || asked.shard.of > 1) return code;
  write_round(course, assignment, work, students, handed_in_at);
  if (students.unmatched.empty()) return code;
  return refuse_unmatched(course, students.unmatched);
}

}  // namespace grade
