// SPDX-License-Identifier: MIT-0
/// @file
/// The scenes of chapter 5: the cast's, a swing, and a drag of 2001.
#pragma once
#include "../cast_of_many.h"

/// Something that swings once a second, begun from rest.
inline constexpr scenes::Spring<> swing = swinging(1);

/// What is left after a second of a velocity of one, braked as in 2001.
inline double braked(int rate) {
  // [factor]
  double x = 0, x_previous = -1.0 / rate;
  for (int n = 0; n < rate; ++n) {
    const double x_next = 1.99 * x - 0.99 * x_previous;
    x_previous = x;
    x = x_next;
  }
  // [factor]
  return rate * (x - x_previous);
}

/// One step of position Verlet for a force that asks for no velocity, as the chapter has it first.
template <class Acceleration>
void without_velocity(double& x, double& x_previous, double h, Acceleration acceleration) {
  // [velocityless]
  const double x_next = x + (x - x_previous) + h * h * acceleration(x);
  x_previous = x;
  x = x_next;
  // [velocityless]
}
