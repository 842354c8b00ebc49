// SPDX-License-Identifier: MIT-0
#pragma once

template <class Try>
void call_midpoint(Try& attempt) {
  attempt("midpoint", [](auto& x, auto& v, auto t, auto h, auto& acceleration) {
    integrate::midpoint(x, v, t, h, acceleration);
  });
}
