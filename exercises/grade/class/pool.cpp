// SPDX-License-Identifier: MIT-0
#include "class/pool.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "cage/process.h"

namespace grade {
namespace {

using Clock = std::chrono::steady_clock;

struct Running {
  std::size_t task;
  pid_t process;
  cage::File handle;  ///< becomes readable when the process ends
  Clock::time_point deadline;
};

std::system_error failure(const char* what) {
  return {errno, std::generic_category(), what};
}

/// In the child, where nothing may be allocated any more.
[[noreturn]] void become(char* const* arguments, pid_t parent) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const int nowhere = open("/dev/null", O_RDWR);
  for (const int stream : {0, 1, 2}) dup2(nowhere, stream);
  if (getppid() == parent) execv("/proc/self/exe", arguments);
  _exit(127);
}

Running start(const std::vector<Task>& tasks, std::size_t index) {
  std::vector<char*> arguments;
  for (const std::string& argument : tasks[index].arguments) {
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
  return {index, child, std::move(handle), Clock::now() + tasks[index].limit};
}

void wait_for_one(const std::vector<Running>& running) {
  std::vector<pollfd> handles;
  Clock::time_point first = Clock::time_point::max();
  for (const Running& one : running) {
    handles.push_back({one.handle.get(), POLLIN, 0});
    first = std::min(first, one.deadline);
  }
  const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(first - Clock::now());
  poll(handles.data(), handles.size(), static_cast<int>(std::max<long>(0, left.count() + 1)));
}

/// Whether it has ended, by itself or because its time is over.
bool has_ended(const Running& one) {
  if (Clock::now() >= one.deadline) kill(-one.process, SIGKILL);
  return waitpid(one.process, nullptr, Clock::now() >= one.deadline ? 0 : WNOHANG) == one.process;
}

}  // namespace

void run_all(const std::vector<Task>& tasks, std::size_t at_a_time,
             const std::function<void(std::size_t)>& ended) {
  std::vector<Running> running;
  for (std::size_t next = 0; next < tasks.size() || !running.empty();) {
    while (next < tasks.size() && running.size() < at_a_time) {
      running.push_back(start(tasks, next++));
    }
    wait_for_one(running);
    for (std::size_t i = running.size(); i-- > 0;) {
      if (!has_ended(running[i])) continue;
      const std::size_t task = running[i].task;
      running.erase(running.begin() + static_cast<std::ptrdiff_t>(i));
      ended(task);
    }
  }
}

}  // namespace grade
