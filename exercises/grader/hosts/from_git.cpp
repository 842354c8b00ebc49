// SPDX-License-Identifier: MIT-0
#include <algorithm>
#include <cstdlib>
#include <set>
#include <system_error>

#include "command_line.h"
#include "csv.h"
#include "exercise.h"
#include "hosts/from.h"
#include "hosts/git.h"
#include "hosts/store.h"
#include "hosts/times.h"
#include "printable.h"

namespace grade {
namespace {

constexpr std::size_t most_of_a_header = 1 << 20;

std::set<std::string> chapters() {
  std::set<std::string> all;
  for (const Exercise& one : exercises()) all.insert(one.chapter());
  return all;
}

/// Why this is not taken; empty if it may be. A tree that nobody's git has made may have any name.
std::string why_not_taken(const GitEntry& one) {
  if (one.name.find('/') != one.name.npos) return "has a name that no file has";
  if (one.mode == "120000") return "is a link";
  if (one.mode == "040000") return "is a folder";
  return one.mode == "100644" || one.mode == "100755" ? "" : "is no file";
}

/// Takes the headers in a folder of a commit, under the names that they have there.
void take_from_commit(Haul& haul, const std::string& student, const GitObjects& objects,
                      const std::string& commit, const std::string& chapter) {
  for (const GitEntry& one : objects.entries(commit, chapter)) {
    const std::string place = chapter.empty() ? one.name : chapter + "/" + one.name;
    if (!one.name.ends_with(".h")) continue;
    std::string why = why_not_taken(one);
    const auto text = why.empty() ? objects.file(one.hash, most_of_a_header) : std::nullopt;
    if (why.empty() && !text) why = "is longer than a megabyte";
    if (why.empty()) {
      const Instant time = objects.changed(commit, place);
      haul.files.push_back({student, place, one.name, *text, time, as_written(time)});
    } else {
      haul.not_taken.push_back(student + ": " + place + " " + why);
    }
  }
}

void take_repository(Haul& haul, const std::string& student, const Entry& folder,
                     const Until& until) {
  haul.students.insert(student);
  try {
    const GitObjects objects(folder);
    const std::string commit = objects.commit(until(student));
    if (commit.empty()) {
      haul.not_taken.push_back(student + ": there is no commit by then");
      return;
    }
    haul.notes.push_back(student + ": commit " + commit.substr(0, 10) + " of " +
                         as_written(objects.time_of(commit)));
    take_from_commit(haul, student, objects, commit, "");
    for (const GitEntry& one : objects.entries(commit, ""))
      if (one.mode == "040000" && chapters().contains(one.name))
        take_from_commit(haul, student, objects, commit, one.name);
  } catch (const Usage& problem) {
    haul.not_taken.push_back(student + ": " + problem.what());
  }
}

/// A folder of a clone that goes when it is read.
class CloneFolder {
 public:
  CloneFolder() : path_((std::filesystem::temp_directory_path() / "clone-XXXXXX").string()) {
    if (!::mkdtemp(path_.data())) throw std::system_error(errno, std::generic_category(), path_);
  }
  ~CloneFolder() {
    std::error_code left;
    std::filesystem::remove_all(path_, left);
  }
  CloneFolder(const CloneFolder&) = delete;
  CloneFolder& operator=(const CloneFolder&) = delete;
  std::filesystem::path path() const { return path_; }

 private:
  std::string path_;
};

void take_address(Haul& haul, const std::string& student, const std::string& address,
                  const std::filesystem::path& table, const Until& until) {
  const std::filesystem::path here = table.parent_path() / address;
  if (std::filesystem::is_directory(here)) {
    take_repository(haul, student, folder_named(here), until);
    return;
  }
  const CloneFolder folder;
  const std::filesystem::path clone = folder.path() / "clone";
  if (const std::string why = git_clone(address, clone); !why.empty()) {
    haul.not_taken.push_back(student + ": " + why);
    return;
  }
  take_repository(haul, student, folder_named(clone), until);
}

[[noreturn]] void refuse_row(const std::filesystem::path& table, const CsvRow& row,
                             const std::string& why) {
  throw Usage(printable_name(table.string()) + ":" + std::to_string(row.line) + ": " + why);
}

Haul from_table_of_repositories(const std::filesystem::path& table, const Until& until) {
  Haul haul;
  const std::vector<CsvRow> rows = csv_file(table);
  const std::vector<std::string> heads{"student", "repository"};
  if (rows.empty() || rows[0].cells != heads)
    throw Usage(printable_name(table.string()) +
                ":1: the columns of such a table are student and repository; name them in its "
                "first line");
  for (std::size_t i = 1; i < rows.size(); ++i) {
    std::vector<std::string> cells = rows[i].cells;
    cells.resize(heads.size());
    const std::string student = trimmed(cells[0]), address = trimmed(cells[1]);
    if (student.empty() || is_nobodys(student) || student.find('/') != student.npos)
      refuse_row(table, rows[i], "a folder can't be called '" + printable_name(student) + "'");
    if (address.empty() || address.starts_with('-'))
      refuse_row(table, rows[i], "where is the repository? Write its address, or its folder");
    if (haul.students.contains(student))
      refuse_row(table, rows[i], "'" + printable_name(student) + "' has a line already");
    take_address(haul, student, address, table, until);
  }
  return haul;
}

}  // namespace

Haul from_git(const std::filesystem::path& from, const Until& until) {
  if (!std::filesystem::is_directory(from)) return from_table_of_repositories(from, until);
  Haul haul;
  const Entry all = folder_named(from);
  for (const std::string& name : names_in(all, 100'000)) {
    const auto found = is_nobodys(name) ? std::nullopt : entry(all.file.get(), name);
    if (!found) continue;
    const bool bare = name.ends_with(".git");
    const std::string student = bare ? name.substr(0, name.size() - 4) : name;
    if (found->is_folder()) {
      take_repository(haul, student, *found, until);
    } else {
      haul.not_taken.push_back(name + ": it is not a student's folder");
    }
  }
  return haul;
}

}  // namespace grade
