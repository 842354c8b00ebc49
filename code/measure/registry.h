// SPDX-License-Identifier: MIT-0
/// @file
/// Every method of the list, compiled once.
#pragma once
#include "measure/method.h"

/// The methods, each behind the same type.
namespace method {

extern const measure::Method euler;                            ///< Euler
extern const measure::Method constant_acceleration;            ///< constant acceleration
extern const measure::Method symplectic_euler;                 ///< symplectic Euler
extern const measure::Method symplectic_euler_position_first;  ///< symplectic Euler, position first
extern const measure::Method midpoint;                         ///< midpoint
extern const measure::Method heun;                             ///< Heun
extern const measure::Method rk4;                              ///< RK4
extern const measure::Method predicted_euler;                  ///< predicted Euler
extern const measure::Method stormer_verlet;                   ///< Störmer–Verlet
extern const measure::Method stormer_verlet_carried;           ///< Störmer–Verlet, carried
extern const measure::Method stormer_verlet_uneven;            ///< Störmer–Verlet, uneven
extern const measure::Method leapfrog;                         ///< leapfrog
extern const measure::Method velocity_verlet;                  ///< velocity Verlet
extern const measure::Method yoshida4;                         ///< Yoshida 4
extern const measure::Method dopri5;                           ///< Dormand-Prince

extern const measure::Method backward_euler;         ///< backward Euler
extern const measure::Method backward_euler_newton;  ///< backward Euler, to the end
extern const measure::Method trapezoid;              ///< trapezoid
extern const measure::Method trapezoid_newton;       ///< trapezoid, to the end

extern const measure::Method backward_euler_spring;         ///< backward Euler on a spring
extern const measure::Method rk4_linear;                    ///< RK4, folded
extern const measure::Method spring_exact;                  ///< exact step of a spring
extern const measure::Method linear_damping_explicit_last;  ///< symplectic Euler, drag by its rate
extern const measure::Method
    linear_damping_explicit_first;  ///< symplectic Euler, drag by its rate, first
extern const measure::Method linear_damping_implicit_last;  ///< symplectic Euler, drag divided
extern const measure::Method
    linear_damping_implicit_first;  ///< symplectic Euler, drag divided first
extern const measure::Method
    linear_damping_exponential_last;  ///< symplectic Euler, drag by its exponential
extern const measure::Method
    linear_damping_exponential_first;  ///< symplectic Euler, drag by its exponential, first
extern const measure::Method linear_damping_exact;  ///< symplectic Euler, drag exact

}  // namespace method
