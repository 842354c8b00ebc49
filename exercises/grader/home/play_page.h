// SPDX-License-Identifier: MIT-0
/// @file
/// The page of a film.
#pragma once
#include <string>

#include "grade_submission.h"
#include "home/scene.h"

namespace grade {

/// A scene that was played.
struct Played {
  const Scene& scene;
  Stage stage;      ///< as far as it came
  std::string why;  ///< it came no further; empty if it came to its end
};

/// A page that needs nothing but itself.
/// @param report  of the same code
std::string play_page(const Played& played, const Report& report);

/// Returns whether a text is such a page.
bool is_play_page(const std::string& text);

}  // namespace grade
