// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Spends the frame first and what was saved last.
inline int steps_due(double& saved, double length, double pace, double h) {
  int due = 0;
  length *= pace;
  while (length >= h) {
    length -= h;
    due = due + 1;
  }
  saved = saved + length;
  if (saved >= h) {
    saved = saved - h;
    due = due + 1;
  }
  return due;
}

inline double blend(double saved, double h) {
  return saved / h;
}
