// SPDX-License-Identifier: MIT-0
#pragma once

template <class Try>
void call_yoshida4(Try& attempt) {
  attempt("yoshida4", [](auto& x, auto& v, auto t, auto h, auto& acceleration) {
    auto a = integrate::yoshida4_start(x, v, t, acceleration);
    integrate::yoshida4(x, v, a, t, h, acceleration);
    integrate::yoshida4(x, v, a, t + decltype(t)(h), h, acceleration);
  });
}
