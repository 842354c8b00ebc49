// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// The velocity with which a ball must leave to meet the runner [m/s].
inline Vec throw_velocity(const Vec& from, const Vec& target, const Vec& runner, const Vec& a,
                          double time) {
  return (target - from) / time + runner - 0.5 * time * a;
}
