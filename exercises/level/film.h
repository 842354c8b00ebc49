// SPDX-License-Identifier: MIT-0
/// @file
/// A few seconds of the level, in uneven frames.
#pragma once
#include <vector>

#include "home/stage.h"
#include "part.h"

namespace level {

/// The frames of the film [s].
std::vector<double> film_frames();

/// A part that is shown: by the student's code, which may not be there, and by the solution's.
struct Shown {
  const Part& part;
  Paths yours, right;
};

extern const grade::View film_view;
void draw(grade::Stage& stage, const std::vector<Shown>& parts, const std::vector<double>& frames);

}  // namespace level
