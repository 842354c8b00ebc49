// SPDX-License-Identifier: MIT-0
#include "class/running_children.h"

#include <poll.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>

#include "cage/process_tree.h"
#include "class/pool.h"

namespace grade {
namespace {

using Clock = std::chrono::steady_clock;

bool has_ended(const Running& one, int how) {
  return waitpid(one.process, nullptr, how) == one.process;
}

}  // namespace

Interruption::Interruption() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&signals, signal);
  sigprocmask(SIG_BLOCK, &signals, &before_);
  handle_ = cage::File(signalfd(-1, &signals, SFD_CLOEXEC));
}

Interruption::~Interruption() {
  sigprocmask(SIG_SETMASK, &before_, nullptr);
}

void Interruption::take() const {
  signalfd_siginfo signal;
  [[maybe_unused]] const ssize_t size = read(handle(), &signal, sizeof signal);
  throw Interrupted();
}

RunningChildren::~RunningChildren() {
  for (const Running& one : all_) kill(-one.process, SIGKILL);
  all_.clear();
  reap_orphans();
}

void RunningChildren::wait(const Interruption& interruption) const {
  std::vector<pollfd> handles{{interruption.handle(), POLLIN, 0}};
  Clock::time_point first = Clock::time_point::max();
  for (const Running& one : all_) {
    handles.push_back({one.handle.get(), POLLIN, 0});
    first = std::min(first, one.deadline);
  }
  const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(first - Clock::now());
  poll(handles.data(), handles.size(), static_cast<int>(std::max<long>(0, left.count() + 1)));
  if (handles[0].revents != 0) interruption.take();
}

std::vector<RunningChildren::Ended> RunningChildren::ended() {
  std::vector<Ended> tasks;
  std::erase_if(all_, [&](const Running& one) {
    const bool over = has_ended(one, WNOHANG), late = !over && Clock::now() >= one.deadline;
    if (late) {
      kill(-one.process, SIGKILL);
      has_ended(one, 0);
    }
    if (over || late) tasks.push_back({one.task, late});
    return over || late;
  });
  reap_orphans();
  return tasks;
}

std::vector<pid_t> RunningChildren::orphans() const {
  std::vector<pid_t> found = cage::children();
  std::erase_if(
      found, [&](pid_t child) { return std::ranges::count(all_, child, &Running::process) > 0; });
  return found;
}

// Kills and reaps them. Orphans of a task that was killed come to us, the subreaper, and when these
// are gone, theirs.
void RunningChildren::reap_orphans() const {
  for (std::vector<pid_t> others = orphans(); !others.empty(); others = orphans()) {
    for (const pid_t other : others) kill(other, SIGKILL);
    for (const pid_t other : others) waitpid(other, nullptr, 0);
  }
}

}  // namespace grade
