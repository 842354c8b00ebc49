// SPDX-License-Identifier: MIT-0
#pragma once

namespace grade {

/// Makes what the compiler of this machine has to make, once, and says so; nothing if it is made.
/// @throws Usage  there is no compiler
void make_ready();

}  // namespace grade
