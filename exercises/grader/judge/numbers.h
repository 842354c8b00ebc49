// SPDX-License-Identifier: MIT-0
/// @file
/// The numbers of a call, as an exercise's harness.h reads and answers them.
#pragma once
#include <type_traits>
#include <vector>

#include "harness/force.h"
#include "judge/path.h"

namespace judge {

void append(std::vector<double>& numbers, const Vec& vector);
void append(std::vector<double>& numbers, const State& state);
void append(std::vector<double>& numbers, const harness::Force& force);  ///< kind and constants
void append(std::vector<double>& numbers, const std::vector<double>& more);

template <class Number>
  requires std::is_arithmetic_v<Number>
void append(std::vector<double>& numbers, Number number) {
  numbers.push_back(static_cast<double>(number));
}

/// All numbers of these in a row.
template <class... Parts>
std::vector<double> as_numbers(const Parts&... parts) {
  std::vector<double> numbers;
  (append(numbers, parts), ...);
  return numbers;
}

/// The vectors in an answer, three numbers each.
std::vector<Vec> as_vectors(const std::vector<double>& numbers);

/// The states in an answer, six numbers each.
std::vector<State> as_states(const std::vector<double>& numbers);

}  // namespace judge
