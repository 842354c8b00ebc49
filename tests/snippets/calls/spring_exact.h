// SPDX-License-Identifier: MIT-0
#pragma once

template <class Try>
void call_spring_exact(Try& attempt) {
  attempt("spring_exact", [](auto& x, auto& v, auto, auto h, auto&) {
    integrate::spring_exact(x, v, h, decltype(h)(omega), decltype(h)(zeta));
  });
}
