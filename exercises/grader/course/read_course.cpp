// SPDX-License-Identifier: MIT-0
#include <algorithm>
#include <cctype>

#include "command_line.h"
#include "course/course.h"
#include "course/toml_table.h"
#include "given_files.h"
#include "nearest.h"
#include "printable.h"

namespace grade {
namespace {

namespace fs = std::filesystem;

/// What is common to all assignments while the file is read.
struct Reading {
  std::string file;  ///< as messages have it
  Course course;
  std::optional<LateRule> late;
  std::optional<fs::path> submissions;
};

fs::path beside(const Course& course, const std::string& name) {
  return (course.file.parent_path() / name).lexically_normal();
}

std::optional<LateRule> late_rule(const TomlTable& above, const std::string& file) {
  const toml::table* const table = above.table("late");
  if (!table) return std::nullopt;
  const TomlTable rule(*table, file, {"grace_minutes", "points_a_day", "days"});
  return LateRule{std::chrono::minutes(rule.whole("grace_minutes", 0, 24 * 60).value_or(0)),
                  rule.whole("points_a_day", 0, 1000).value_or(0), rule.whole("days", 0, 366)};
}

/// It becomes the name of a folder.
void check_name(const TomlTable& table, const std::string& name) {
  const auto plain = [](unsigned char c) {
    return std::isalnum(c) != 0 || std::string_view("._-").find(char(c)) != std::string_view::npos;
  };
  constexpr std::size_t longest_name = 100;
  if (name.size() > longest_name || !std::ranges::all_of(name, plain) || name[0] == '.' ||
      name[0] == '-')
    table.refuse("name",
                 "an assignment's name becomes a folder: take letters, digits and . _ - alone, "
                 "such as \"week-2\"");
  if (name == "grades.csv") table.refuse("name", "a table is called grades.csv; take another name");
}

/// In the book's order, whatever the file's.
std::vector<Exercise> exercises_in(const TomlTable& table) {
  const std::vector<std::string> names = table.needed_texts("exercises");
  for (const std::string& name : names) {
    if (!exercise(name))
      table.refuse("exercises", "there is no exercise '" + printable_name(name) +
                                    "'; did you mean '" + nearest_exercise(name) + "'?");
  }
  std::vector<Exercise> all = exercises();
  std::erase_if(
      all, [&](const Exercise& one) { return std::ranges::find(names, one.name) == names.end(); });
  return all;
}

fs::path submissions_of(const TomlTable& table, const Reading& reading) {
  if (const auto own = table.text("submissions")) return beside(reading.course, *own);
  if (reading.submissions) return *reading.submissions;
  table.refuse("submissions",
               "where are this assignment's submissions? Write submissions = \"...\" here or above "
               "all assignments");
}

void add_assignment(Reading& reading, const toml::table& written) {
  const TomlTable table(written, reading.file,
                        {"name", "exercises", "opens", "due", "seed_file", "submissions", "late"});
  Course& course = reading.course;
  Assignment one;
  one.name = table.needed_text("name");
  check_name(table, one.name);
  if (std::ranges::find(course.assignments, one.name, &Assignment::name) !=
      course.assignments.end())
    table.refuse("name", "'" + one.name + "' is another assignment's name already; take another");
  one.exercises = exercises_in(table);
  one.opens = table.time("opens", course.zone, false);
  one.due = table.needed_time("due", course.zone);
  if (one.opens && *one.opens >= one.due)
    table.refuse("due", "this is due before it opens, on " + shown(course.zone.local(*one.opens)) +
                            "; name a later time");
  if (const auto seed_file = table.text("seed_file")) {
    one.seed_file = beside(course, *seed_file);
    if (!small_file(one.seed_file))
      table.refuse("seed_file",
                   "can't read the seed file '" + printable_name(one.seed_file.string()) +
                       "'; make one by  od -An -N8 -tu8 /dev/urandom | tr -d ' ' > FILE");
  }
  one.submissions = submissions_of(table, reading);
  if (lies_within(course.results, one.submissions))
    table.refuse("submissions",
                 "'results' lies within these submissions; name a folder beside them");
  one.late = table.has("late") ? late_rule(table, reading.file) : reading.late;
  course.assignments.push_back(one);
}

std::vector<std::string> assignment_names(const Course& course) {
  std::vector<std::string> names;
  for (const Assignment& one : course.assignments) names.push_back(one.name);
  return names;
}

std::string no_assignment(const Course& course, const std::string& name) {
  const std::string near = nearest(name, assignment_names(course));
  return "there is no assignment '" + printable_name(name) + "'; did you mean '" +
         (near.empty() ? course.assignments.front().name : near) + "'?";
}

void add_extension(Reading& reading, const toml::table& written) {
  const TomlTable table(written, reading.file, {"student", "assignment", "due"});
  Course& course = reading.course;
  Extension one{table.needed_text("student"), table.needed_text("assignment"),
                table.needed_time("due", course.zone), table.place()};
  const auto extended = std::ranges::find(course.assignments, one.assignment, &Assignment::name);
  if (extended == course.assignments.end())
    table.refuse("assignment", no_assignment(course, one.assignment));
  if (one.due <= extended->due)
    table.refuse("due", "this is no extension, since all have until " +
                            shown(course.zone.local(extended->due)) + "; name a later time");
  const bool twice = std::ranges::any_of(course.extensions, [&](const Extension& other) {
    return other.student == one.student && other.assignment == one.assignment;
  });
  if (twice)
    table.refuse("student", "'" + printable_name(one.student) + "' has an extension of " +
                                one.assignment + " already; take one away");
  course.extensions.push_back(one);
}

void read_roster(Course& course, const TomlTable& table, const std::string& file) {
  if (!table.has("roster")) return;
  if (const toml::table* const details =
          table.is_table("roster") ? table.table("roster") : nullptr) {
    const TomlTable roster(*details, file, {"file", "key"});
    course.roster = beside(course, roster.needed_text("file"));
    course.key = roster.text("key").value_or("");
  } else {
    course.roster = beside(course, *table.text("roster"));
  }
}

void read_whole_course(Reading& reading, const toml::table& written) {
  const TomlTable table(written, reading.file,
                        {"name", "time_zone", "roster", "guests", "submissions", "results", "times",
                         "show_seed", "late", "assignment", "extension"});
  Course& course = reading.course;
  course.name = table.needed_text("name");
  const std::string zone = table.needed_text("time_zone");
  try {
    course.zone = TimeZone(zone);
  } catch (const Usage& problem) {
    table.refuse("time_zone", problem.what());
  }
  read_roster(course, table, reading.file);
  course.results = beside(course, table.needed_text("results"));
  if (table.has("guests")) course.guests = table.needed_texts("guests");
  const auto times = table.text("times");
  course.times_of_files = times == "files";
  if (times && !course.times_of_files) course.times = beside(course, *times);
  course.show_seed = table.yes_or_no("show_seed").value_or(true);
  reading.late = late_rule(table, reading.file);
  if (const auto submissions = table.text("submissions"))
    reading.submissions = beside(course, *submissions);
  for (const toml::table* one : table.tables("assignment")) add_assignment(reading, *one);
  if (course.assignments.empty())
    table.refuse("assignment", "no assignment stands here; begin one with a line [[assignment]]");
  for (const toml::table* one : table.tables("extension")) add_extension(reading, *one);
}

/// The parser's words in one line, without its own remark on where.
std::string said(const toml::parse_error& problem) {
  std::string text = printable(problem.description());
  std::ranges::replace(text, '\n', ' ');
  return text;
}

}  // namespace

Course read_course(const fs::path& file) {
  const auto text = small_file(file);
  if (!text)
    throw Usage("can't read '" + printable_name(file.string()) +
                "'; name the file that describes the course");
  Reading reading{printable_name(file.string()), {}, {}, {}};
  reading.course.file = file;
  try {
    read_whole_course(reading, toml::parse(*text));
  } catch (const toml::parse_error& problem) {
    throw Usage(toml_place(reading.file, problem.source()) + ": this is no TOML: " + said(problem));
  }
  return reading.course;
}

const Assignment& assignment_named(const Course& course, const std::string& name) {
  const auto found = std::ranges::find(course.assignments, name, &Assignment::name);
  if (found == course.assignments.end())
    throw Usage(printable_name(course.file.string()) + ": " + no_assignment(course, name));
  return *found;
}

Instant due(const Course& course, const Assignment& assignment, const std::string& student) {
  for (const Extension& one : course.extensions)
    if (one.student == student && one.assignment == assignment.name) return one.due;
  return assignment.due;
}

std::optional<Instant> last_moment(const Course& course, const Assignment& assignment,
                                   const std::string& student) {
  if (!assignment.late || !assignment.late->days) return std::nullopt;
  const Instant end = due(course, assignment, student);
  const std::chrono::days days(*assignment.late->days);
  return std::max(end + assignment.late->grace, course.zone.latest(course.zone.local(end) + days));
}

}  // namespace grade
