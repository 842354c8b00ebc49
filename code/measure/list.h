// SPDX-License-Identifier: MIT-0
/// @file
/// Every method of the book, with its names and what its tests hold it to.
//
// A test that goes over one of the lists at the end goes over all of its methods.
//
// order and velocity_order hold where the force does not depend on the velocity, the drag_ ones
// where it does. Limits: c h on drag and h omega on an undamped spring have to stay below; 0 is
// never stable there, `always` has no limit. Those of Yoshida 4 and Dormand-Prince are their own
// polynomials' and have no closed form: the tests that use them derive them.
#pragma once
#include <limits>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "measure/implicit_methods.h"
#include "measure/linear_methods.h"
#include "measure/methods.h"
#include "measure/methods_with_memory.h"

/// Every method of the book, each as a type.
namespace list {

inline constexpr double always = std::numeric_limits<double>::infinity();  ///< no limit
inline constexpr long as_needed = -1;  ///< evaluations of a method that iterates

struct Euler {
  static constexpr std::string_view name = "Euler", function = "euler";
  static constexpr auto step = measure::euler;
  static constexpr std::string_view header = "euler.h";
  static constexpr int order = 1, velocity_order = 1, drag_order = 1, drag_velocity_order = 1;
  static constexpr long evaluations = 1;
  static constexpr double drag_limit = 2, spring_limit = 0;
};

struct ConstantAcceleration {
  static constexpr std::string_view name = "constant acceleration",
                                    function = "constant_acceleration";
  static constexpr auto step = measure::constant_acceleration;
  static constexpr std::string_view header = "constant_acceleration.h";
  static constexpr int order = 1, velocity_order = 1, drag_order = 1, drag_velocity_order = 1;
  static constexpr long evaluations = 1;
  static constexpr double drag_limit = 2, spring_limit = 0;
};

struct SymplecticEuler {
  static constexpr std::string_view name = "symplectic Euler", function = "symplectic_euler";
  static constexpr auto step = measure::symplectic_euler;
  static constexpr std::string_view header = "symplectic_euler.h";
  static constexpr int order = 1, velocity_order = 1, drag_order = 1, drag_velocity_order = 1;
  static constexpr long evaluations = 1;
  static constexpr double drag_limit = 2, spring_limit = 2;
};

struct SymplecticEulerPositionFirst {
  static constexpr std::string_view name = "symplectic Euler, position first",
                                    function = "symplectic_euler_position_first";
  static constexpr auto step = measure::symplectic_euler_position_first;
  static constexpr std::string_view header = "symplectic_euler.h";
  static constexpr int order = 1, velocity_order = 1, drag_order = 1, drag_velocity_order = 1;
  static constexpr long evaluations = 1;
  static constexpr double drag_limit = 2, spring_limit = 2;
};

struct Midpoint {
  static constexpr std::string_view name = "midpoint", function = "midpoint";
  static constexpr auto step = measure::midpoint;
  static constexpr std::string_view header = "midpoint.h";
  static constexpr int order = 2, velocity_order = 2, drag_order = 2, drag_velocity_order = 2;
  static constexpr long evaluations = 2;
  static constexpr double drag_limit = 2, spring_limit = 0;
};

struct Heun {
  static constexpr std::string_view name = "Heun", function = "heun";
  static constexpr auto step = measure::heun;
  static constexpr std::string_view header = "heun.h";
  static constexpr int order = 2, velocity_order = 2, drag_order = 2, drag_velocity_order = 2;
  static constexpr long evaluations = 2;
  static constexpr double drag_limit = 2, spring_limit = 0;
};

struct Rk4 {
  static constexpr std::string_view name = "RK4", function = "rk4";
  static constexpr auto step = measure::rk4;
  static constexpr std::string_view header = "rk4.h";
  static constexpr int order = 4, velocity_order = 4, drag_order = 4, drag_velocity_order = 4;
  static constexpr long evaluations = 4;
  static constexpr double drag_limit = 2.785293563405282, spring_limit = 2.8284271247461903;
};

struct PredictedEuler {
  static constexpr std::string_view name = "predicted Euler", function = "predicted_euler";
  static constexpr auto step = measure::predicted_euler<1>;
  static constexpr std::string_view header = "predicted_euler.h";
  static constexpr int order = 1, velocity_order = 1, drag_order = 1, drag_velocity_order = 1;
  static constexpr long evaluations = 2;
  static constexpr double drag_limit = 1, spring_limit = 1;
};

struct StormerVerlet {
  static constexpr std::string_view name = "Störmer–Verlet", function = "stormer_verlet";
  static constexpr auto step = measure::stormer_verlet;
  static constexpr std::string_view header = "stormer_verlet.h";
  static constexpr int order = 2, velocity_order = 1, drag_order = 1, drag_velocity_order = 1;
  static constexpr long evaluations = 1;
  static constexpr double drag_limit = 2, spring_limit = 2;
};

struct StormerVerletCarried {
  static constexpr std::string_view name = "Störmer–Verlet, carried",
                                    function = "stormer_verlet_carried";
  static constexpr auto step = measure::stormer_verlet_carried;
  static constexpr std::string_view header = "stormer_verlet.h";
  static constexpr int order = 2, velocity_order = 2, drag_order = 2, drag_velocity_order = 2;
  static constexpr long evaluations = 1;
  static constexpr double drag_limit = 1, spring_limit = 2;
};

struct StormerVerletUneven {
  static constexpr std::string_view name = "Störmer–Verlet, uneven",
                                    function = "stormer_verlet_uneven";
  static constexpr auto step = measure::stormer_verlet_uneven;
  static constexpr std::string_view header = "stormer_verlet.h";
  static constexpr int order = 2, velocity_order = 1, drag_order = 1, drag_velocity_order = 1;
  static constexpr long evaluations = 1;
  static constexpr double drag_limit = 2, spring_limit = 2;
};

struct Leapfrog {
  static constexpr std::string_view name = "leapfrog", function = "leapfrog";
  static constexpr auto step = measure::leapfrog;
  static constexpr std::string_view header = "leapfrog.h";
  static constexpr int order = 2, velocity_order = 2, drag_order = 1, drag_velocity_order = 1;
  static constexpr long evaluations = 1;
  static constexpr double drag_limit = 2, spring_limit = 2;
};

struct VelocityVerlet {
  static constexpr std::string_view name = "velocity Verlet", function = "velocity_verlet";
  static constexpr auto step = measure::velocity_verlet;
  static constexpr std::string_view header = "velocity_verlet.h";
  static constexpr int order = 2, velocity_order = 2, drag_order = 2, drag_velocity_order = 2;
  static constexpr long evaluations = 1;
  static constexpr double drag_limit = 1, spring_limit = 2;
};

struct Yoshida4 {
  static constexpr std::string_view name = "Yoshida 4", function = "yoshida4";
  static constexpr auto step = measure::yoshida4;
  static constexpr std::string_view header = "yoshida4.h";
  static constexpr int order = 4, velocity_order = 4, drag_order = 2, drag_velocity_order = 2;
  static constexpr long evaluations = 3;
  static constexpr double drag_limit = 0.912983, spring_limit = 1.573401;
};

struct Dopri5 {
  static constexpr std::string_view name = "Dormand-Prince", function = "dopri5";
  static constexpr auto step = measure::dopri5;
  static constexpr std::string_view header = "dopri5.h";
  static constexpr int order = 5, velocity_order = 5, drag_order = 5, drag_velocity_order = 5;
  static constexpr long evaluations = 6;
  static constexpr double drag_limit = 3.306567, spring_limit = 0.997189;
};

struct BackwardEuler {
  static constexpr std::string_view name = "backward Euler", function = "backward_euler";
  static constexpr auto step = measure::backward_euler;
  static constexpr std::string_view header = "backward_euler.h";
  static constexpr int order = 1, velocity_order = 1, drag_order = 1, drag_velocity_order = 1;
  static constexpr long evaluations = 1;
  static constexpr double drag_limit = always, spring_limit = always;
};

struct BackwardEulerNewton {
  static constexpr std::string_view name = "backward Euler, to the end",
                                    function = "backward_euler_newton";
  static constexpr auto step = measure::backward_euler_newton;
  static constexpr std::string_view header = "backward_euler.h";
  static constexpr int order = 1, velocity_order = 1, drag_order = 1, drag_velocity_order = 1;
  static constexpr long evaluations = as_needed;
  static constexpr double drag_limit = always, spring_limit = always;
};

struct Trapezoid {
  static constexpr std::string_view name = "trapezoid", function = "trapezoid";
  static constexpr auto step = measure::trapezoid;
  static constexpr std::string_view header = "trapezoid.h";
  static constexpr int order = 2, velocity_order = 2, drag_order = 2, drag_velocity_order = 2;
  static constexpr long evaluations = 2;
  static constexpr double drag_limit = always, spring_limit = always;
};

struct TrapezoidNewton {
  static constexpr std::string_view name = "trapezoid, to the end", function = "trapezoid_newton";
  static constexpr auto step = measure::trapezoid_newton;
  static constexpr std::string_view header = "trapezoid.h";
  static constexpr int order = 2, velocity_order = 2, drag_order = 2, drag_velocity_order = 2;
  static constexpr long evaluations = as_needed;
  static constexpr double drag_limit = always, spring_limit = always;
};

// On a spring or a drag alone.
struct BackwardEulerSpring {
  static constexpr std::string_view name = "backward Euler on a spring",
                                    function = "backward_euler_spring";
  static constexpr auto step = measure::backward_euler_spring;
  static constexpr std::string_view header = "backward_euler_spring.h";
};

struct Rk4Linear {
  static constexpr std::string_view name = "RK4, folded", function = "rk4_linear";
  static constexpr auto step = measure::rk4_linear;
  static constexpr std::string_view header = "rk4_linear.h";
};

struct SpringExact {
  static constexpr std::string_view name = "exact step of a spring", function = "spring_exact";
  static constexpr auto step = measure::spring_exact;
  static constexpr std::string_view header = "spring_exact.h";
};

struct LinearDampingExplicitLast {
  static constexpr std::string_view name = "symplectic Euler, drag by its rate",
                                    function = "linear_damping_explicit_last";
  static constexpr auto step = measure::linear_damping_explicit_last;
  static constexpr std::string_view header = "linear_damping.h";
};

struct LinearDampingExplicitFirst {
  static constexpr std::string_view name = "symplectic Euler, drag by its rate, first",
                                    function = "linear_damping_explicit_first";
  static constexpr auto step = measure::linear_damping_explicit_first;
  static constexpr std::string_view header = "linear_damping.h";
};

struct LinearDampingImplicitLast {
  static constexpr std::string_view name = "symplectic Euler, drag divided",
                                    function = "linear_damping_implicit_last";
  static constexpr auto step = measure::linear_damping_implicit_last;
  static constexpr std::string_view header = "linear_damping.h";
};

struct LinearDampingImplicitFirst {
  static constexpr std::string_view name = "symplectic Euler, drag divided first",
                                    function = "linear_damping_implicit_first";
  static constexpr auto step = measure::linear_damping_implicit_first;
  static constexpr std::string_view header = "linear_damping.h";
};

struct LinearDampingExponentialLast {
  static constexpr std::string_view name = "symplectic Euler, drag by its exponential",
                                    function = "linear_damping_exponential_last";
  static constexpr auto step = measure::linear_damping_exponential_last;
  static constexpr std::string_view header = "linear_damping.h";
};

struct LinearDampingExponentialFirst {
  static constexpr std::string_view name = "symplectic Euler, drag by its exponential, first",
                                    function = "linear_damping_exponential_first";
  static constexpr auto step = measure::linear_damping_exponential_first;
  static constexpr std::string_view header = "linear_damping.h";
};

struct LinearDampingExact {
  static constexpr std::string_view name = "symplectic Euler, drag exact",
                                    function = "linear_damping_exact";
  static constexpr auto step = measure::linear_damping_exact;
  static constexpr std::string_view header = "linear_damping.h";
};

/// The explicit methods that take any acceleration.
using EveryExplicit =
    std::tuple<Euler, ConstantAcceleration, SymplecticEuler, SymplecticEulerPositionFirst, Midpoint,
               Heun, Rk4, PredictedEuler, StormerVerlet, StormerVerletCarried, StormerVerletUneven,
               Leapfrog, VelocityVerlet, Yoshida4, Dopri5>;

/// The methods that take any acceleration, and its Jacobian.
using EveryImplicit = std::tuple<BackwardEuler, BackwardEulerNewton, Trapezoid, TrapezoidNewton>;

/// The methods for one damped spring alone.
using EveryOnSprings = std::tuple<BackwardEulerSpring, Rk4Linear, SpringExact>;

/// The methods that take linear damping apart from the other forces.
using EveryDamping =
    std::tuple<LinearDampingExplicitLast, LinearDampingExplicitFirst, LinearDampingImplicitLast,
               LinearDampingImplicitFirst, LinearDampingExponentialLast,
               LinearDampingExponentialFirst, LinearDampingExact>;

// Compiled with -DONLY=Rk4, the lists hold that method alone. A list without it stays whole, since
// Catch2 takes no empty ones.
#ifdef ONLY
template <class List>
struct Chosen;

template <class... Methods>
struct Chosen<std::tuple<Methods...>> {
  using Those = decltype(std::tuple_cat(
      std::conditional_t<std::is_same_v<Methods, ONLY>, std::tuple<Methods>, std::tuple<>>()...));
  using List =
      std::conditional_t<std::is_same_v<Those, std::tuple<>>, std::tuple<Methods...>, Those>;
};
/// All methods of a list, or the chosen one.
template <class List>
using chosen = typename Chosen<List>::List;
#else
/// All methods of a list, or the chosen one.
template <class List>
using chosen = List;
#endif

using Explicit = chosen<EveryExplicit>;    ///< those to go over
using Implicit = chosen<EveryImplicit>;    ///< those to go over
using OnSprings = chosen<EveryOnSprings>;  ///< those to go over
using Damping = chosen<EveryDamping>;      ///< those to go over

/// All that take any acceleration; the implicit ones want its Jacobian as well.
using General = chosen<decltype(std::tuple_cat(EveryExplicit(), EveryImplicit()))>;

}  // namespace list
