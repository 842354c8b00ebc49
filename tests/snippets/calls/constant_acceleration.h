// SPDX-License-Identifier: MIT-0
#pragma once

template <class Try>
void call_constant_acceleration(Try& attempt) {
  attempt("constant_acceleration", [](auto& x, auto& v, auto t, auto h, auto& acceleration) {
    integrate::constant_acceleration(x, v, t, h, acceleration);
  });
}
