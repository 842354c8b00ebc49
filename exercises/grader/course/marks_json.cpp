// SPDX-License-Identifier: MIT-0
#include <exception>
#include <nlohmann/json.hpp>

#include "course/marks.h"

namespace grade {
namespace {

using MarksJson = nlohmann::ordered_json;

constexpr const char* marks_schema = "one-step-at-a-time/marks/v1";

MarksJson or_null(std::optional<int> number) {
  return number ? MarksJson(*number) : MarksJson();
}

std::optional<int> number_or_nothing(const MarksJson& value) {
  return value.is_null() ? std::nullopt : std::optional<int>(value.get<int>());
}

MarksJson as_json(const Mark& mark) {
  return {{"exercise", mark.exercise},
          {"asked", mark.asked},
          {"verdict", mark.verdict},
          {"earned", or_null(mark.earned)},
          {"points", or_null(mark.points)},
          {"of", mark.of},
          {"handed_in", mark.handed_in},
          {"due", mark.due},
          {"seconds_late", mark.seconds_late},
          {"days_late", mark.days_late},
          {"taken", mark.taken},
          {"late", mark.late}};
}

Mark mark_from(const MarksJson& value) {
  Mark mark;
  value.at("exercise").get_to(mark.exercise);
  value.at("asked").get_to(mark.asked);
  value.at("of").get_to(mark.of);
  mark.points = number_or_nothing(value.at("points"));
  value.at("verdict").get_to(mark.verdict);
  value.at("handed_in").get_to(mark.handed_in);
  value.at("late").get_to(mark.late);
  return mark;
}

StudentMarks student_from(const MarksJson& value) {
  StudentMarks student;
  value.at("student").get_to(student.student);
  value.at("name").get_to(student.name);
  value.at("folder").get_to(student.folder);
  for (const MarksJson& mark : value.at("marks")) student.marks.push_back(mark_from(mark));
  return student;
}

}  // namespace

std::string marks_json(const Marks& marks) {
  MarksJson all{{"schema", marks_schema},         {"course", marks.course},
                {"assignment", marks.assignment}, {"exercises", marks.exercises},
                {"unmatched", marks.unmatched},   {"students", MarksJson::array()}};
  for (const StudentMarks& one : marks.students) {
    MarksJson row{{"student", one.student},
                  {"name", one.name},
                  {"folder", one.folder},
                  {"marks", MarksJson::array()}};
    for (const Mark& mark : one.marks) row["marks"].push_back(as_json(mark));
    all["students"].push_back(row);
  }
  return all.dump(2, ' ', true, MarksJson::error_handler_t::replace) + "\n";
}

std::optional<Marks> marks_from(std::string_view json) {
  try {
    const MarksJson all = MarksJson::parse(json);
    if (all.at("schema") != marks_schema) return std::nullopt;
    Marks marks;
    all.at("assignment").get_to(marks.assignment);
    all.at("exercises").get_to(marks.exercises);
    all.at("unmatched").get_to(marks.unmatched);
    for (const MarksJson& one : all.at("students")) {
      marks.students.push_back(student_from(one));
      if (marks.students.back().marks.size() != marks.exercises.size()) return std::nullopt;
    }
    return marks;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace grade
