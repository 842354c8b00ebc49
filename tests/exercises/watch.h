// SPDX-License-Identifier: MIT-0
/// @file
/// Hears what is asked of a function, for the proof that all of it is. Not in a student's driver.
#ifndef WATCH_H
#define WATCH_H
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <type_traits>

#include "bounds.h"
#include "given.h"

namespace harness {

/// Of one argument of one function. At the program's end it says on stderr of each bound and each
/// special value whether it was asked, and what lay outside:
///
///     asked LINE NAME VALUE yes
///     outside LINE NAME VALUE
class Watch {
 public:
  Watch() = default;
  ~Watch() {
    if (!heard_) return;
    for (std::size_t i = 0; i < bounds_.asked().size(); ++i)
      std::fprintf(stderr, "asked %d %s %.17g %s\n", line_, bounds_.name(), bounds_.asked()[i],
                   asked_[i] ? "yes" : "no");
    if (!std::isnan(outside_))
      std::fprintf(stderr, "outside %d %s %.17g\n", line_, bounds_.name(), outside_);
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
    const bool below = value < bounds_.smallest() && !alike(value, bounds_.smallest());
    const bool above = value > bounds_.largest() && !alike(value, bounds_.largest());
    if (below || above) outside_ = value;
  }

 private:
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
