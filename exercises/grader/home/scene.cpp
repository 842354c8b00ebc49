// SPDX-License-Identifier: MIT-0
#include "home/scene.h"

#include <algorithm>
#include <map>
#include <utility>

namespace grade {
namespace {

std::map<std::string, Scene>& scenes() {
  static std::map<std::string, Scene> all;
  return all;
}

}  // namespace

const Scene* scene_of(const std::string& exercise) {
  const auto found = scenes().find(exercise);
  return found == scenes().end() ? nullptr : &found->second;
}

Staged::Staged(Scene scene) {
  const std::string exercise = scene.exercise;
  scenes().emplace(exercise, std::move(scene));
}

Vec place(const judge::Path& path, double states) {
  const auto before = static_cast<std::size_t>(states);
  const std::size_t last = path.states.size() - 1, n = std::min(before, last);
  const Vec &from = path.states[n].x, &to = path.states[std::min(n + 1, last)].x;
  return from + (states - static_cast<double>(before)) * (to - from);
}

}  // namespace grade
