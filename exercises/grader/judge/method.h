// SPDX-License-Identifier: MIT-0
/// @file
/// The methods that a student's is held beside.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "harness/force.h"
#include "judge/path.h"

namespace judge {

/// One step, x and v in place.
using Step =
    std::function<void(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration)>;

struct Method {
  std::string name;             ///< as in "this is ...": `Euler's method`
  std::function<Step()> begin;  ///< a step with a memory of its own, if it needs one
};

/// A method that remembers nothing.
Method method(std::string name, Step step);

extern const Method euler, symplectic_euler, symplectic_euler_position_first, midpoint, heun, rk4,
    velocity_verlet, position_verlet, yoshida4;

/// All of them, to recognise a student's by.
const std::vector<Method>& methods();

/// Runs a method as Student::watch does.
Path watch(const Method& method, const Start& start, double h, int steps,
           const Acceleration& acceleration);

/// Runs a method as Student::run does.
Path run(const Method& method, const Start& start, double h, int steps, int every,
         const Acceleration& acceleration);

/// The truth, for what has no formula: RK4 with steps so small that its error is below 1e-11 of the
/// state; the states at the times of `steps` steps of h, every so many.
Path truth(const Start& start, double h, int steps, int every, const Acceleration& acceleration);

/// The end of a flight around a sun, by steps of RK4 that are a thousandth of a turn or less
/// wherever it is: for orbits so long that equal steps would take a second.
/// @param mu  of the sun, at the origin [m^3/s^2]
State truth_past_a_sun(const Start& start, double duration, double mu,
                       const Acceleration& acceleration);

}  // namespace judge
