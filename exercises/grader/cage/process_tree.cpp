// SPDX-License-Identifier: MIT-0
#include "process_tree.h"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace cage {

namespace {

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

void wait_for(pid_t child, pid_t program, Reaped& reaped) {
  int status = 0;
  rusage used{};
  pid_t done;
  do done = ::wait4(child, &status, 0, &used);
  while (done < 0 && errno == EINTR);
  if (done != child) return;
  if (child == program) reaped.status = status;
  reaped.processor += seconds(used.ru_utime) + seconds(used.ru_stime);
  reaped.peak_kilobytes = std::max(reaped.peak_kilobytes, used.ru_maxrss);
}

}  // namespace

void become_subreaper() {
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);
  ::signal(SIGCHLD, SIG_DFL);  // ignored, as some parents leave it, the kernel would wait for us
}

std::vector<pid_t> children() {
  std::vector<pid_t> found;
  std::error_code gone;
  for (const auto& thread : std::filesystem::directory_iterator("/proc/self/task", gone)) {
    std::ifstream list(thread.path() / "children");
    for (pid_t child; list >> child;) found.push_back(child);
  }
  return found;
}

Reaped kill_and_reap(pid_t program, const std::vector<pid_t>& others) {
  Reaped reaped;
  std::vector<pid_t> left = {program};
  while (!left.empty()) {
    for (const pid_t child : left) ::kill(child, SIGKILL);
    for (const pid_t child : left) wait_for(child, program, reaped);
    left = children();
    std::erase_if(left, [&](pid_t child) { return std::ranges::count(others, child) > 0; });
  }
  return reaped;
}

}  // namespace cage
