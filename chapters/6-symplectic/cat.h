// SPDX-License-Identifier: MIT-0
/// @file
/// A cat in phase space: where a method carries it, and how large it is there.
#pragma once
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "../cast.h"
#include "measure/run.h"

inline constexpr double cat_step = 0.25;  ///< [s]
inline constexpr long cat_steps = 18;     ///< from one end of its swing to the other and on

/// Points of phase space, one after the other around an outline.
using Outline = std::vector<scenes::State<double>>;

/// A sitting cat in the phase space of the wrecking ball, counter-clockwise.
/// @param parts  points on each of its edges
inline Outline cat(int parts) {
  constexpr std::array<std::pair<double, double>, 23> corners{
      {{0.55, -1.00}, {1.05, -1.00}, {1.33, -0.65},  {1.28, -0.28},  {1.12, -0.30}, {1.15, -0.60},
       {0.95, -0.80}, {0.60, -0.78}, {0.62, -0.60},  {0.55, -0.15},  {0.38, 0.15},  {0.50, 0.40},
       {0.48, 0.65},  {0.52, 1.05},  {0.22, 0.82},   {-0.22, 0.82},  {-0.52, 1.05}, {-0.48, 0.65},
       {-0.50, 0.40}, {-0.38, 0.15}, {-0.55, -0.15}, {-0.62, -0.60}, {-0.55, -1.00}}};
  Outline outline;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto [x, y] = corners[i];
    const auto [next_x, next_y] = corners[(i + 1) % corners.size()];
    for (int part = 0; part < parts; ++part) {
      const double s = double(part) / parts;
      outline.push_back({0.9 + 0.3 * (x + s * (next_x - x)), 0.3 * (y + s * (next_y - y))});
    }
  }
  return outline;
}

/// Where every point of an outline is after a number of steps.
template <class Step, class Scene>
Outline carried(const Step& step, const Scene& scene, Outline outline, double h, long steps) {
  for (auto& point : outline) point = measure::after(step, scene, point, h, steps);
  return outline;
}

/// An outline that ends where it began, to be drawn.
inline Outline closed(Outline outline) {
  outline.push_back(outline.front());
  return outline;
}

// [area]
/// The area within an outline: half the sum of the cross products of neighbours.
inline double area(const Outline& outline) {
  double twice = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const auto& here = outline[i];
    const auto& next = outline[(i + 1) % outline.size()];
    twice += here.x * next.v - next.x * here.v;
  }
  return twice / 2;
}
// [area]
