// fails: a leash that creeps is limited by its fast motion
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline double longest_step(double k, double c, double m) {
  return c / k;
}
