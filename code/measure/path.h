// SPDX-License-Identifier: MIT-0
/// @file
/// The path of a scene as a table, for a figure to draw.
#pragma once
#include <cmath>
#include <string>

#include "measure/record.h"
#include "measure/run.h"

namespace measure {

/// Keeps the path of a one-dimensional scene, one row for each step.
///
/// @param record  gets the table, with the columns t, x and v
/// @param name  of the table
/// @param step  a method, called as `step(x, v, t, h, scene)`
/// @param scene  one-dimensional; has `start()`
/// @param h  step size [s]
/// @param duration  length of the run [s]
template <class Step, class Scene>
void path(Record& record, const std::string& name, Step step, const Scene& scene, double h,
          double duration) {
  Table& table = record.table(name, {{"t", "s"}, {"x", "m"}, {"v", "m/s"}});
  auto s = scene.start();
  run(step, scene, s, h, std::lround(duration / h),
      [&](double t, const auto& now) { table.add({t, now.x, now.v}); });
}

/// Keeps the exact path of a one-dimensional scene, in 300 equal parts.
///
/// @param record  gets the table, with the columns t, x and v
/// @param name  of the table
/// @param scene  one-dimensional; has `exact(t)`
/// @param duration  how far to follow it [s]
template <class Scene>
void exact_path(Record& record, const std::string& name, const Scene& scene, double duration) {
  Table& table = record.table(name, {{"t", "s"}, {"x", "m"}, {"v", "m/s"}});
  for (int i = 0; i <= 300; ++i) {
    const double t = duration * i / 300;
    const auto now = scene.exact(t);
    table.add({t, now.x, now.v});
  }
}

}  // namespace measure
