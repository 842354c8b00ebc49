// SPDX-License-Identifier: MIT-0
// std::experimental::simd, of four floats.
#pragma once
#include <cstddef>
#include <experimental/simd>

namespace kinds {

struct std_simd {
  using Vec = std::experimental::fixed_size_simd<float, 4>;
  using Real = float;
  using Time = double;
  static constexpr int size = 3;
  static constexpr const char* name = "std::experimental::simd";
  static Vec make(const Real* from) {
    return Vec([&](auto i) { return i < 3 ? from[i] : 0; });
  }
  static Real read(const Vec& x, int i) { return x[std::size_t(i)]; }
};

}  // namespace kinds
