// fails: the price of an error is right for a leaf that fell
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Counts steps where the price is in evaluations.
/// The order that two runs show.
/// @param h1  step of the first run [s]
/// @param error1  its error [m]
/// @param h2  step of the second run [s]
/// @param error2  its error [m]
inline double order(double h1, double error1, double h2, double error2) {
  return std::log(error1 / error2) / std::log(h1 / h2);
}

/// The step at which the error is just the wanted one [s].
/// @param wanted  error [m]
/// @param h  step of a run [s]
/// @param error  of that run [m]
/// @param p  order of the method
inline double step_for(double wanted, double h, double error, double p) {
  return h * std::pow(wanted / error, 1 / p);
}

/// How often a run asks for the acceleration, in equal steps that are not longer than h.
/// @param duration  of the run [s]
/// @param h  longest step allowed [s]
/// @param per_step  how often each step asks
inline int evaluations(double duration, double h, int per_step) {
  return static_cast<int>(std::ceil(duration / h));
}
