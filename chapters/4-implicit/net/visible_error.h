// SPDX-License-Identifier: MIT-0
/// @file
/// The visible error of a net after a blow in chapter 4, method by method, and the cost of a frame.
#pragma once
#include <string>
#include <vector>

#include "measure/record.h"

/// The outcome of a second after a blow, by one method in steps of one length.
struct Outcome {
  std::string method;       ///< in the figure, without a comma
  int steps = 1;            ///< in a frame
  double work = 0;          ///< multiplications and the like, for each unknown and frame
  double error = 0;         ///< the visible error; see error_of_truth()
  double energy_left = 0;   ///< after the second, over that of the blow
  bool is_nearest = false;  ///< of those that cost as much or less
};

/// The outcomes that the figure shows of one net, the cheapest first.
/// @param net  "rope" or "cloth"
/// @param speed  of the blow [m/s]
std::vector<Outcome> outcomes_on(const std::string& net, double speed);

/// A method, and how often it steps and solves.
struct Setup {
  std::string method;  ///< "symplectic Euler", "backward Euler", "BDF2" or "trapezoid"
  int steps = 1;       ///< in a frame
  int solves = 1;      ///< in a step
};

/// The outcomes of setups on one net, in their order.
/// @param draw  of the blow; see with_random_velocities()
std::vector<Outcome> run_setups(const std::string& net, double speed,
                                const std::vector<Setup>& setups, unsigned draw = 1);

/// The outcome of a method with so many steps in a frame.
const Outcome& outcome_of(const std::vector<Outcome>& all, const std::string& method,
                          int steps = 1);

/// The visible error of the truth against itself in half the steps: the distance of the masses from
/// their places, both with motion blur, over the way that they have gone.
double error_of_truth(const std::string& net, double speed);

/// The visible error of the true motion, drawn sixty times a second.
double error_of_sixty_pictures(const std::string& net, double speed);

/// The fewest substeps of symplectic Euler that hold a net.
int fewest_substeps(const std::string& net);

/// Records work and error of all setups on both nets.
void record_visible_errors(measure::Record& record);
