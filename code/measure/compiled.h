// SPDX-License-Identifier: MIT-0
/// @file
/// Every method behind one type, compiled once.
#pragma once
#include <array>
#include <cstddef>
#include <tuple>
#include <type_traits>

#include "measure/method.h"
#include "measure/methods.h"

namespace measure {

/// As many as a list has.
template <class List>
using CompiledOf = std::array<Method, std::tuple_size_v<List>>;

/// The ones for one kind of force alone.
using EveryLinear = list::Joined<list::EveryOnSprings, list::EveryDamping>;

extern const CompiledOf<list::EveryExplicit> compiled_explicit;  ///< as in the list
extern const CompiledOf<list::EveryImplicit> compiled_implicit;  ///< as in the list
extern const CompiledOf<EveryLinear> compiled_linear;            ///< as in the list

/// Where a method stands in a list.
template <class Method, class... Methods>
constexpr std::size_t place_in(std::tuple<Methods...>) {
  std::size_t place = 0;
  (void)((std::is_same_v<Method, Methods> || (++place, false)) || ...);
  return place;
}

/// A method behind one type.
template <class Listed>
constexpr const Method& find_compiled() {
  if constexpr (list::is_in<Listed>(list::EveryExplicit())) {
    return compiled_explicit[place_in<Listed>(list::EveryExplicit())];
  } else if constexpr (list::is_in<Listed>(list::EveryImplicit())) {
    return compiled_implicit[place_in<Listed>(list::EveryImplicit())];
  } else {
    static_assert(list::is_in<Listed>(EveryLinear()), "the method stands in none of the lists");
    return compiled_linear[place_in<Listed>(EveryLinear())];
  }
}

/// A method behind one type.
template <class Listed>
inline constexpr const Method& compiled = find_compiled<Listed>();

/// All methods of a list behind one type.
template <class... Methods>
constexpr std::array<const Method*, sizeof...(Methods)> all_compiled(std::tuple<Methods...>) {
  return {&compiled<Methods>...};
}

}  // namespace measure

/// The methods that programs name, each behind the same type.
namespace method {

/// Euler.
inline constexpr const measure::Method& euler = measure::compiled<measure::Euler>;
/// Constant acceleration.
inline constexpr const measure::Method& constant_acceleration =
    measure::compiled<measure::ConstantAcceleration>;
/// Symplectic Euler.
inline constexpr const measure::Method& symplectic_euler =
    measure::compiled<measure::SymplecticEuler>;
/// Midpoint.
inline constexpr const measure::Method& midpoint = measure::compiled<measure::Midpoint>;
/// Heun.
inline constexpr const measure::Method& heun = measure::compiled<measure::Heun>;
/// RK4.
inline constexpr const measure::Method& rk4 = measure::compiled<measure::Rk4>;
/// Predicted Euler.
inline constexpr const measure::Method& predicted_euler =
    measure::compiled<measure::PredictedEuler>;
/// Störmer–Verlet.
inline constexpr const measure::Method& stormer_verlet = measure::compiled<measure::StormerVerlet>;
/// Leapfrog.
inline constexpr const measure::Method& leapfrog = measure::compiled<measure::Leapfrog>;
/// Velocity Verlet.
inline constexpr const measure::Method& velocity_verlet =
    measure::compiled<measure::VelocityVerlet>;
/// Yoshida 4.
inline constexpr const measure::Method& yoshida4 = measure::compiled<measure::Yoshida4>;
/// Dormand-Prince.
inline constexpr const measure::Method& dopri5 = measure::compiled<measure::Dopri5>;
/// Backward Euler.
inline constexpr const measure::Method& backward_euler = measure::compiled<measure::BackwardEuler>;
/// Backward Euler, to the end.
inline constexpr const measure::Method& backward_euler_newton =
    measure::compiled<measure::BackwardEulerNewton>;
/// Trapezoid.
inline constexpr const measure::Method& trapezoid = measure::compiled<measure::Trapezoid>;
/// Trapezoid, to the end.
inline constexpr const measure::Method& trapezoid_newton =
    measure::compiled<measure::TrapezoidNewton>;
/// BDF2.
inline constexpr const measure::Method& bdf2 = measure::compiled<measure::Bdf2>;
/// Backward Euler on a spring.
inline constexpr const measure::Method& backward_euler_spring =
    measure::compiled<measure::BackwardEulerSpring>;
/// Exact step of a spring.
inline constexpr const measure::Method& spring_exact = measure::compiled<measure::SpringExact>;
/// Exact step of a spring, folded.
inline constexpr const measure::Method& spring_folded = measure::compiled<measure::SpringFolded>;
/// Symplectic Euler, drag by its rate.
inline constexpr const measure::Method& linear_damping_explicit_last =
    measure::compiled<measure::LinearDampingExplicitLast>;
/// Symplectic Euler, drag by its rate, first.
inline constexpr const measure::Method& linear_damping_explicit_first =
    measure::compiled<measure::LinearDampingExplicitFirst>;
/// Symplectic Euler, drag divided.
inline constexpr const measure::Method& linear_damping_implicit_last =
    measure::compiled<measure::LinearDampingImplicitLast>;
/// Symplectic Euler, drag divided first.
inline constexpr const measure::Method& linear_damping_implicit_first =
    measure::compiled<measure::LinearDampingImplicitFirst>;
/// Symplectic Euler, drag by its exponential.
inline constexpr const measure::Method& linear_damping_exponential_last =
    measure::compiled<measure::LinearDampingExponentialLast>;
/// Symplectic Euler, drag by its exponential, first.
inline constexpr const measure::Method& linear_damping_exponential_first =
    measure::compiled<measure::LinearDampingExponentialFirst>;
/// Symplectic Euler, drag exact.
inline constexpr const measure::Method& linear_damping_exact =
    measure::compiled<measure::LinearDampingExact>;

}  // namespace method
