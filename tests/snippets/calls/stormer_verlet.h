// SPDX-License-Identifier: MIT-0
#pragma once

template <class Try>
void call_stormer_verlet(Try& attempt) {
  attempt("stormer_verlet", [](auto& x, auto& v, auto t, auto h, auto& acceleration) {
    auto x_previous = integrate::stormer_verlet_start(x, v, t, h, acceleration);
    integrate::stormer_verlet(x, x_previous, t, h, acceleration);
    v = integrate::stormer_verlet_velocity(x, x_previous, h);
  });
  attempt("stormer_verlet_carried", [](auto& x, auto& v, auto t, auto h, auto& acceleration) {
    auto x_previous = integrate::stormer_verlet_start(x, v, t, h, acceleration);
    auto a = acceleration(x, v, t);
    integrate::stormer_verlet_carried(x, x_previous, a, t, h, acceleration);
    v = integrate::stormer_verlet_carried_velocity(x, x_previous, a, h);
  });
  attempt("stormer_verlet_distance", [](auto& x, auto& v, auto t, auto h, auto& acceleration) {
    auto distance = integrate::stormer_verlet_distance_start(x, v, t, h, acceleration);
    integrate::stormer_verlet_distance(x, distance, t, h, acceleration);
    v = (1 / h) * distance;
  });
  attempt("stormer_verlet_uneven", [](auto& x, auto& v, auto t, auto h, auto& acceleration) {
    auto x_previous = integrate::stormer_verlet_start(x, v, t, h, acceleration);
    const auto next = h / 2;
    integrate::stormer_verlet_uneven(x, x_previous, t, next, h, acceleration);
    v = integrate::stormer_verlet_velocity(x, x_previous, next);
  });
}
