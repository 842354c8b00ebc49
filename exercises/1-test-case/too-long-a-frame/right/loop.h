// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline int steps_due(double& saved, double length, double h, int most) {
  saved += length;
  int steps = 0;
  for (; saved >= h && steps < most; saved -= h) ++steps;
  saved = std::fmod(saved, h);
  return steps;
}

inline double settled_frame(double draw, double cost, double h, int most) {
  if (cost >= h) return draw + most * cost;
  const double alone = draw * h / (h - cost);
  if (alone > most * h) return draw + most * cost;
  return alone;
}
