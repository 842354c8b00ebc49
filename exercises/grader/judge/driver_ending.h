// SPDX-License-Identifier: MIT-0
/// @file
/// The end of a driver, as a verdict.
#pragma once
#include "cage/process.h"

namespace judge {

/// The moment of an end: with an answer that it owed us, or with none.
enum Moment { within_answer, after_last_answer };

/// Leaves in the session what the end of a driver means; nothing if it ended as it should.
/// @param limits  that it had
void note_ending(const cage::Ended& ended, Moment moment, const cage::Limits& limits);

}  // namespace judge
