// SPDX-License-Identifier: MIT-0
// std::valarray, whose sums are expressions.
#pragma once
#include <cstddef>
#include <valarray>

namespace kinds {

struct valarray {
  using Vec = std::valarray<double>;
  using Real = double;
  using Time = double;
  static constexpr int size = 3;
  static constexpr const char* name = "std::valarray";
  static Vec make(const Real* from) { return Vec(from, 3); }
  static Real read(const Vec& x, int i) { return x[std::size_t(i)]; }
};

}  // namespace kinds
