// SPDX-License-Identifier: MIT-0
#pragma once

template <class Try>
void call_euler(Try& attempt) {
  attempt("euler", [](auto& x, auto& v, auto t, auto h, auto& acceleration) {
    integrate::euler(x, v, t, h, acceleration);
  });
}
