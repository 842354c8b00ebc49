// SPDX-License-Identifier: MIT-0
#pragma once
#include <cassert>

template <class Try>
void call_dopri5(Try& attempt) {
  attempt("dopri5", [](auto& x, auto& v, auto t, auto h, auto& acceleration) {
    auto a = integrate::dopri5_start(x, v, t, acceleration);
    integrate::dopri5(x, v, a, t, h, acceleration);
    const auto error = integrate::dopri5(x, v, a, t + decltype(t)(h), h, acceleration);
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
  attempt("dopri5 along a path", [](auto& x, auto& v, auto t, auto h, auto& acceleration) {
    auto path = integrate::dopri5_path(x, v, t, h, acceleration);
    integrate::dopri5(path, h / 2, acceleration);
    const auto error = integrate::dopri5(path, h / 2, acceleration);
    const auto end = t + decltype(t)(h / 2 + h / 4);  // within the second half
    x = path.position(end) + error.x;
    v = path.velocity(end) + error.v;
  });
  attempt("dopri5_adaptive along a path", [](auto& x, auto& v, auto t, auto h, auto& scene) {
    const auto norm = [&](const auto& error) { return scene.norm(error); };
    const decltype(h) wide = 1000;
    auto path = integrate::dopri5_path(x, v, t, h / 4, scene);
    const auto end = t + decltype(t)(h);
    const bool arrived = integrate::dopri5_adaptive(path, end, scene, norm, wide, 5'000'000'000);
    assert(arrived && path.holds(end));
    x = path.position(end);
    v = path.velocity(end);
  });
}
