// SPDX-License-Identifier: MIT-0
/// @file
/// Small pictures of complaints: how a thing moves, and how it moves when it is mended.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "measure/record.h"

/// One line of a sketch, at even distances from its left to its right.
struct Line {
  std::string label;
  std::vector<double> values;

  double last() const { return values.back(); }
  double most() const { return *std::max_element(values.begin(), values.end()); }
  double least() const { return *std::min_element(values.begin(), values.end()); }
  /// How much there is between the least and the most of the last so many values.
  double sway(int count) const {
    const auto [low, high] = std::minmax_element(values.end() - count, values.end());
    return *high - *low;
  }
};

/// What somebody complains of, and last the thing as it should be.
struct Sketch {
  std::string name;    ///< of its table
  double length;       ///< from left to right
  std::string across;  ///< what that is, and its unit
  std::string unit;    ///< of the values
  std::vector<Line> lines;

  const Line& ill(int which = 0) const { return lines[std::size_t(which)]; }
  const Line& mended() const { return lines.back(); }
};

constexpr int points = 121;  ///< of a line that runs

/// A line through what `step(h)` returns at the end of each frame, so many a second.
template <class Step>
Line run(std::string label, double seconds, double rate, double first, Step&& step) {
  const int frames = int(std::lround(seconds * rate));
  std::vector<double> drawn{first};
  for (int n = 0; n < frames; ++n) drawn.push_back(step(1 / rate));
  Line line{std::move(label), {}};
  for (int i = 0; i < points; ++i) {
    const double place = double(i) * frames / (points - 1);
    const int before = std::min(int(place), frames - 1);
    const double share = place - before;
    const double a = drawn[std::size_t(before)], b = drawn[std::size_t(before) + 1];
    line.values.push_back(share == 0 ? a : a + share * (b - a));
  }
  return line;
}

/// A line with a value for each of so many frames.
template <class Value>
Line each(std::string label, int frames, Value&& value) {
  Line line{std::move(label), {}};
  for (int n = 0; n < frames; ++n) line.values.push_back(value(n));
  return line;
}

constexpr double g = 9.81;

inline double product(double a, double b) {
  return a * b;
}

/// All sketches, in the order of the page.
std::vector<Sketch> every_sketch();
std::vector<Sketch> sketches_of_frames();
std::vector<Sketch> sketches_of_the_air();
std::vector<Sketch> sketches_of_springs();
std::vector<Sketch> sketches_of_ropes();
std::vector<Sketch> sketches_of_contacts();
std::vector<Sketch> sketches_of_turning();
std::vector<Sketch> sketches_of_long_runs();

/// The one with a name.
Sketch sketch(const std::string& name);
