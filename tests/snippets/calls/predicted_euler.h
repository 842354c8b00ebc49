// SPDX-License-Identifier: MIT-0
#pragma once

template <class Try>
void call_predicted_euler(Try& attempt) {
  attempt("predicted_euler", [](auto& x, auto& v, auto t, auto h, auto& acceleration) {
    integrate::predicted_euler(x, v, t, h, acceleration);
    integrate::predicted_euler(x, v, t + decltype(t)(h), h, acceleration, 3);
  });
}
