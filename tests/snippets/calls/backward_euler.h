// SPDX-License-Identifier: MIT-0
#pragma once
#include <cassert>

template <class Try>
void call_backward_euler(Try& attempt) {
  attempt("backward_euler", [](auto& x, auto& v, auto t, auto h, auto& scene) {
    const bool solved = integrate::backward_euler(x, v, t, h, scene, scene.solve);
    assert(solved);
  });
  attempt("backward_euler_newton", [](auto& x, auto& v, auto t, auto h, auto& scene) {
    const auto norm = [&](const auto& change) { return scene.norm(change); };
    const auto tolerance = decltype(h)(0.001);
    const int iterations =
        integrate::backward_euler_newton(x, v, t, h, scene, scene.solve, norm, tolerance);
    assert(iterations > 0);
  });
}
