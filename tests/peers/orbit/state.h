// SPDX-License-Identifier: MIT-0
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace orbit {

/// What every row starts from and ends with, whatever it computes with in between.
struct State {
  double x, y, vx, vy;
};

inline double distance(State a, State b) {
  return std::max(
      {std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.vx - b.vx), std::abs(a.vy - b.vy)});
}

/// The end of the loop of one planet. Volatile, since g++ -O3 otherwise packs the four numbers into
/// one register throughout the loop, for the sake of one store behind it: twice the time for Euler.
inline State end_at(State s) {
  const volatile State end{s.x, s.y, s.vx, s.vy};
  return {end.x, end.y, end.vx, end.vy};
}

/// Planets after Kepler, x'' = -x / |x|^3. The first is at its pericentre, eccentricity 0.6; each
/// of the others starts with a little less speed than the one before.
inline std::vector<State> start(std::size_t count) {
  std::vector<State> all(count);
  for (std::size_t i = 0; i < count; ++i) {
    all[i] = {0.4, 0, 0, 2 - 0.32 * double(i) / double(count)};
  }
  return all;
}

/// How strongly the sun pulls, for each metre of distance. The same formula for every row.
inline double pull(double squared_distance) {
  return -1 / (squared_distance * std::sqrt(squared_distance));
}

/// What the planets of one row need not have each for itself, such as an object of a library.
struct Nothing {};

/// The loop that a reader writes around a method: of one planet, whose steps wait for each other,
/// or of many, whose steps the processor overlaps.
///
/// @tparam count  how many planets; no program has both loops, since a compiler rather inlines what
///                is called once
/// @tparam Body  made from a State; has `step(shared, t, h)`, `state()` and a type `Shared`
template <std::size_t count, class Body>
std::vector<State> loop(const std::vector<State>& from, long steps, double h) {
  typename Body::Shared shared;
  if constexpr (count == 1) {
    Body alone(from[0]);
    for (long n = 0; n < steps; ++n) alone.step(shared, double(n) * h, h);
    return {end_at(alone.state())};
  } else {
    std::vector<Body> all(from.begin(), from.end());
    for (long n = 0; n < steps; ++n) {
      for (Body& body : all) body.step(shared, double(n) * h, h);
    }
    std::vector<State> end;
    for (const Body& body : all) end.push_back(body.state());
    return end;
  }
}

}  // namespace orbit
