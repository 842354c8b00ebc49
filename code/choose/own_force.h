// SPDX-License-Identifier: MIT-0
/// @file
/// A scene of the reader's own in plain numbers, for which the contest is compiled beforehand.
#pragma once

/// What the contest asks of a scene, behind one type.
struct OwnForce {
  int numbers;    ///< in a place, or in a velocity
  bool in_float;  ///< whether the scene keeps them as floats

  /// Writes where it starts.
  /// @throws std::invalid_argument  the scene's vectors hold what + doesn't add up
  void (*start)(double* x, double* v);

  /// Writes the acceleration.
  void (*acceleration)(const double* x, const double* v, double t, double* a);
};
