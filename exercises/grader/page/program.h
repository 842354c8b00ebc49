// SPDX-License-Identifier: MIT-0
/// @file
/// A student's code as a module beside this one, which the page joins.
#pragma once
#include <memory>

#include "judge/program.h"

namespace page {

std::unique_ptr<judge::Program> begin_program();

}  // namespace page
