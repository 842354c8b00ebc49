// SPDX-License-Identifier: MIT-0
/// @file
/// Code of ours in place of a student's, called in this process.
#pragma once
#include <memory>

#include "harness/call.h"
#include "judge/program.h"

namespace judge {

/// If it crashes or never comes back, so do we.
std::unique_ptr<Program> begin_called(void (*called)(harness::Call& call));

}  // namespace judge
