// SPDX-License-Identifier: MIT-0
/// @file
/// The findings of a test, in the words that the student will read.
#pragma once
#include <string>
#include <vector>

namespace grade {

/// A line in a plot.
struct Curve {
  std::string name;  ///< for the key: "yours", "Euler's method"
  std::vector<double> x, y;
};

/// A picture of what went wrong; without curves there is none.
struct Plot {
  std::string title, x_label, y_label;
  std::vector<Curve> curves;  ///< the student's first; points that are not finite are left out
  bool same_scale = false;    ///< x and y in the same unit, as a path is
  bool logarithmic = false;   ///< both axes; points that are not positive are left out
  std::string file = "";      ///< where it was drawn, seen from the report; empty if it was not
};

/// One comparison, held or not.
struct Finding {
  bool held = false;
  std::string asked;                   ///< what the code was asked to do
  std::string input;                   ///< with what, to be tried again at home
  std::string expected;                ///< what a right answer is
  std::string got;                     ///< what came
  std::string error;                   ///< how far off
  std::string tolerance;               ///< how far off it may be
  std::string tolerance_from;          ///< and why
  std::string hint;                    ///< one sentence that helps
  std::vector<std::string> diagnoses;  ///< what the answer looks like: "this is Euler's method"
  Plot plot;
};

/// A test of an exercise: all of its findings must hold, or it gives no points.
struct TestResult {
  std::string name;
  int points = 0;  ///< that it is worth
  bool ran = false;
  bool held = false;
  std::vector<Finding> findings;  ///< up to the first that did not hold
};

}  // namespace grade
