// SPDX-License-Identifier: MIT-0
#pragma once

template <class Try>
void call_leapfrog(Try& attempt) {
  attempt("leapfrog", [](auto& x, auto& v, auto t, auto h, auto& acceleration) {
    auto v_half = integrate::leapfrog_start(x, v, t, h, acceleration);
    integrate::leapfrog(x, v_half, t, h, acceleration);
    v = integrate::leapfrog_velocity(x, v_half, t + decltype(t)(h), h, acceleration);
  });
}
