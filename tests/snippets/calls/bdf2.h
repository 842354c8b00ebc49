// SPDX-License-Identifier: MIT-0
#pragma once
#include <cassert>

template <class Try>
void call_bdf2(Try& attempt) {
  attempt("bdf2", [](auto& x, auto& v, auto t, auto h, auto& scene) {
    auto previous = integrate::bdf2_start(x, v, t, h, scene);
    const auto next = h / 2;
    const bool first = integrate::bdf2(x, v, previous, t, h, h, scene, scene.solve);
    const bool second =
        integrate::bdf2(x, v, previous, t + decltype(t)(h), next, h, scene, scene.solve);
    assert(first && second);
  });
  attempt("bdf2_newton", [](auto& x, auto& v, auto t, auto h, auto& scene) {
    auto previous = integrate::bdf2_start(x, v, t, h, scene);
    const auto norm = [&](const auto& change) { return scene.norm(change); };
    const auto tolerance = decltype(h)(0.001);
    const int iterations =
        integrate::bdf2_newton(x, v, previous, t, h, h, scene, scene.solve, norm, tolerance);
    assert(iterations > 0);
  });
}
