// SPDX-License-Identifier: MIT-0
/// @file
/// The contests of the scenes that this book and `choose` have, compiled once.
#pragma once
#include "contest.h"
#include "level.h"
#include "scenes/linear_drag.h"
#include "scenes/orbit.h"
#include "scenes/pendulum.h"
#include "scenes/spring.h"

extern template Contest contest(const scenes::Spring<>&, const Bounds&);
extern template Contest contest(const scenes::Orbit<>&, const Bounds&);
extern template Contest contest(const scenes::Pendulum<>&, const Bounds&);
extern template Contest contest(const scenes::LinearDrag<>&, const Bounds&);
extern template Contest contest(const Ball&, const Bounds&);

extern template Contest full_contest(const scenes::Spring<>&, const Bounds&);
extern template Contest full_contest(const scenes::Orbit<>&, const Bounds&);
extern template Contest full_contest(const scenes::Pendulum<>&, const Bounds&);
extern template Contest full_contest(const scenes::LinearDrag<>&, const Bounds&);
extern template Contest full_contest(const Ball&, const Bounds&);
