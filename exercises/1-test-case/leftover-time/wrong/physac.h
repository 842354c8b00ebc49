// Fails: uneven frames are paid with as many steps as fit into them
// Says: about one step in every frame: the steps follow the frames
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Takes the frame off where the step should be taken off, as physac did (raylib, pull request 653).
inline int steps_due(double& saved, double length, double pace, double h) {
  saved = saved + pace * length;
  int due = 0;
  while (saved >= h) {
    due++;
    saved = saved - pace * length;
  }
  return due;
}

inline double blend(double saved, double h) {
  return saved / h;
}
