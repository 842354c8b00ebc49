// SPDX-License-Identifier: MIT-0
// The methods that solve for the end of a step.
#include "measure/list.h"
#include "measure/method_of.h"
#include "measure/registry.h"

namespace method {

constinit const measure::Method backward_euler = measure::method_of<list::BackwardEuler>();
constinit const measure::Method backward_euler_newton =
    measure::method_of<list::BackwardEulerNewton>();
constinit const measure::Method trapezoid = measure::method_of<list::Trapezoid>();
constinit const measure::Method trapezoid_newton = measure::method_of<list::TrapezoidNewton>();

}  // namespace method
