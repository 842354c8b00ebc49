// SPDX-License-Identifier: MIT-0
/// @file
/// A blob of starts in the plane of stretch and velocity, and what Euler's method makes of it.
#pragma once
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "../cast.h"
#include "measure/methods.h"
#include "measure/record.h"
#include "measure/run.h"
#include "scenes/state.h"

/// The outline of a blob: many suspensions, each with a start of its own.
using Blob = std::vector<scenes::State<double>>;

/// A round blob of three centimetres around a suspension that is ten centimetres out, at rest.
inline Blob round_blob() {
  Blob blob;
  for (int n = 0; n < 72; ++n) {
    const double angle = 2 * std::numbers::pi * n / 72;
    blob.push_back({0.1 + 0.03 * std::cos(angle), 0.03 * std::sin(angle) * suspension.omega});
  }
  return blob;
}

/// The area within an outline [m^2/s].
inline double area(const Blob& blob) {
  double twice = 0;
  for (std::size_t n = 0; n < blob.size(); ++n) {
    const auto &here = blob[n], &next = blob[(n + 1) % blob.size()];
    twice += here.x * next.v - next.x * here.v;
  }
  return twice / 2;
}

/// Each point of the outline after some steps of Euler's method.
inline Blob stepped(Blob blob, double step, long steps) {
  for (auto& point : blob) point = measure::after(measure::euler, suspension, point, step, steps);
  return blob;
}

/// How long the suspension takes for one swing, damped as it is [s].
inline double one_swing() {
  return 2 * std::numbers::pi /
         (suspension.omega * std::sqrt(1 - suspension.zeta * suspension.zeta));
}

/// The blob at eight moments of one swing, and its area at the end of it.
/// @param milliseconds  the step
inline void blob_of(measure::Record& record, int milliseconds) {
  const std::string name = std::to_string(milliseconds);
  auto& table = record.table(
      "blob-" + name, {{"moment", "", measure::whole}, {"stretch", "cm"}, {"velocity", "cm"}});
  const double step = milliseconds / 1000.0;
  const long steps = std::lround(one_swing() / step);
  for (int moment = 0; moment <= 8; ++moment) {
    const Blob now = stepped(round_blob(), step, std::lround(double(steps) * moment / 8));
    for (std::size_t n = 0; n <= now.size(); ++n) {
      const auto& point = now[n % now.size()];
      table.add({double(moment), 100 * point.x, 100 * point.v / suspension.omega});
    }
  }
  const double before = area(round_blob());
  record.number("blob-step-" + name, double(milliseconds), measure::whole, "ms");
  record.number("blob-factor-" + name, area(stepped(round_blob(), step, 1)) / before, 3);
  record.number("blob-swing-" + name, area(stepped(round_blob(), step, steps)) / before, 3);
}

/// Two steps, one on either side of the limit, and what the damper alone would leave of a blob.
inline void blobs(measure::Record& record) {
  blob_of(record, 5);
  blob_of(record, 15);
  record.number("blob-true", std::exp(-suspension.damping() * one_swing()), 3);
}
