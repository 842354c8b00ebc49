// SPDX-License-Identifier: MIT-0
/// @file
/// The contest for a scene of the reader's own.
#pragma once
#include "choose/contest.h"
#include "choose/own_force.h"

/// The contest.
/// @param force  the reader's
/// @param bounds  what is asked for; of an error in metres the share is found, and how far the
/// motion gets
/// @param metres  the largest error in metres; 0 if a share is asked for
/// @throws std::exception  one line that says what is wrong with the scene
Contest own_contest(const OwnForce& force, Bounds& bounds, double metres);
