// SPDX-License-Identifier: MIT-0
#pragma once
#include <algorithm>
#include <cmath>

namespace orbit {

/// What every row starts from and ends with, whatever it computes with in between.
struct State {
  double x, y, vx, vy;
};

inline double distance(State a, State b) {
  return std::max(
      {std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.vx - b.vx), std::abs(a.vy - b.vy)});
}

/// The end of a row's loop. Volatile, since g++ -O3 otherwise packs the four numbers into one
/// register throughout the loop, for the sake of one store behind it: twice the time for Euler.
inline State end_at(double x, double y, double vx, double vy) {
  const volatile State end{x, y, vx, vy};
  return {end.x, end.y, end.vx, end.vy};
}

/// A planet at its pericentre, eccentricity 0.6, after Kepler: x'' = -x / |x|^3.
constexpr State start{0.4, 0, 0, 2};

/// How strongly the sun pulls, for each metre of distance. The same formula for every row.
inline double pull(double squared_distance) {
  return -1 / (squared_distance * std::sqrt(squared_distance));
}

}  // namespace orbit
