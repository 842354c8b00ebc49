// SPDX-License-Identifier: MIT-0
#include "untrusted_files.h"

#include <dirent.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <memory>

namespace grade {

namespace {

/// Opens the very thing that is held, whatever now stands under its name.
cage::File opened(const Entry& entry, int flags) {
  const std::string path = "/proc/self/fd/" + std::to_string(entry.file.get());
  return cage::File(::open(path.c_str(), O_RDONLY | O_NOCTTY | O_NONBLOCK | O_CLOEXEC | flags));
}

}  // namespace

std::optional<Entry> entry(int folder, const std::string& name) {
  // One name at a time and no link followed: there is no way out of the folder.
  Entry found{cage::File(::openat(folder, name.c_str(), O_PATH | O_NOFOLLOW | O_CLOEXEC)), {}};
  if (!found.file || ::fstat(found.file.get(), &found.about) != 0) return std::nullopt;
  return found;
}

std::vector<std::string> names_in(const Entry& folder, std::size_t most) {
  const cage::File file = opened(folder, O_DIRECTORY);
  const std::unique_ptr<DIR, int (*)(DIR*)> stream(::fdopendir(::dup(file.get())), ::closedir);
  std::vector<std::string> names;
  while (stream && names.size() < most) {
    const dirent* next = ::readdir(stream.get());
    if (!next) break;
    const std::string name = next->d_name;
    if (name != "." && name != "..") names.push_back(name);
  }
  std::ranges::sort(names);
  return names;
}

std::optional<std::string> read(const Entry& entry, std::size_t most) {
  constexpr std::size_t piece = 1 << 16;
  const cage::File file = opened(entry, 0);
  if (!file) return std::nullopt;
  std::string content;
  std::size_t size = 0;
  while (size < most) {
    content.resize(std::min(most, size + piece));
    const ssize_t got = ::read(file.get(), content.data() + size, content.size() - size);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return std::nullopt;
    if (got == 0) break;
    size += static_cast<std::size_t>(got);
  }
  content.resize(size);
  return content;
}

}  // namespace grade
