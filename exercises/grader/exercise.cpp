// SPDX-License-Identifier: MIT-0
#include "exercise.h"

#include <algorithm>
#include <cstddef>

#include "installed.h"
#include "nearest.h"
#include "version.h"

namespace grade {

std::string Exercise::chapter() const {
  return name.substr(0, name.find('/'));
}

std::string Exercise::task() const {
  return name.substr(name.find('/') + 1);
}

std::string Exercise::header() const {
  return task() + ".h";
}

std::vector<Exercise> exercises() {
  std::vector<Exercise> all;
  for (const auto& [name, hash] : versions())
    all.push_back({name, std::filesystem::path(installed().exercises) / name});
  return all;
}

std::optional<Exercise> exercise(const std::string& name) {
  for (const Exercise& one : exercises()) {
    if (one.name == name) return one;
  }
  return {};
}

std::string nearest_exercise(const std::string& name) {
  const std::vector<Exercise> all = exercises();
  // Whoever leaves out the chapter, or writes a part of the name, means that exercise.
  const auto away = [&](const Exercise& one) {
    if (one.name.find(name) != std::string::npos) return std::size_t{0};
    return std::min(edit_distance(one.name, name), edit_distance(one.task(), name));
  };
  const auto nearest = std::min_element(
      all.begin(), all.end(), [&](const auto& a, const auto& b) { return away(a) < away(b); });
  return nearest->name;
}

}  // namespace grade
