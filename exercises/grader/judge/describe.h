// SPDX-License-Identifier: MIT-0
/// @file
/// States and starts in words, with all digits: whoever shows them leaves out what nobody needs.
#pragma once
#include <string>

#include "harness/force.h"
#include "judge/path.h"

namespace judge {

std::string describe(double number, int digits = 17);
std::string describe(const Vec& vector, int digits = 17);
std::string describe(const State& state, int digits = 17);
std::string describe(const Start& start);

/// A force, with its constants.
std::string describe(const harness::Force& force);

/// Values by their names: `named("x", x, "h", h)` is as `x = (1, 0, 0), h = 0.1`.
template <class Value, class... More>
std::string named(const std::string& name, const Value& value, const More&... more) {
  const std::string text = name + " = " + describe(value);
  if constexpr (sizeof...(more) == 0)
    return text;
  else
    return text + ", " + named(more...);
}

}  // namespace judge
