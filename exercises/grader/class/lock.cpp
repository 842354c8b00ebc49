// SPDX-License-Identifier: MIT-0
#include "class/lock.h"

#include <fcntl.h>
#include <sys/file.h>

#include <cerrno>
#include <iterator>
#include <system_error>

#include "printable.h"
#include "report/files.h"

namespace grade {

Lock::Lock(const std::filesystem::path& results, bool shared)
    : file_(file_in(results)), made_(std::filesystem::create_directories(results)) {
  if (no_file(file_)) throw NotOwn(file_);
  open_ = cage::File(
      ::open(file_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0600));
  held_ = open_ && ::flock(open_.get(), (shared ? LOCK_SH : LOCK_EX) | LOCK_NB) == 0;
  if (!held_ && errno != EWOULDBLOCK)
    throw std::system_error(errno, std::generic_category(),
                            "can't write " + printable_name(file_.string()));
}

Lock::~Lock() {
  std::error_code none;
  const std::filesystem::directory_iterator entries(file_.parent_path(), none);
  if (!made_ || none || std::distance(begin(entries), end(entries)) != 1) return;
  std::filesystem::remove(file_, none);
  std::filesystem::remove(file_.parent_path(), none);
}

}  // namespace grade
