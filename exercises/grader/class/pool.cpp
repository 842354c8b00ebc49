// SPDX-License-Identifier: MIT-0
#include "class/pool.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "cage/process_tree.h"
#include "class/running_children.h"

namespace grade {
namespace {

std::system_error failure(const char* what) {
  return {errno, std::generic_category(), what};
}

/// In the child, where nothing may be allocated any more.
[[noreturn]] void become(char* const* arguments, pid_t parent) {
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const int nowhere = open("/dev/null", O_RDWR);
  for (const int stream : {0, 1, 2}) dup2(nowhere, stream);
  if (getppid() == parent) execv("/proc/self/exe", arguments);
  _exit(127);
}

Running start(const std::vector<ChildProcess>& children, std::size_t index) {
  std::vector<char*> arguments;
  for (const std::string& argument : children[index].arguments) {
    arguments.push_back(const_cast<char*>(argument.c_str()));
  }
  arguments.push_back(nullptr);
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child < 0) throw failure("can't start another grader");
  if (child == 0) become(arguments.data(), parent);
  setpgid(child, child);
  cage::File handle(static_cast<int>(syscall(SYS_pidfd_open, child, 0)));
  if (!handle) throw failure("can't watch a grader");
  return {index, child, std::move(handle),
          std::chrono::steady_clock::now() + children[index].limit};
}

}  // namespace

void run_all(const std::vector<ChildProcess>& children, std::size_t at_a_time,
             const std::function<void(std::size_t, bool)>& ended) {
  cage::adopt_orphans();
  const Interruption interruption;
  RunningChildren running;
  for (std::size_t next = 0; next < children.size() || running.size() > 0;) {
    while (next < children.size() && running.size() < at_a_time)
      running.add(start(children, next++));
    running.wait(interruption);
    for (const auto& [task, late] : running.ended()) ended(task, late);
  }
}

}  // namespace grade
