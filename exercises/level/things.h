// SPDX-License-Identifier: MIT-0
/// @file
/// An hour of each of the level's things.
#pragma once
#include "part.h"

namespace level {

Hour clock_hour(judge::Student& yours, judge::Student& right);
Hour camera_hour(judge::Student& yours, judge::Student& right);
Hour spring_hour(judge::Student& yours, judge::Student& right);
Hour rope_hour(judge::Student& yours, judge::Student& right);
Hour replay_hour(judge::Student& yours, judge::Student& right);
Hour shuttle_hour(judge::Student& yours, judge::Student& right);

}  // namespace level
