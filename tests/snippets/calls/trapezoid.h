// SPDX-License-Identifier: MIT-0
#pragma once
#include <cassert>

template <class Try>
void call_trapezoid(Try& attempt) {
  attempt("trapezoid", [](auto& x, auto& v, auto t, auto h, auto& scene) {
    const bool solved = integrate::trapezoid(x, v, t, h, scene, scene.solve);
    assert(solved);
  });
  attempt("trapezoid_newton", [](auto& x, auto& v, auto t, auto h, auto& scene) {
    const auto norm = [&](const auto& change) { return scene.norm(change); };
    const auto tolerance = decltype(h)(0.001);
    const int iterations =
        integrate::trapezoid_newton(x, v, t, h, scene, scene.solve, norm, tolerance);
    assert(iterations > 0);
  });
}
