// SPDX-License-Identifier: MIT-0
/// @file
/// Stands before code/scenes/state.h in the programs that begin one unit in the last place beside
/// their starts.
#pragma once
#include <cmath>
#include <cstdlib>
#include <limits>
#include <source_location>
#include <string_view>
#include <type_traits>

namespace scenes::aside {

/// Which way: 1 is up, -1 down, and 0, where the environment has no MOVED, leaves all as it is.
inline int way() {
  static const char* const said = std::getenv("MOVED");
  static const int parsed = said ? std::atoi(said) : 0;
  return parsed;
}

/// The next number on that way; zero stays. What has more digits than a double goes on by a
/// double's last place.
template <class Real>
Real next(Real x) {
  using Kept = std::conditional_t<std::is_same_v<Real, float>, float, double>;
  if (x == 0) return x;
  const Kept to = Kept(way()) * std::numeric_limits<Kept>::infinity();
  return x + (Real(std::nextafter(Kept(x), to)) - Real(Kept(x)));
}

/// The same of each number of a vector; what is neither a number nor a vector stays.
template <class Vec>
Vec beside(const Vec& vec) {
  if (way() == 0) return vec;
  if constexpr (std::is_floating_point_v<Vec>) {
    return next(vec);
  } else if constexpr (requires { vec.unaryExpr([](auto x) { return x; }); }) {
    return vec.unaryExpr([](auto x) { return next(x); });
  } else {
    return vec;
  }
}

/// Whether a state is set up by this function: all are but those that a method reads off what it
/// keeps, which are no starts.
inline bool sets_up(std::string_view function) {
  return function.find("to_state(") == std::string_view::npos;
}

}  // namespace scenes::aside

namespace scenes {

/// Position and velocity, moved if this is a start.
template <class Vec>
struct State {
  Vec x{};
  Vec v{};

  State() = default;
  State(const Vec& position, const Vec& velocity,
        std::source_location here = std::source_location::current())
      : x(position), v(velocity) {
    if (!aside::sets_up(here.function_name())) return;
    x = aside::beside(x);
    v = aside::beside(v);
  }
};

}  // namespace scenes
