// SPDX-License-Identifier: MIT-0
/// @file
/// Runs this program again and again, several at a time.
#pragma once
#include <chrono>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace grade {

struct ChildProcess {
  std::string owner;                   ///< one of an owner's runs at a time, so that others go on
  std::vector<std::string> arguments;  ///< the program's name first
  std::chrono::milliseconds limit;     ///< on the clock; then it is killed with its process group
};

/// Somebody wants this to end.
struct Interrupted : std::runtime_error {
  Interrupted() : std::runtime_error("stopped; the same command goes on from here") {}
};

/// Runs all of them in this order, but for those that wait for their owner's one before, each in a
/// process group of its own that dies with this process. May be called only where nothing else
/// starts processes.
/// @param ended  is told which of them ended, and whether it was killed at its limit
/// @throws Interrupted  at SIGINT, SIGTERM or SIGHUP, when none runs any more
void run_all(const std::vector<ChildProcess>& children, std::size_t at_a_time,
             const std::function<void(std::size_t, bool late)>& ended);

}  // namespace grade
