// SPDX-License-Identifier: MIT-0
/// @file
/// The end of a program, from its wait status and what bubblewrap says.
#pragma once
#include "process.h"

namespace cage {

/// Fills in how the program ended and its code; its processor time must already be known.
///
/// @param status  as wait gives it
/// @param status_text  what bubblewrap said of the program; null if it was started without
void decode_status(Ended& ended, int status, const Limits& limits, const std::string* status_text);

}  // namespace cage
