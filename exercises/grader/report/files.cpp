// SPDX-License-Identifier: MIT-0
#include "report/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <system_error>

#include "cage/process.h"
#include "report/escape.h"

namespace grade {
namespace {

std::system_error failure(const std::filesystem::path& file) {
  return {errno, std::generic_category(), "can't write " + printable_name(file.string())};
}

mode_t usual_mode() {
  const mode_t mask = umask(0);
  umask(mask);
  return 0666 & ~mask;
}

bool write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = write(descriptor, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

}  // namespace

void write_whole(const std::filesystem::path& file, std::string_view text) {
  std::string beside = (file.parent_path() / ".part-XXXXXX").string();
  const cage::File part(mkostemp(beside.data(), O_CLOEXEC));
  if (!part) throw failure(file);
  const bool whole = write_all(part.get(), text) && fchmod(part.get(), usual_mode()) == 0 &&
                     fsync(part.get()) == 0 && rename(beside.c_str(), file.c_str()) == 0;
  if (whole) return;
  const std::system_error problem = failure(file);
  unlink(beside.c_str());
  throw problem;
}

std::optional<std::string> read_whole(const std::filesystem::path& file) {
  std::error_code none;
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file, none)) return std::nullopt;
  return std::string{std::istreambuf_iterator<char>(in), {}};
}

}  // namespace grade
