// SPDX-License-Identifier: MIT-0
/// @file
/// Where the wheels end.
#pragma once
#include "measure/record.h"
#include "toys.h"
#include "wheel.h"

inline void wheels(measure::Record& record) {
  auto& wheel =
      record.table("wheel", {{"t", "s"}, {"x", "m"}, {"y", "m"}, {"kept x", "m"}, {"kept y", "m"}});
  Spoke straight{frame}, kept{frame};
  for (int n = 0; n <= 60; ++n) {
    wheel.add({n * frame, straight.x.x(), straight.x.y(), kept.x.x(), kept.x.y()});
    if (n < 60) straight.step(), kept.step_and_normalize();
  }
  record.number("wheel-1", straight.x.norm(), 3);

  auto& speeds = record.table(
      "spin",
      {{"t", "s"}, {"direction", "turns/s"}, {"box", "turns/s"}, {"box in eight", "turns/s"}});
  Spoke spoke{frame};
  Box box(frame), often(frame / 8);
  double off = 0;
  for (int n = 0; n <= 600; ++n) {
    speeds.add({n * frame, spoke.speed() / spin, box.speed() / spin, often.speed() / spin});
    off = std::max(off, std::abs((box.x[1] - box.x[0]).norm() - 1));
    spoke.step_and_normalize();
    box.step(4);
    for (int substep = 0; substep < 8; ++substep) often.step(1);
  }
  record.number("spin-1", 100 * speeds.rows[60][1].value, 2, "%");
  record.number("spin-10", 100 * speeds.rows[600][1].value, 2, "%");
  record.number("box-10", 100 * speeds.rows[600][2].value, 2, "%");
  record.number("box-often", 100 * speeds.rows[600][3].value, 2, "%");
  record.number("box-off", 100 * off, 1, "%");
}
