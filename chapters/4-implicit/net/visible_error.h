// SPDX-License-Identifier: MIT-0
/// @file
/// What a player sees of a struck net in chapter 4, way by way: how far it is from what there is to
/// see, and what a frame of it costs.
#pragma once
#include <string>
#include <vector>

#include "measure/record.h"

/// One way to move a net for a second after a blow.
struct Way {
  std::string method;    ///< in the figure, without a comma
  int steps = 1;         ///< in a frame
  double work = 0;       ///< multiplications and the like, for each unknown and frame
  double off = 0;        ///< see off_of_truth()
  double left = 0;       ///< energy after the second, over that of the blow
  bool answers = false;  ///< whether no other way is both cheaper and nearer
};

/// All that the figure shows of one net.
/// @param net  "rope" or "cloth"
/// @param speed  of the blow [m/s]
std::vector<Way> ways(const std::string& net, double speed);

/// A way to try.
struct Ask {
  std::string method;  ///< "symplectic Euler", "backward Euler", "BDF2" or "trapezoid"
  int steps = 1;       ///< in a frame
  int solves = 1;      ///< in a step
};

/// What they do to one net, in their order.
/// @param draw  of the blow; see struck()
std::vector<Way> moved(const std::string& net, double speed, const std::vector<Ask>& all,
                       unsigned draw = 1);

/// The one of a method with so many steps in a frame.
const Way& way_of(const std::vector<Way>& all, const std::string& method, int steps = 1);

/// How far the truth is from what it would be in half the steps: the distance of the masses from
/// their places, both as a player sees them, over the way that they have gone.
double off_of_truth(const std::string& net, double speed);

/// How far the true motion is from what there is to see, if it is drawn sixty times a second.
double off_if_true(const std::string& net, double speed);

/// The fewest substeps of symplectic Euler that hold a net.
int fewest_substeps(const std::string& net);

/// Work and error of all ways on both nets.
void seen(measure::Record& record);
