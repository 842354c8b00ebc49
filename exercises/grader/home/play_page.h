// SPDX-License-Identifier: MIT-0
/// @file
/// The page of a film.
#pragma once
#include <filesystem>
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

/// A page that needs nothing but itself: a film, and the run of the first test that failed.
/// @param report  of the same code
std::string play_page(const Played& played, const Report& report);

/// The same around any film.
/// @param body  HTML that stands below it
std::string film_page(const std::string& title, const std::string& caption, const Stage& stage,
                      const std::string& body);

/// @throws Usage  a file stands there that is no such page
void refuse_foreign_page(const std::filesystem::path& page);

}  // namespace grade
