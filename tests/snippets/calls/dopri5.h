// SPDX-License-Identifier: MIT-0
#pragma once
#include <cassert>

template <class Try>
void call_dopri5(Try& attempt) {
  attempt("dopri5", [](auto& x, auto& v, auto t, auto h, auto& acceleration) {
    auto a = integrate::dopri5_start(x, v, t, acceleration);
    integrate::dopri5(x, v, a, t, h, acceleration);
    const auto error = integrate::dopri5(x, v, a, t + h, h, acceleration);
    x = x + error.x;
    v = v + error.v;
  });
  attempt("dopri5_adaptive", [](auto& x, auto& v, auto t, auto h, auto& scene) {
    const auto norm = [&](const auto& error) { return scene.norm(error); };
    const decltype(h) wide = 1000;  // so that all vectors take the same two steps
    auto first = h / 4;
    const bool arrived = integrate::dopri5_adaptive(x, v, t, h, first, scene, norm, wide);
    assert(arrived);
  });
}
