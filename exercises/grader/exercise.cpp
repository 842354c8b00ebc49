// SPDX-License-Identifier: MIT-0
#include "exercise.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include "installed.h"
#include "version.h"

namespace grade {
namespace {

// How many letters must be put in, taken out or changed (Levenshtein).
std::size_t edits(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = std::exchange(row[j], std::min({changed, row[j] + 1, row[j - 1] + 1}));
    }
  }
  return row.back();
}

}  // namespace

std::string Exercise::chapter() const {
  return name.substr(0, name.find('/'));
}

std::string Exercise::header() const {
  return name.substr(name.find('/') + 1) + ".h";
}

std::vector<Exercise> exercises() {
  std::vector<Exercise> all;
  for (const auto& [name, hash] : versions()) {
    all.push_back({name, std::filesystem::path(installed().exercises) / name});
  }
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
  const auto nearest = std::min_element(all.begin(), all.end(), [&](const auto& a, const auto& b) {
    return edits(a.name, name) < edits(b.name, name);
  });
  return nearest->name;
}

}  // namespace grade
