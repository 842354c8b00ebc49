// SPDX-License-Identifier: MIT-0
/// @file
/// Names that a browser or a system gives to a file of the same name.
#pragma once
#include <string>

namespace grade {

struct AskedName {
  std::string header;   ///< what an exercise calls it; the name itself if it is no exercise's
  unsigned number = 0;  ///< 2 of `orbit-drift (2).h`; 0 if it is called just so
};

/// The header that is meant by `orbit-drift.h`, `orbit-drift (2).h`, as browsers and Moodle call a
/// second one, or `orbit-drift-2.h`, as Canvas does.
AskedName asked_name(const std::string& file);

}  // namespace grade
