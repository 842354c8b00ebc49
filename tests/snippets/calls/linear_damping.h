// SPDX-License-Identifier: MIT-0
#pragma once

template <class Try>
void call_linear_damping(Try& attempt) {
  attempt("linear_damping_explicit_last", [](auto& x, auto& v, auto t, auto h, auto& acceleration) {
    integrate::linear_damping_explicit_last(x, v, t, h, decltype(h)(damping), acceleration);
  });
  attempt(
      "linear_damping_explicit_first", [](auto& x, auto& v, auto t, auto h, auto& acceleration) {
        integrate::linear_damping_explicit_first(x, v, t, h, decltype(h)(damping), acceleration);
      });
  attempt("linear_damping_implicit_last", [](auto& x, auto& v, auto t, auto h, auto& acceleration) {
    integrate::linear_damping_implicit_last(x, v, t, h, decltype(h)(damping), acceleration);
  });
  attempt(
      "linear_damping_implicit_first", [](auto& x, auto& v, auto t, auto h, auto& acceleration) {
        integrate::linear_damping_implicit_first(x, v, t, h, decltype(h)(damping), acceleration);
      });
  attempt(
      "linear_damping_exponential_last", [](auto& x, auto& v, auto t, auto h, auto& acceleration) {
        integrate::linear_damping_exponential_last(x, v, t, h, decltype(h)(damping), acceleration);
      });
  attempt(
      "linear_damping_exponential_first", [](auto& x, auto& v, auto t, auto h, auto& acceleration) {
        integrate::linear_damping_exponential_first(x, v, t, h, decltype(h)(damping), acceleration);
      });
  attempt("linear_damping_exact", [](auto& x, auto& v, auto t, auto h, auto& acceleration) {
    integrate::linear_damping_exact(x, v, t, h, decltype(h)(damping), acceleration);
  });
}
