// SPDX-License-Identifier: MIT-0
#include "judge/path.h"

#include <algorithm>
#include <cmath>

namespace judge {

double distance(const State& a, const State& b) {
  return larger(length(a.x - b.x), length(a.v - b.v));
}

bool is_finite(const State& state) {
  return std::isfinite(dot(state.x, state.x)) && std::isfinite(dot(state.v, state.v));
}

std::size_t first_not_finite(const Path& path) {
  const auto found = std::find_if_not(path.states.begin(), path.states.end(), is_finite);
  return static_cast<std::size_t>(found - path.states.begin());
}

}  // namespace judge
