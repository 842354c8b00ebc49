// SPDX-License-Identifier: MIT-0
/// @file
/// Inputs that nobody can know beforehand, and that can be drawn again.
#pragma once
#include <cstdint>
#include <random>
#include <vector>

#include "harness/bounds.h"
#include "harness/force.h"
#include "judge/path.h"

namespace judge {

/// Draws from the seed of the grading and the name of the test, so that no test's inputs depend on
/// another's.
class Random {
 public:
  Random();

  double between(double low, double high);
  double between(const harness::Bounds& bounds);  ///< from the smallest to the largest
  int whole(int low, int high);                   ///< both may be drawn
  Vec vector(double low, double high);

  /// What is to be asked of an argument: its bounds, what is special, and so many drawn between.
  std::vector<double> all_of(const harness::Bounds& bounds, int drawn);

  /// About 1 in size, and not along an axis.
  Start start();

  /// Smooth, bent, with drag and wind: nothing that a special case solves. Its constants are about
  /// 1 per second.
  harness::Force wild();

 private:
  std::mt19937_64 numbers_;
};

}  // namespace judge
