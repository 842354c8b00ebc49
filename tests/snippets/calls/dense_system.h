// SPDX-License-Identifier: MIT-0
#pragma once

template <class Try>
void call_dense_system(Try& attempt) {
  attempt("DenseSystem",
          [](auto jacobian) { return integrate::DenseSystem<decltype(jacobian)>(jacobian); });
}
