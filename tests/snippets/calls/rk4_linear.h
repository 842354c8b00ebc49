// SPDX-License-Identifier: MIT-0
#pragma once

template <class Try>
void call_rk4_linear(Try& attempt) {
  attempt("rk4_linear", [](auto& x, auto& v, auto, auto h, auto&) {
    using Real = decltype(h);
    const auto step = integrate::rk4_linear_start(Real(stiffness), Real(damping), h);
    integrate::rk4_linear(x, v, step);
  });
}
