// SPDX-License-Identifier: MIT-0
/// @file
/// An hour of each of the level's things, and its paths in the film.
#pragma once
#include "part.h"

namespace level {

Hour clock_hour(judge::Student& yours, judge::Student& right);
Hour camera_hour(judge::Student& yours, judge::Student& right);
Hour spring_hour(judge::Student& yours, judge::Student& right);
Hour rope_hour(judge::Student& yours, judge::Student& right);
Hour replay_hour(judge::Student& yours, judge::Student& right);
Hour shuttle_hour(judge::Student& yours, judge::Student& right);

Paths clock_paths(judge::Student& whose, const std::vector<double>& frames);
Paths camera_paths(judge::Student& whose, const std::vector<double>& frames);
Paths spring_paths(judge::Student& whose, const std::vector<double>& frames);
Paths rope_paths(judge::Student& whose, const std::vector<double>& frames);
Paths replay_paths(judge::Student& whose, const std::vector<double>& frames);
Paths shuttle_paths(judge::Student& whose, const std::vector<double>& frames);

}  // namespace level
