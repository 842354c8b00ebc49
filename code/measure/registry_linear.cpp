// SPDX-License-Identifier: MIT-0
// The methods for springs and for linear damping.
#include "measure/list.h"
#include "measure/method_of.h"
#include "measure/registry.h"

namespace method {

constinit const measure::Method backward_euler_spring =
    measure::method_of<list::BackwardEulerSpring>();
constinit const measure::Method rk4_linear = measure::method_of<list::Rk4Linear>();
constinit const measure::Method spring_exact = measure::method_of<list::SpringExact>();
constinit const measure::Method linear_damping_explicit_last =
    measure::method_of<list::LinearDampingExplicitLast>();
constinit const measure::Method linear_damping_explicit_first =
    measure::method_of<list::LinearDampingExplicitFirst>();
constinit const measure::Method linear_damping_implicit_last =
    measure::method_of<list::LinearDampingImplicitLast>();
constinit const measure::Method linear_damping_implicit_first =
    measure::method_of<list::LinearDampingImplicitFirst>();
constinit const measure::Method linear_damping_exponential_last =
    measure::method_of<list::LinearDampingExponentialLast>();
constinit const measure::Method linear_damping_exponential_first =
    measure::method_of<list::LinearDampingExponentialFirst>();
constinit const measure::Method linear_damping_exact =
    measure::method_of<list::LinearDampingExact>();

}  // namespace method
