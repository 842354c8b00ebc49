// SPDX-License-Identifier: MIT-0
#include "class/pool.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <numeric>
#include <optional>
#include <set>
#include <system_error>

#include "cage/process_tree.h"
#include "class/running_children.h"

namespace grade {
namespace {

std::system_error failure(const char* what) {
  return {errno, std::generic_category(), what};
}

/// Becomes the grader, in the child, where nothing may be allocated any more.
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

/// The children that wait for their turn, which comes in their order, but never while their owner's
/// one before runs.
class Queue {
 public:
  explicit Queue(const std::vector<ChildProcess>& children)
      : children_(children), waiting_(children.size()) {
    std::iota(waiting_.begin(), waiting_.end(), std::size_t{0});
  }
  bool empty() const { return waiting_.empty(); }

  /// Takes out the next that may run; nothing if none may before another has ended.
  std::optional<std::size_t> next() {
    const auto found = std::ranges::find_if(
        waiting_, [&](std::size_t i) { return !busy_.contains(children_[i].owner); });
    if (found == waiting_.end()) return std::nullopt;
    const std::size_t index = *found;
    waiting_.erase(found);
    busy_.insert(children_[index].owner);
    return index;
  }

  void ended(std::size_t index) { busy_.erase(children_[index].owner); }

 private:
  const std::vector<ChildProcess>& children_;
  std::vector<std::size_t> waiting_;
  std::set<std::string> busy_;
};

}  // namespace

void run_all(const std::vector<ChildProcess>& children, std::size_t at_a_time,
             const std::function<void(std::size_t, bool)>& ended) {
  cage::become_subreaper();
  const Interruption interruption;
  RunningChildren running;
  Queue queue(children);
  while (!queue.empty() || running.size() > 0) {
    while (running.size() < at_a_time) {
      const std::optional<std::size_t> next = queue.next();
      if (!next) break;
      running.add(start(children, *next));
    }
    running.wait(interruption);
    for (const auto& [task, late] : running.ended()) {
      queue.ended(task);
      ended(task, late);
    }
  }
}

}  // namespace grade
