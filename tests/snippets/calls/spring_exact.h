// SPDX-License-Identifier: MIT-0
#pragma once

template <class Try>
void call_spring_exact(Try& attempt) {
  attempt("spring_exact", [](auto& x, auto& v, auto, auto h, auto&) {
    integrate::spring_exact(x, v, h, decltype(h)(omega), decltype(h)(zeta));
  });
  attempt("spring_folded", [](auto& x, auto& v, auto, auto h, auto&) {
    using Real = decltype(h);
    const auto step = integrate::spring_folded_start(h, Real(omega), Real(zeta));
    integrate::spring_folded(x, v, step);
  });
}
