// SPDX-License-Identifier: MIT-0
// The methods that take any acceleration.
#include "measure/list.h"
#include "measure/method_of.h"
#include "measure/registry.h"

namespace method {

constinit const measure::Method euler = measure::method_of<list::Euler>();
constinit const measure::Method constant_acceleration =
    measure::method_of<list::ConstantAcceleration>();
constinit const measure::Method symplectic_euler = measure::method_of<list::SymplecticEuler>();
constinit const measure::Method symplectic_euler_position_first =
    measure::method_of<list::SymplecticEulerPositionFirst>();
constinit const measure::Method midpoint = measure::method_of<list::Midpoint>();
constinit const measure::Method heun = measure::method_of<list::Heun>();
constinit const measure::Method rk4 = measure::method_of<list::Rk4>();
constinit const measure::Method predicted_euler = measure::method_of<list::PredictedEuler>();
constinit const measure::Method stormer_verlet = measure::method_of<list::StormerVerlet>();
constinit const measure::Method stormer_verlet_carried =
    measure::method_of<list::StormerVerletCarried>();
constinit const measure::Method stormer_verlet_uneven =
    measure::method_of<list::StormerVerletUneven>();
constinit const measure::Method leapfrog = measure::method_of<list::Leapfrog>();
constinit const measure::Method velocity_verlet = measure::method_of<list::VelocityVerlet>();
constinit const measure::Method yoshida4 = measure::method_of<list::Yoshida4>();
constinit const measure::Method dopri5 = measure::method_of<list::Dopri5>();

}  // namespace method
