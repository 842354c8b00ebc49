// SPDX-License-Identifier: MIT-0
#include "hosts/haul.h"

#include <algorithm>
#include <map>

#include "class/students.h"
#include "exercise.h"
#include "hosts/second_try.h"

namespace grade {
namespace {

/// Far longer than any header that is graded, so that the grader itself says what is wrong with it.
constexpr std::size_t most_bytes = 1 << 20;
constexpr std::size_t most_files = 200;   // of one student
constexpr std::chrono::minutes apart(1);  // from which a time says which is later

std::string joined(const std::string& folder, const std::string& name) {
  return folder.empty() ? name : folder + "/" + name;
}

bool is_chapter(const std::string& name) {
  const auto all = exercises();
  return std::ranges::any_of(all, [&](const Exercise& one) { return one.chapter() == name; });
}

/// Why this is not taken; empty if it may be.
std::string not_a_file(const std::string& name, const Entry& found) {
  if (found.is_link()) return "is a link";
  if (found.is_folder()) return "is a folder";
  if (!found.is_regular()) return "is no file";
  if (name.ends_with(".zip")) return "is an archive: unpack it";
  if (!is_header(name)) return "is no header";
  if (std::size_t(found.about.st_size) > most_bytes) return "is longer than a megabyte";
  return "";
}

void take_headers(Haul& haul, const std::string& student, const std::string& chapter,
                  const Entry& folder) {
  const std::vector<std::string> names = names_in(folder);
  for (std::size_t i = 0; i < std::min(names.size(), most_files); ++i) {
    const auto found = entry(folder.file.get(), names[i]);
    if (!found) continue;
    const bool below = chapter.empty() && found->is_folder() && is_chapter(names[i]);
    if (!below) take_file(haul, student, chapter, names[i], *found);
  }
  if (names.size() > most_files)
    haul.not_taken.push_back(student + ": more than " + std::to_string(most_files) + " files");
}

/// Whether the first is to be taken rather than the second.
bool better(const HandedFile& one, const HandedFile& other) {
  if (one.file_time > other.file_time + apart) return true;
  if (other.file_time > one.file_time + apart) return false;
  return asked_name(one.called).number > asked_name(other.called).number;
}

std::string why_better(const HandedFile& one, const HandedFile& other) {
  const bool is_later = one.file_time > other.file_time + apart;
  return is_later ? "which is later" : "which has the highest number";
}

}  // namespace

void take_file(Haul& haul, const std::string& student, const std::string& chapter,
               const std::string& name, const Entry& file) {
  haul.students.insert(student);
  std::string why = not_a_file(name, file);
  const auto text = why.empty() ? read(file, most_bytes) : std::nullopt;
  if (why.empty() && !text) why = "can't be read";
  if (!why.empty()) {
    haul.not_taken.push_back(student + ": " + joined(chapter, name) + " " + why);
    return;
  }
  haul.files.push_back({student, joined(chapter, asked_name(name).header), name, *text,
                        Instant(std::chrono::seconds(file.about.st_mtim.tv_sec))});
}

void take_folder(Haul& haul, const std::string& student, const Entry& folder) {
  haul.students.insert(student);
  take_headers(haul, student, "", folder);
  for (const std::string& name : names_in(folder)) {
    const auto found = is_chapter(name) ? entry(folder.file.get(), name) : std::nullopt;
    if (found && found->is_folder()) take_headers(haul, student, name, *found);
  }
}

void leave_one_each(Haul& haul) {
  std::map<std::pair<std::string, std::string>, HandedFile> chosen;
  for (HandedFile& file : haul.files) {
    const auto [there, is_new] = chosen.try_emplace({file.student, file.place}, file);
    if (is_new) continue;
    HandedFile& old = there->second;
    const bool replaces = better(file, old);
    const HandedFile &one = replaces ? file : old, &other = replaces ? old : file;
    haul.notes.push_back(file.student + ": of " + one.called + " and " + other.called +
                         " the first is taken, " + why_better(one, other));
    if (replaces) old = file;
  }
  for (const auto& [where, file] : chosen)
    if (const AskedName asked = asked_name(file.called); asked.number > 0)
      haul.notes.push_back(file.student + ": " + file.called + " is taken for " + asked.header);
  haul.files.clear();
  for (auto& [where, file] : chosen) haul.files.push_back(std::move(file));
}

}  // namespace grade
