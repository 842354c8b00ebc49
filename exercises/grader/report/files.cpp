// SPDX-License-Identifier: MIT-0
#include "report/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <system_error>

#include "cage/process.h"
#include "printable.h"
#include "untrusted_files.h"

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

bool is_another(const std::filesystem::path& path, std::filesystem::file_type wanted) {
  std::error_code none;
  const auto found = std::filesystem::symlink_status(path, none);
  return std::filesystem::exists(found) && found.type() != wanted;
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

NotOwn::NotOwn(const std::filesystem::path& what)
    : std::runtime_error("'" + printable_name(what.string()) +
                         "' is not the grader's own: look at it, and take it away") {}

std::optional<std::string> read_whole(const std::filesystem::path& file, std::size_t most) {
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  const cage::File above(::open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
  const auto found = above ? entry(above.get(), file.filename().string()) : std::nullopt;
  if (!found) return std::nullopt;
  if (!found->is_regular()) throw NotOwn(file);
  auto content = read(*found, most + 1);
  if (content && content->size() > most) throw NotOwn(file);
  return content;
}

bool no_file(const std::filesystem::path& path) {
  return is_another(path, std::filesystem::file_type::regular);
}

bool no_folder(const std::filesystem::path& path) {
  return is_another(path, std::filesystem::file_type::directory);
}

}  // namespace grade
