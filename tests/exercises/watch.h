// SPDX-License-Identifier: MIT-0
/// @file
/// Hears what is asked of a function, for the proof that all of it is. Not in a student's driver.
#ifndef WATCH_H
#define WATCH_H
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <type_traits>

#include "bounds.h"
#include "given.h"

namespace harness {

/// Of one argument of one function. At the program's end it says on stderr of each bound, each
/// special value, and each power of ten between whether it was asked; of a vector also whether one
/// along an axis was; and what lay outside:
///
///     asked LINE NAME = VALUE yes
///     asked LINE NAME like 0.001 no
///     asked LINE NAME along an axis no
///     outside LINE NAME = VALUE yes
class Watch {
 public:
  Watch() = default;
  ~Watch() {
    if (!heard_) return;
    for (std::size_t i = 0; i < bounds_.asked().size(); ++i)
      std::fprintf(stderr, "asked %d %s = %.17g %s\n", line_, bounds_.name(), bounds_.asked()[i],
                   asked_[i] ? "yes" : "no");
    tell_decades(1, bounds_.smallest(), bounds_.largest());
    tell_decades(-1, -bounds_.largest(), -bounds_.smallest());
    if (is_vector_ && bounds_.largest() > 0)
      std::fprintf(stderr, "asked %d %s along an axis %s\n", line_, bounds_.name(),
                   along_an_axis_ ? "yes" : "no");
    if (!std::isnan(outside_))
      std::fprintf(stderr, "outside %d %s = %.17g yes\n", line_, bounds_.name(), outside_);
  }
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  void of(const Bounds& bounds, int line) {
    bounds_ = bounds;
    line_ = line;
  }

  template <class Argument>
  void hear(const Argument& argument) {
    if (bounds_.asked().empty()) return;
    heard_ = true;
    const double value = size(argument);
    for (std::size_t i = 0; i < bounds_.asked().size(); ++i)
      asked_[i] = asked_[i] || alike(value, bounds_.asked()[i]);
    if (value != 0 && std::isfinite(value)) decades_[side(value)][decade(value)] = true;
    if constexpr (std::is_same_v<Argument, Vec>) {
      is_vector_ = true;
      along_an_axis_ =
          along_an_axis_ ||
          (value > 0 && (argument.x != 0) + (argument.y != 0) + (argument.z != 0) == 1);
    }
    const bool below = value < bounds_.smallest() && !alike(value, bounds_.smallest());
    const bool above = value > bounds_.largest() && !alike(value, bounds_.largest());
    if (below || above) outside_ = value;
  }

 private:
  // How many powers of ten are kept, and how many below the largest are asked if the least is 0.
  static constexpr int kept = 64, below_largest = 8;

  static std::size_t side(double value) { return value < 0 ? 1 : 0; }
  static std::size_t decade(double value) {
    const int power = static_cast<int>(std::floor(std::log10(std::abs(value)) + 1e-9));
    return static_cast<std::size_t>(std::min(std::max(power + kept / 2, 0), kept - 1));
  }

  // On one side of zero, from one size to another.
  void tell_decades(double sign, double smallest, double largest) const {
    if (largest <= 0) return;
    const std::size_t last = decade(largest);
    const std::size_t first = smallest > 0 ? decade(smallest) : last - below_largest;
    for (std::size_t n = first; n <= last; ++n)
      std::fprintf(stderr, "asked %d %s like %g %s\n", line_, bounds_.name(),
                   sign * std::pow(10, static_cast<double>(n) - kept / 2),
                   decades_[side(sign)][n] ? "yes" : "no");
  }

  // But for the rounding of what the judge computed it from.
  static bool alike(double one, double other) {
    return std::abs(one - other) <= 1e-12 * std::abs(other);
  }

  template <class Argument>
  static double size(const Argument& argument) {
    if constexpr (std::is_arithmetic_v<Argument>) {
      return static_cast<double>(argument);
    } else if constexpr (std::is_same_v<Argument, Vec>) {
      return length(argument);
    } else if constexpr (requires { argument.size(); }) {
      return static_cast<double>(argument.size());
    }
    return NAN;  // no bound of it is ever asked
  }

  Bounds bounds_;
  int line_ = 0;
  bool heard_ = false;
  std::array<bool, 8> asked_{};
  std::array<std::array<bool, kept>, 2> decades_{};
  bool is_vector_ = false, along_an_axis_ = false;
  double outside_ = NAN;
};

/// Of all arguments of a function; copies of it share them.
template <class... Arguments>
class Watches {
 public:
  template <std::size_t count>
  void of(const Bounds (&bounds)[count], int line) const {
    for (std::size_t i = 0; i < count; ++i) (*all_)[i].of(bounds[i], line);
  }

  template <class... Passed>
  void hear(const Passed&... passed) const {
    std::size_t i = 0;
    ((*all_)[i++].hear(passed), ...);
  }

 private:
  using All = std::array<Watch, sizeof...(Arguments)>;
  std::shared_ptr<All> all_ = std::make_shared<All>();
};

}  // namespace harness
#endif
