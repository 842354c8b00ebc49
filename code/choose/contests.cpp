// SPDX-License-Identifier: MIT-0
#include "choose/contests.h"

template Contest contest(const scenes::Spring<>&, const Bounds&);
template Contest contest(const scenes::Orbit<>&, const Bounds&);
template Contest contest(const scenes::Pendulum<>&, const Bounds&);
template Contest contest(const scenes::LinearDrag<>&, const Bounds&);
template Contest contest(const scenes::Toss&, const Bounds&);

template Contest full_contest(const scenes::Spring<>&, const Bounds&, const Tell&);
template Contest full_contest(const scenes::Orbit<>&, const Bounds&, const Tell&);
template Contest full_contest(const scenes::Pendulum<>&, const Bounds&, const Tell&);
template Contest full_contest(const scenes::LinearDrag<>&, const Bounds&, const Tell&);
template Contest full_contest(const scenes::Toss&, const Bounds&, const Tell&);
