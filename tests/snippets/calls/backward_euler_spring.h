// SPDX-License-Identifier: MIT-0
#pragma once

template <class Try>
void call_backward_euler_spring(Try& attempt) {
  attempt("backward_euler_spring", [](auto& x, auto& v, auto, auto h, auto&) {
    integrate::backward_euler_spring(x, v, h, decltype(h)(omega), decltype(h)(zeta));
  });
}
