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
  double octaves(double low, double high);        ///< as often between 1 and 2 as between 2 and 4
  int whole(int low, int high);                   ///< both may be drawn
  double sign();                                  ///< 1 or -1

  /// A factor that is off 1 by so much at least and at most, to either side, with all sizes alike.
  double nearly_one(double least, double most);

  Vec vector(double low, double high);

  /// All values to be asked of an argument: its bounds, what is special, and so many drawn between.
  std::vector<double> all_of(const harness::Bounds& bounds, int drawn);

  /// One of those that are asked by name, or any between, or any with all sizes alike: a few
  /// hundred cross every threshold that a program may have set.
  double anywhere(const harness::Bounds& bounds);

  /// A vector of such a length, to any side; one in four along an axis.
  Vec vector_anywhere(const harness::Bounds& length);

  /// About 1 in size, and not along an axis.
  Start start();

  /// Smooth, bent, with drag and wind: nothing that a special case solves. Its constants are about
  /// 1 per second.
  harness::Force wild();

  /// A wild force, or one in four times gravity alone, or nothing at all.
  harness::Force any_force();

 private:
  std::mt19937_64 numbers_;
};

}  // namespace judge
