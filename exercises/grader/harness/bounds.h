// SPDX-License-Identifier: MIT-0
/// @file
/// The values that may be asked of an argument, as an exercise's harness.h says it.
#ifndef BOUNDS_H
#define BOUNDS_H
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace harness {

/// An argument goes from the smallest to the largest, and both are asked. So is what is special: at
/// such a value a formula divides by zero, a rule of the task changes, or a short cut breaks down.
/// Of a vector its length counts, of a list how many it holds.
class Bounds {
 public:
  /// The bounds of an argument that has none, such as a force.
  constexpr Bounds() = default;

  /// @param name  as the task calls it
  template <class... Special>
  constexpr Bounds(const char* name, double smallest, double largest, Special... special)
      : name_(name),
        values_{smallest, largest, static_cast<double>(special)...},
        count_(2 + sizeof...(special)) {}

  constexpr const char* name() const { return name_; }
  constexpr double smallest() const { return values_[0]; }
  constexpr double largest() const { return values_[1]; }

  /// The smallest, the largest, and what is special.
  constexpr std::span<const double> asked() const { return {values_.data(), count_}; }

 private:
  const char* name_ = nullptr;
  std::array<double, 8> values_{};
  std::size_t count_ = 0;
};

inline constexpr Bounds any{};

}  // namespace harness
#endif
