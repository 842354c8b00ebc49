// SPDX-License-Identifier: MIT-0
/// @file
/// The end of a driver, as a verdict.
#pragma once
#include <cstddef>
#include <memory>

#include "cage/process.h"

namespace judge {

/// A driver of this session, in the run cage.
std::unique_ptr<cage::Process> start_driver();

/// The moment of an end: with an answer that it owed us, or with none.
enum Moment { within_answer, after_last_answer };

/// Leaves in the session what the end of a driver means; nothing if it ended as it should.
void note_ending(const cage::Ended& ended, Moment moment);

/// Leaves in the session that an answer made no sense.
void note_protocol_error();

/// Leaves in the session that an answer has another number of numbers than it should have.
void note_other_count(double came, std::size_t wanted);

}  // namespace judge
