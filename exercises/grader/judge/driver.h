// SPDX-License-Identifier: MIT-0
/// @file
/// A student's code in a driver, in its cage.
#pragma once
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "cage/cage.h"
#include "judge/program.h"

namespace judge {

/// How the drivers of a session run.
struct Caged {
  const cage::Kit& kit;
  const cage::File& driver;
  cage::Sandbox sandbox = cage::Sandbox::bubblewrap;
  cage::Build build = cage::Build::scored;
  cage::Limits limits = {};   ///< of each driver
  double longest = HUGE_VAL;  ///< for all drivers together, on the clock [s]
  std::vector<std::string> arguments = {};
};

/// Begins a driver.
/// @param caged  must live as long as the driver
std::unique_ptr<Program> begin_driver(const Caged& caged);

}  // namespace judge
