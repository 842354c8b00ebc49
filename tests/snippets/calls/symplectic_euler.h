// SPDX-License-Identifier: MIT-0
#pragma once

template <class Try>
void call_symplectic_euler(Try& attempt) {
  attempt("symplectic_euler", [](auto& x, auto& v, auto t, auto h, auto& acceleration) {
    integrate::symplectic_euler(x, v, t, h, acceleration);
  });
  attempt("symplectic_euler_position_first",
          [](auto& x, auto& v, auto t, auto h, auto& acceleration) {
            integrate::symplectic_euler_position_first(x, v, t, h, acceleration);
          });
}
