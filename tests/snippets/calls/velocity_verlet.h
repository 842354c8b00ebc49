// SPDX-License-Identifier: MIT-0
#pragma once

template <class Try>
void call_velocity_verlet(Try& attempt) {
  attempt("velocity_verlet", [](auto& x, auto& v, auto t, auto h, auto& acceleration) {
    auto a = integrate::velocity_verlet_start(x, v, t, acceleration);
    integrate::velocity_verlet(x, v, a, t, h, acceleration);
    integrate::velocity_verlet(x, v, a, t + decltype(t)(h), h, acceleration);
  });
}
