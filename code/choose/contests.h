// SPDX-License-Identifier: MIT-0
/// @file
/// The contests of the scenes that this book and `choose` have, compiled once.
#pragma once
#include "choose/contest.h"
#include "scenes/linear_drag.h"
#include "scenes/orbit.h"
#include "scenes/pendulum.h"
#include "scenes/spring.h"
#include "scenes/toss.h"

/// The ball of `choose`, thrown up as fast as chapter 7's jump is.
inline constexpr scenes::Toss thrown_ball(5);

extern template Contest contest(const scenes::Spring<>&, const Bounds&);
extern template Contest contest(const scenes::Orbit<>&, const Bounds&);
extern template Contest contest(const scenes::Pendulum<>&, const Bounds&);
extern template Contest contest(const scenes::LinearDrag<>&, const Bounds&);
extern template Contest contest(const scenes::Toss&, const Bounds&);

extern template Contest full_contest(const scenes::Spring<>&, const Bounds&, const Tell&);
extern template Contest full_contest(const scenes::Orbit<>&, const Bounds&, const Tell&);
extern template Contest full_contest(const scenes::Pendulum<>&, const Bounds&, const Tell&);
extern template Contest full_contest(const scenes::LinearDrag<>&, const Bounds&, const Tell&);
extern template Contest full_contest(const scenes::Toss&, const Bounds&, const Tell&);
