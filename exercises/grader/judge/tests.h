// SPDX-License-Identifier: MIT-0
/// @file
/// Questions to a student's code. Each of these ends the test with a finding that teaches
/// if the answer is wrong.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "harness/bounds.h"
#include "judge/method.h"
#include "judge/rounding.h"
#include "judge/student.h"

namespace judge {

/// Five coarse steps under forces that only the judge knows are those of the method, in every
/// digit that rounding leaves. Nothing else passes, however accurate it is.
/// @param function  of harness.h, if it is not the first
void is_method(Student& student, const Method& method, const std::string& hint, int function = 0);

inline constexpr harness::Bounds usual_steps{"h", 1e-5, 0.25};

/// And so are steps from where hardly any begins: three bodies, each at any place with any
/// velocity, at rest and at the origin too, take steps of any length by turns, as a game moves its
/// bodies.
/// @param h  lengths of the steps, below zero for steps back
/// @param drag  whether some forces may depend on the velocity
void is_method_everywhere(Student& student, const Method& method, const std::string& hint,
                          int function = 0, const harness::Bounds& h = usual_steps,
                          bool drag = true);

/// The acceleration is evaluated so many times a step, after so many to begin with, and where the
/// method evaluates it in the states that the student's own steps come to.
void evaluates(Student& student, const Method& method, int per_step, int to_begin,
               const std::string& hint, int function = 0);

/// Halving the step divides the error by 2^p, in a force that depends on place, velocity and time.
/// Two-sided, within 0.1, and only where the last two estimates agree within 0.1.
/// @param most_steps  the finest of four runs; the others take a half, a quarter and an eighth
void has_order(Student& student, double p, int most_steps, const std::string& hint,
               int function = 0);

/// On a spring the run moves and stays bounded with a step 2 % below the limit, and blows up with
/// one 2 % above it.
/// @param limit  of h omega
void is_stable_until(Student& student, double zeta, double limit, const std::string& hint,
                     int function = 0);

/// Over many turns of an orbit its energy error goes where the method's goes: drifts as far, sways
/// as far.
/// @param per_turn  steps of each turn
void has_energy_of(Student& student, const Method& method, double eccentricity, int turns,
                   int per_turn, const std::string& hint, int function = 0);

/// There and, in another program, back again, with -h: the start, to rounding.
void runs_backwards(Student& student, const std::string& hint, int function = 0);

/// One number of a formula.
/// @param asked  what the number is, in words
/// @param input  what it was computed from
/// @param tolerance  how far off it may be; rounding(expected) for a short formula
void is_exact(const std::string& asked, const std::string& input, double got, double expected,
              const Tolerance& tolerance, const std::string& hint);

/// A number that must not exceed a bound, such as an error or a count.
void is_at_most(const std::string& asked, const std::string& input, double got,
                const Tolerance& bound, const std::string& hint);

}  // namespace judge
