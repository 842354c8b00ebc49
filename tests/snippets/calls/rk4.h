// SPDX-License-Identifier: MIT-0
#pragma once

template <class Try>
void call_rk4(Try& attempt) {
  attempt("rk4", [](auto& x, auto& v, auto t, auto h, auto& acceleration) {
    integrate::rk4(x, v, t, h, acceleration);
  });
}
