// SPDX-License-Identifier: MIT-0
#include "course/roster.h"

#include <algorithm>
#include <cctype>
#include <map>

#include "command_line.h"
#include "csv.h"
#include "hosts/moodle_name.h"
#include "nearest.h"
#include "printable.h"

namespace grade {
namespace {

std::string lower(std::string text) {
  for (char& c : text) c = char(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// A kind of table, by the columns that it has. Those that make up a name are joined by a space.
struct Kind {
  std::vector<std::string> columns;
  std::string key;
  std::vector<std::string> name;
};

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all{
      {{"student", "id", "section"}, "id", {"student"}},  // Canvas
      {{"student"}, "student", {"name"}},
      {{"first name", "last name", "email address"}, "email address", {"first name", "last name"}},
      {{"first name", "surname", "email address"}, "email address", {"first name", "surname"}},
      {{"vorname", "nachname", "e-mail-adresse"}, "e-mail-adresse", {"vorname", "nachname"}},
      {{"full name", "email address"}, "email address", {"full name"}},
  };
  return all;
}

/// The head of a roster, and what its columns are for.
class Columns {
 public:
  Columns(const CsvRow& head, const std::string& file, const std::string& key) : file_(file) {
    for (const std::string& cell : head.cells) heads_.push_back(lower(trimmed(cell)));
    const auto kind = std::ranges::find_if(kinds(), [&](const Kind& one) {
      return std::ranges::all_of(one.columns,
                                 [&](const auto& name) { return find(name).has_value(); });
    });
    if (kind != kinds().end()) kind_ = *kind;
    if (!key.empty()) kind_.key = lower(key);
    if (kind_.key.empty() && heads_.size() == 1) return;  // a name a line
    if (kind_.key.empty()) refuse_heads(head);
    if (!find(kind_.key)) refuse_key(head, key);
  }

  bool has_head() const { return !kind_.key.empty(); }
  std::string key(const CsvRow& row) const { return cell(row, kind_.key); }

  std::string name(const CsvRow& row) const {
    std::string text;
    for (const std::string& column : kind_.name) {
      const std::string part = cell(row, column);
      text += (text.empty() || part.empty() ? "" : " ") + part;
    }
    return text;
  }

  /// Canvas has a row of what could be had.
  bool is_nobody(const CsvRow& row) const {
    return kind_.name == std::vector<std::string>{"student"} && cell(row, "id").empty();
  }

 private:
  std::optional<std::size_t> find(const std::string& name) const {
    const auto found = std::ranges::find(heads_, name);
    if (found == heads_.end()) return std::nullopt;
    return std::size_t(found - heads_.begin());
  }

  std::string cell(const CsvRow& row, const std::string& column) const {
    const auto at = find(column);
    return at && *at < row.cells.size() ? trimmed(row.cells[*at]) : "";
  }

  [[noreturn]] void refuse_heads(const CsvRow& head) const {
    throw Usage(file_ + ":" + std::to_string(head.line) +
                ": which column names a student? Call it 'student', or write  roster = { file = "
                "\"...\", key = \"COLUMN\" }");
  }

  [[noreturn]] void refuse_key(const CsvRow& head, const std::string& key) const {
    const std::string near = nearest(key, head.cells);
    throw Usage(file_ + ":" + std::to_string(head.line) + ": there is no column '" +
                printable_name(key) + "'; " +
                (near.empty() ? "name one of this line" : "did you mean '" + near + "'?"));
  }

  std::string file_;
  std::vector<std::string> heads_;
  Kind kind_;
};

/// The name in a folder that Moodle made; empty if it did not.
std::string name_in(const std::string& folder) {
  const auto parts = moodle_name(folder);
  return parts && parts->kind == "file" && parts->file.empty() ? parts->name : "";
}

/// By the names that only one member has.
std::map<std::string, std::size_t> by_name(const std::vector<Member>& roster) {
  std::map<std::string, std::size_t> found, times;
  for (std::size_t i = 0; i < roster.size(); ++i) {
    const std::string name = as_moodle_writes(roster[i].name);
    if (name.empty()) continue;
    found[name] = i;
    ++times[name];
  }
  std::erase_if(found, [&](const auto& one) { return times[one.first] > 1; });
  return found;
}

/// Whose a folder is, by its place in the roster.
class Owners {
 public:
  Owners(const std::vector<Member>& roster, const std::map<std::string, Person>& people)
      : names_(by_name(roster)), people_(people) {
    for (std::size_t i = 0; i < roster.size(); ++i) {
      keys_[roster[i].key] = i;
      addresses_[lower(roster[i].key)] = i;
    }
  }

  std::optional<std::size_t> find(const std::string& folder) const {
    if (const auto found = keys_.find(folder); found != keys_.end()) return found->second;
    const auto person = people_.find(folder);
    if (person != people_.end()) {
      if (const auto id = keys_.find(person->second.id); id != keys_.end()) return id->second;
      const auto address = addresses_.find(lower(person->second.email));
      if (address != addresses_.end()) return address->second;
    }
    const auto name = names_.find(name_in(folder));
    return name == names_.end() ? std::nullopt : std::optional(name->second);
  }

 private:
  std::map<std::string, std::size_t> keys_, addresses_, names_;
  const std::map<std::string, Person>& people_;
};

}  // namespace

std::vector<Member> read_roster(const std::filesystem::path& path, const std::string& key) {
  const std::string file = printable_name(path.string());
  const std::vector<CsvRow> rows = csv_file(path);
  if (rows.empty()) throw Usage(file + ":1: this roster is empty; write a name on each line");
  const Columns columns(rows[0], file, key);
  std::vector<Member> members;
  std::map<std::string, std::size_t> lines;
  for (std::size_t i = columns.has_head() ? 1 : 0; i < rows.size(); ++i) {
    const CsvRow& row = rows[i];
    if (columns.is_nobody(row)) continue;
    const Member one{columns.has_head() ? columns.key(row) : trimmed(row.cells[0]),
                     columns.has_head() ? columns.name(row) : "", row.line};
    const std::string where = file + ":" + std::to_string(row.line) + ": ";
    if (one.key.empty())
      throw Usage(where +
                  "the cell that names the student is empty; fill it in, or name another "
                  "column by  roster = { file = \"...\", key = \"COLUMN\" }");
    const auto [before, is_new] = lines.try_emplace(one.key, row.line);
    if (!is_new)
      throw Usage(where + "'" + printable_name(one.key) + "' stands in line " +
                  std::to_string(before->second) + " already; take one away");
    members.push_back(one);
  }
  if (members.empty()) throw Usage(file + ":1: this roster names nobody below its head");
  return members;
}

Participants match(const std::vector<Member>& roster, const std::vector<Student>& folders,
                   const std::map<std::string, Person>& people,
                   const std::vector<std::string>& guests) {
  Participants found;
  for (const Member& one : roster) found.all.push_back({one, {}});
  const Owners owners(roster, people);
  for (const Student& folder : folders) {
    const auto whose = owners.find(folder.name);
    const bool guest = std::ranges::find(guests, folder.name) != guests.end();
    if (!whose && !guest) found.unmatched.push_back(folder.name);
    if (!whose) continue;
    Participant& owner = found.all[*whose];
    if (owner.folder)
      throw Usage("two folders are those of '" + printable_name(owner.member.key) + "': '" +
                  printable_name(owner.folder->name) + "' and '" + printable_name(folder.name) +
                  "'; take one away");
    owner.folder = folder;
  }
  return found;
}

Participants with_folders(const std::vector<Student>& folders) {
  Participants found;
  for (const Student& folder : folders) found.all.push_back({{folder.name, "", 0}, folder});
  return found;
}

}  // namespace grade
