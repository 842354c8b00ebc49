// SPDX-License-Identifier: MIT-0
#include "judge/numbers.h"

#include <cstddef>

namespace judge {

void append(std::vector<double>& numbers, const Vec& vector) {
  numbers.insert(numbers.end(), {vector.x, vector.y, vector.z});
}

void append(std::vector<double>& numbers, const State& state) {
  append(numbers, state.x);
  append(numbers, state.v);
}

void append(std::vector<double>& numbers, const harness::Force& force) {
  append(numbers, static_cast<int>(force.kind));
  numbers.insert(numbers.end(), force.a.begin(), force.a.end());
}

void append(std::vector<double>& numbers, const std::vector<double>& more) {
  numbers.insert(numbers.end(), more.begin(), more.end());
}

std::vector<Vec> as_vectors(const std::vector<double>& numbers) {
  std::vector<Vec> vectors;
  for (std::size_t n = 0; n + 3 <= numbers.size(); n += 3)
    vectors.push_back({numbers[n], numbers[n + 1], numbers[n + 2]});
  return vectors;
}

std::vector<State> as_states(const std::vector<double>& numbers) {
  const std::vector<Vec> vectors = as_vectors(numbers);
  std::vector<State> states;
  for (std::size_t n = 0; n + 2 <= vectors.size(); n += 2)
    states.push_back({vectors[n], vectors[n + 1]});
  return states;
}

}  // namespace judge
