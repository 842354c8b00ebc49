// SPDX-License-Identifier: MIT-0
/// @file
/// Children that run beside us, and the signals that ask us to stop.
#pragma once
#include <signal.h>
#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <vector>

#include "cage/process.h"

namespace grade {

/// Turns SIGINT, SIGTERM and SIGHUP into something to wait for (a signalfd).
class Interruption {
 public:
  Interruption();
  ~Interruption();
  int handle() const { return handle_.get(); }

  /// Takes the signal away, so that it does not end this process at once.
  /// @throws Interrupted
  [[noreturn]] void take() const;

 private:
  sigset_t before_;
  cage::File handle_;
};

struct Running {
  std::size_t task;
  pid_t process;
  cage::File handle;  ///< a pidfd: becomes readable when the process ends
  std::chrono::steady_clock::time_point deadline;
};

/// The tasks that run; none does when this is gone.
class RunningChildren {
 public:
  ~RunningChildren();
  std::size_t size() const { return all_.size(); }
  void add(Running one) { all_.push_back(std::move(one)); }

  /// Waits until one of them ends or its time is over.
  /// @throws Interrupted
  void wait(const Interruption& interruption) const;

  struct Ended {
    std::size_t task;
    bool late;  ///< and therefore killed
  };

  /// Takes out those that have ended, and kills and reaps what they left behind.
  std::vector<Ended> ended();

 private:
  std::vector<pid_t> orphans() const;
  void reap_orphans() const;

  std::vector<Running> all_;
};

}  // namespace grade
