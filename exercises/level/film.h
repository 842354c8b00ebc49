// SPDX-License-Identifier: MIT-0
/// @file
/// A few seconds of the level, in uneven frames.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "home/stage.h"
#include "part.h"

namespace level {

/// The places of a thing's points in each frame, in the picture.
using Paths = std::vector<std::vector<Vec>>;

/// The frames of the film [s].
std::vector<double> film_frames();

/// Where a part's points are in each frame, by somebody's code.
Paths paths(const std::string& exercise, judge::Student& whose, const std::vector<double>& frames);

/// A part that is shown: by the student's code, which may not be there, and by the solution's.
struct Shown {
  std::string exercise, name;
  Paths yours, right;
};

extern const grade::View film_view;
void draw(grade::Stage& stage, const std::vector<Shown>& parts, const std::vector<double>& frames);

}  // namespace level
