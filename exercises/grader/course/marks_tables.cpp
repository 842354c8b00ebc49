// SPDX-License-Identifier: MIT-0
#include <algorithm>
#include <map>

#include "course/marks.h"
#include "csv.h"
#include "printable.h"

namespace grade {
namespace {

std::string in_cell(std::optional<int> points) {
  return points ? std::to_string(*points) : "";
}

/// The student's marks in this assignment; null if there are none.
const StudentMarks* marks_of_student(const Marks& assignment, const std::string& student) {
  const auto found = std::ranges::find(assignment.students, student, &StudentMarks::student);
  return found == assignment.students.end() ? nullptr : &*found;
}

void add_heads(std::vector<std::string>& head, const Marks& assignment) {
  for (const std::string& exercise : assignment.exercises)
    head.push_back(assignment.assignment + " " + exercise);
  head.insert(head.end(), {assignment.assignment, assignment.assignment + " of"});
}

void add_cells(std::vector<std::string>& cells, const Marks& assignment,
               const StudentMarks* student) {
  Total total;
  for (std::size_t e = 0; e < assignment.exercises.size(); ++e) {
    const Mark mark = student ? student->marks[e] : Mark();
    cells.push_back(mark.asked ? in_cell(mark.points) : "");
    total.add(mark);
  }
  const bool has_sum = total.any && total.whole;
  cells.push_back(has_sum ? std::to_string(total.points) : "");
  cells.push_back(has_sum ? std::to_string(total.of) : "");
}

/// Of the roster first; then those who have marks and have left.
std::vector<std::pair<std::string, std::string>> rows_of(const std::vector<Marks>& assignments,
                                                         const std::vector<Member>& roster) {
  std::vector<std::pair<std::string, std::string>> rows;
  std::map<std::string, std::string> others;
  for (const Member& one : roster)
    rows.emplace_back(printable_name(one.key), printable_name(one.name));
  for (const Marks& assignment : assignments)
    for (const StudentMarks& one : assignment.students) others[one.student] = one.name;
  for (const auto& row : rows) others.erase(row.first);
  rows.insert(rows.end(), others.begin(), others.end());
  return rows;
}

}  // namespace

std::string late_csv(const Marks& marks) {
  std::string text = csv_line({"student", "name", "exercise", "due", "handed in", "late",
                               "days begun", "earned", "taken", "points", "of"});
  for (const StudentMarks& student : marks.students) {
    for (const Mark& mark : student.marks) {
      if (mark.days_late == 0) continue;
      text += csv_line({student.student, student.name, mark.exercise, mark.due, mark.handed_in,
                        duration(std::chrono::seconds(mark.seconds_late)),
                        std::to_string(mark.days_late), in_cell(mark.earned),
                        std::to_string(mark.taken), in_cell(mark.points), std::to_string(mark.of)});
    }
  }
  return text;
}

std::string grades_of_course(const std::vector<Marks>& assignments,
                             const std::vector<Member>& roster) {
  std::vector<std::string> head{"student", "name"};
  for (const Marks& one : assignments) add_heads(head, one);
  std::string text = csv_line(head);
  for (const auto& [student, name] : rows_of(assignments, roster)) {
    std::vector<std::string> cells{student, name};
    for (const Marks& one : assignments) add_cells(cells, one, marks_of_student(one, student));
    text += csv_line(cells);
  }
  return text;
}

}  // namespace grade
