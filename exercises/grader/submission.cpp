// SPDX-License-Identifier: MIT-0
#include "submission.h"

#include <fcntl.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "exercise.h"
#include "header_text.h"
#include "nearest.h"
#include "printable.h"
#include "untrusted_files.h"

namespace grade {

namespace {

namespace fs = std::filesystem;

Submission refused(const std::string& why) {
  return {{}, why, false, {}, {}, false};
}

Submission cannot_be_read(const std::string& why) {
  return {{}, why, true, {}, {}, false};
}

std::string shown(const std::string& name) {
  return printable(name, 100);
}

std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t most = 8;
  std::string list;
  for (std::size_t k = 0; k < std::min(most, names.size()); ++k)
    list += (k ? ", " : "") + shown(names[k]);
  return names.size() > most ? list + ", ..." : list;
}

/// The reason why a thing of this kind is not read; empty if it is a plain file.
std::string not_plain(const Entry& found) {
  const mode_t mode = found.about.st_mode;
  if (found.is_link()) return "is a symbolic link; hand in the file itself";
  if (found.is_folder()) return "is a folder; it should be the header itself";
  if (!found.is_regular()) return "is no regular file; hand in the header itself";
  if ((mode & (S_ISUID | S_ISGID)) != 0)
    return "has a setuid or setgid bit; take it away (chmod ug-s)";
  return {};
}

Submission read_header(const Entry& found, const std::string& name) {
  if (const std::string why = not_plain(found); !why.empty())
    return refused(shown(name) + " " + why);
  const auto content = read(found, longest + 1);
  if (!content) return cannot_be_read(shown(name) + " cannot be read: " + std::strerror(errno));
  if (const std::string why = not_a_header(*content); !why.empty())
    return refused(shown(name) + " " + why);
  return {*content, {}, false, {}, shown(name), found.about.st_nlink > 1};
}

/// Returns whether this is an exercise's header, which is graded apart.
bool is_exercise(const std::string& header) {
  return std::ranges::any_of(exercises(),
                             [&](const Exercise& one) { return one.header() == header; });
}

/// Reads the header in this folder, if it is there, and names what else is.
std::optional<Submission> read_beside_others(const Entry& folder, const std::string& header) {
  const auto found = entry(folder.file.get(), header);
  if (!found) return std::nullopt;
  Submission taken = read_header(*found, header);
  for (const std::string& name : names_in(folder))
    if (name != header && !is_exercise(name)) taken.ignored.push_back(shown(name));
  return taken;
}

std::string not_found(const Entry& folder, const std::string& chapter, const std::string& header,
                      const std::vector<std::string>& names) {
  std::string why = "there is no " + header + " here, nor " + chapter + "/" + header;
  if (names.empty()) return why + ": the folder is empty";
  const std::string near = nearest(header, names);
  const auto found = near.empty() ? std::nullopt : entry(folder.file.get(), near);
  if (found && found->is_folder()) return why + "; " + shown(near) + " is a folder, too";
  if (near.ends_with(".zip")) return why + "; unpack " + shown(near);
  if (!near.empty()) return why + "; is it " + shown(near) + "? Then name it " + header;
  return why + "; there is " + listed(names);
}

Submission read_from_folder(const Entry& folder, const std::string& chapter,
                            const std::string& header) {
  const auto below = entry(folder.file.get(), chapter);
  if (below && below->is_link())
    return refused(shown(chapter) + " is a symbolic link; hand in the folder itself");
  const bool chapters = below && below->is_folder();
  // A draft that lies above the chapters does not count where there is one in its place.
  if (chapters) {
    if (auto taken = read_beside_others(*below, header)) return *taken;
  }
  if (auto taken = read_beside_others(folder, header)) return *taken;
  std::vector<std::string> names = names_in(folder);
  if (chapters) {
    std::erase(names, chapter);
    const auto more = names_in(*below);
    names.insert(names.begin(), more.begin(), more.end());
  }
  return refused(not_found(folder, chapter, header, names));
}

}  // namespace

Submission read_submission(const fs::path& path, const std::string& chapter,
                           const std::string& header) {
  const fs::path tidy = path.has_filename() ? path : path.parent_path();
  std::string name = tidy.filename().string();
  const bool whole = name.empty() || name == "." || name == "..";
  const fs::path parent = whole ? tidy : tidy.has_parent_path() ? tidy.parent_path() : ".";
  if (whole) name = ".";
  const cage::File above(::open(parent.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
  const auto found = above ? entry(above.get(), name) : std::nullopt;
  if (!found)
    return cannot_be_read(shown(path.string()) + " cannot be read: " + std::strerror(errno));
  if (found->is_folder()) return read_from_folder(*found, chapter, header);
  return read_header(*found, name);
}

}  // namespace grade
