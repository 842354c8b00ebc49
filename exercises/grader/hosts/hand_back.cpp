// SPDX-License-Identifier: MIT-0
#include "hosts/hand_back.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <string_view>
#include <system_error>

#include "cage/process.h"
#include "class/print_some.h"
#include "command_line.h"
#include "exit_codes.h"
#include "format_values.h"
#include "hosts/filled.h"
#include "printable.h"
#include "report/files.h"

namespace grade {
namespace {

Marks marks_in(const std::filesystem::path& results) {
  const auto text = read_whole(results / "marks.json");
  if (const auto marks = text ? marks_from(*text) : std::nullopt) return *marks;
  throw Usage("there is no marks.json in '" + printable_name(results.string()) +
              "'; name the folder of a round that grade class has graded, such as results/week-2");
}

/// What nobody handed in is a zero in the table, and would be one of somebody who did.
void refuse_unmatched(const Marks& marks) {
  if (marks.unmatched.empty()) return;
  throw Usage("no marks go out while folders of this round are nobody's on the roster, such as '" +
              marks.unmatched[0] +
              "'; call them by the roster's keys, or name them in the course by  guests = "
              "[\"FOLDER\"], and grade it again");
}

Filled filled_by(const HandBack& work, const Marks& marks) {
  if (work.kind == "moodle" && work.column.empty()) return filled_worksheet(marks, work.table);
  if (work.kind == "moodle") throw Usage("--column is for Canvas; Moodle's worksheet has its own");
  if (work.kind == "canvas" && !work.column.empty())
    return filled_gradebook(marks, work.table, work.column);
  if (work.kind == "canvas")
    throw Usage("name the assignment's column of the gradebook, such as --column 'week 2 (123)'");
  throw Usage("grade hand-back knows moodle and canvas, not '" + printable_name(work.kind) + "'");
}

/// The mark that some programs begin a text with, where the table had one.
std::string byte_order_mark_of(const std::filesystem::path& file) {
  constexpr const char* mark = "\xef\xbb\xbf";
  const cage::File opened(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  char begin[3];
  const bool has = ::read(opened.get(), begin, sizeof begin) == sizeof begin &&
                   std::string_view(begin, sizeof begin) == mark;
  return has ? mark : "";
}

}  // namespace

int hand_back(const HandBack& work) {
  const Marks marks = marks_in(work.results);
  refuse_unmatched(marks);
  const Filled filled = filled_by(work, marks);
  const std::filesystem::path out = work.results / (work.kind + ".csv");
  std::error_code none;
  if (std::filesystem::equivalent(out, work.table, none))
    throw Usage("'" + printable_name(out.string()) +
                "' is what was filled in; name the table that the system exported");
  if (no_file(out)) throw NotOwn(out);
  umask(077);
  write_whole(out, byte_order_mark_of(work.table) + filled.text);
  print_some("On no line of the table", filled.nowhere);
  print_some("Without a mark, and left as it was", filled.no_mark);
  std::printf("%s of %s filled in: %s\n", counted(filled.students, "mark").c_str(),
              printable_name(marks.assignment).c_str(), printable_name(out.string()).c_str());
  return Exit::graded;
}

}  // namespace grade
