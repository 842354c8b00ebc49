// SPDX-License-Identifier: MIT-0
/// @file
/// A rope that hangs from a nail, in chapter 4.
#pragma once
#include "struck.h"

/// Two metres of rope, held level by its ends; one hand lets go, the other end hangs on its nail.
/// @param stiffness  of each of its springs [N/m]
template <class Real = double>
scenes::Rope<Real> rope_on_a_nail(double stiffness) {
  return {.count = 16, .length = 2, .mass = mass, .k = stiffness};
}
