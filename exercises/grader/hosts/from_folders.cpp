// SPDX-License-Identifier: MIT-0
#include <fcntl.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "command_line.h"
#include "hosts/canvas_name.h"
#include "hosts/from.h"
#include "hosts/moodle_name.h"
#include "hosts/store.h"
#include "printable.h"

namespace grade {
namespace {

constexpr std::size_t most_entries = 100'000;

/// Each thing in the folder that is not hidden, nor called as a table of a collection.
template <class Take>
void for_each_in(const std::filesystem::path& from, const Take& take) {
  const Entry all = folder_named(from);
  for (const std::string& name : names_in(all, most_entries)) {
    const auto found = is_nobodys(name) ? std::nullopt : entry(all.file.get(), name);
    if (found) take(name, *found);
  }
}

}  // namespace

Entry folder_named(const std::filesystem::path& path) {
  const std::string shown = "'" + printable_name(path.string()) + "'";
  if (path.extension() == ".zip")
    throw Usage(shown + " is an archive; unpack it, and name the folder");
  const cage::File file(::open(path.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
  if (!file) throw Usage("can't read the folder " + shown + ": " + std::strerror(errno));
  return *entry(file.get(), ".");
}

Haul from_moodle(const std::filesystem::path& from) {
  Haul haul;
  for_each_in(from, [&](const std::string& name, const Entry& found) {
    const auto parts = moodle_name(name);
    if (!parts || parts->file.empty() != found.is_folder()) {
      haul.not_taken.push_back(name + ": it is not called as Moodle calls what was handed in");
    } else if (parts->kind != "file") {
      haul.not_taken.push_back(name + ": only files are taken");
    } else if (found.is_folder()) {
      take_folder(haul, name, found);
    } else {
      take_file(haul, parts->folder(), "", parts->file, found);
    }
  });
  return haul;
}

Haul from_canvas(const std::filesystem::path& from) {
  Haul haul;
  for_each_in(from, [&](const std::string& name, const Entry& found) {
    const CanvasName parts = canvas_name(name);
    if (!parts.why_not.empty()) {
      haul.not_taken.push_back(name + ": " + parts.why_not);
      return;
    }
    take_file(haul, parts.student, "", parts.file, found);
    if (parts.late) haul.late.insert(parts.student);
  });
  return haul;
}

Haul from_folders(const std::filesystem::path& from) {
  Haul haul;
  for_each_in(from, [&](const std::string& name, const Entry& found) {
    if (found.is_folder()) {
      take_folder(haul, name, found);
    } else {
      haul.not_taken.push_back(name + ": it is not a student's folder");
    }
  });
  return haul;
}

}  // namespace grade
