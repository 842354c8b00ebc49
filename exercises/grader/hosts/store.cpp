// SPDX-License-Identifier: MIT-0
#include "hosts/store.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <system_error>

#include "command_line.h"
#include "printable.h"
#include "report/files.h"

namespace grade {
namespace {

constexpr const char* part = ".part-";

std::system_error cannot_write(const std::filesystem::path& what) {
  return {errno, std::generic_category(), "can't write " + printable_name(what.string())};
}

std::vector<std::string> names_below(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& one : std::filesystem::directory_iterator(folder))
    names.push_back(one.path().filename().string());
  std::ranges::sort(names);
  return names;
}

/// Makes it ours, unless it is or holds what somebody else put there.
void claim(const std::filesystem::path& to) {
  if (no_folder(to)) throw NotOwn(to);
  std::filesystem::create_directories(to);
  if (no_file(to / collected_mark)) throw NotOwn(to / collected_mark);
  if (std::filesystem::exists(to / collected_mark)) return;
  if (!std::filesystem::is_empty(to))
    throw Usage("'" + printable_name(to.string()) +
                "' holds what was not collected; name a new folder");
  write_whole(to / collected_mark, "");
}

/// What a collector that was killed left behind.
void remove_parts(const std::filesystem::path& to) {
  for (const std::string& name : names_below(to))
    if (name.starts_with(part)) std::filesystem::remove_all(to / name);
}

void bear_time(const std::filesystem::path& file, Instant time) {
  const timespec at{time.time_since_epoch().count(), 0};
  const timespec both[] = {at, at};
  if (::utimensat(AT_FDCWD, file.c_str(), both, AT_SYMLINK_NOFOLLOW) != 0) throw cannot_write(file);
}

void write_files(const Haul& haul, const std::string& student,
                 const std::filesystem::path& folder) {
  for (const HandedFile& one : haul.files) {
    if (one.student != student) continue;
    const std::filesystem::path file = folder / one.place;
    std::filesystem::create_directories(file.parent_path());
    write_whole(file, one.text);
    bear_time(file, one.file_time);
  }
}

/// Puts the new folder in the old one's place at once.
void put_in_place(const std::filesystem::path& made, const std::filesystem::path& place) {
  if (::rename(made.c_str(), place.c_str()) == 0) return;  // it was not there, or was empty
  if (::renameat2(AT_FDCWD, made.c_str(), AT_FDCWD, place.c_str(), RENAME_EXCHANGE) != 0)
    throw cannot_write(place);
  std::filesystem::remove_all(made);
}

void store_student(const Haul& haul, const std::string& student, const std::filesystem::path& to) {
  std::string made = to / (std::string(part) + "XXXXXX");
  if (!::mkdtemp(made.data())) throw cannot_write(to);
  write_files(haul, student, made);
  put_in_place(made, to / student);
}

}  // namespace

bool is_collection(const std::filesystem::path& folder) {
  std::error_code none;
  return std::filesystem::exists(folder / collected_mark, none);
}

bool is_of_collection(const std::string& name) {
  return name == collected_mark || name == times_table || name == people_table;
}

bool is_nobodys(const std::string& name) {
  return name.starts_with('.') || is_of_collection(name);
}

std::set<std::pair<std::string, std::string>> unchanged(const Haul& haul,
                                                        const std::filesystem::path& to) {
  std::set<std::pair<std::string, std::string>> same;
  for (const HandedFile& one : haul.files)
    if (read_whole(to / one.student / one.place) == one.text) same.insert({one.student, one.place});
  return same;
}

std::vector<std::string> store(const Haul& haul, const std::filesystem::path& to) {
  claim(to);
  remove_parts(to);
  for (const std::string& student : haul.students)
    if (no_folder(to / student)) throw NotOwn(to / student);
  std::vector<std::string> others = names_below(to);
  std::erase_if(others, [&](const std::string& name) {
    return is_nobodys(name) || haul.students.contains(name);
  });
  for (const std::string& student : haul.students) store_student(haul, student, to);
  return others;
}

}  // namespace grade
