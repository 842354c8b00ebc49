// SPDX-License-Identifier: MIT-0
/// @file
/// The contest for a scene of the reader's own.
#pragma once
#include "choose/contest.h"
#include "choose/own_force.h"

/// What can be asked of a scene of the reader's own alone.
struct OwnAsked {
  double metres = 0;    ///< the largest error; 0 if it is asked for as a share
  bool phases = false;  ///< whether frames begin at several moments, of which the worst counts
};

/// The contest.
/// @param force  the reader's
/// @param bounds  what is asked for; of an error in metres the share is found, and how far the
/// motion gets
/// @param asked  what else
/// @param tell  how far it has got
/// @throws std::exception  one line that says what is wrong with the scene
Contest own_contest(const OwnForce& force, Bounds& bounds, const OwnAsked& asked, const Tell& tell);
