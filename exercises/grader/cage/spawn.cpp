// SPDX-License-Identifier: MIT-0
#include "spawn.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <stdexcept>
#include <system_error>

namespace cage {

namespace {

constexpr int first_free = 32;

/// A copy above the numbers that a program is given, so that no dup2 overwrites a source.
File lifted(int descriptor) {
  File copy(::fcntl(descriptor, F_DUPFD_CLOEXEC, first_free));
  if (!copy) throw std::system_error(errno, std::generic_category(), "descriptor");
  return copy;
}

/// The actions of posix_spawn on the descriptors, in this order.
class Actions {
 public:
  Actions() { ::posix_spawn_file_actions_init(&actions_); }
  ~Actions() { ::posix_spawn_file_actions_destroy(&actions_); }
  Actions(const Actions&) = delete;
  Actions& operator=(const Actions&) = delete;

  void give(const File& from, int to) {
    ::lseek(from.get(), 0, SEEK_SET);
    ::posix_spawn_file_actions_adddup2(&actions_, from.get(), to);
  }
  void close(int descriptor) { ::posix_spawn_file_actions_addclose(&actions_, descriptor); }
  void close_from(int descriptor) {
    ::posix_spawn_file_actions_addclosefrom_np(&actions_, descriptor);
  }
  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

/// A session of its own, no signal blocked, none ignored.
class Attributes {
 public:
  Attributes() {
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    ::posix_spawnattr_init(&attributes_);
    ::posix_spawnattr_setsigmask(&attributes_, &none);
    ::posix_spawnattr_setsigdefault(&attributes_, &all);
    ::posix_spawnattr_setflags(&attributes_,
                               POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSID);
  }
  ~Attributes() { ::posix_spawnattr_destroy(&attributes_); }
  Attributes(const Attributes&) = delete;
  Attributes& operator=(const Attributes&) = delete;
  const posix_spawnattr_t* get() const { return &attributes_; }

 private:
  posix_spawnattr_t attributes_;
};

}  // namespace

Pipe open_pipe() {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0)
    throw std::system_error(errno, std::generic_category(), "pipe");
  const File read(ends[0]), write(ends[1]);
  return {lifted(read.get()), lifted(write.get())};
}

void set_nonblocking(const File& file) {
  ::fcntl(file.get(), F_SETFL, ::fcntl(file.get(), F_GETFL) | O_NONBLOCK);
}

pid_t spawn(const std::vector<std::string>& command,
            const std::vector<std::pair<int, int>>& files) {
  Actions actions;
  std::vector<File> sources;
  for (const auto& [from, to] : files) {
    if (to >= first_free) throw std::logic_error("too many files for a program");
    sources.push_back(lifted(from));
    actions.give(sources.back(), to);
  }
  for (int descriptor = 0; descriptor < first_free; ++descriptor)
    if (std::ranges::find(files, descriptor, &std::pair<int, int>::second) == files.end())
      actions.close(descriptor);
  actions.close_from(first_free);

  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  char path[] = "PATH=/usr/bin:/usr/sbin:/bin", language[] = "LC_ALL=C";
  char* environment[] = {path, language, nullptr};
  pid_t child = 0;
  const int failed = ::posix_spawnp(&child, arguments[0], actions.get(), Attributes().get(),
                                    arguments.data(), environment);
  errno = failed;
  return failed ? 0 : child;
}

}  // namespace cage
