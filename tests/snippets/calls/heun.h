// SPDX-License-Identifier: MIT-0
#pragma once

template <class Try>
void call_heun(Try& attempt) {
  attempt("heun", [](auto& x, auto& v, auto t, auto h, auto& acceleration) {
    integrate::heun(x, v, t, h, acceleration);
  });
}
