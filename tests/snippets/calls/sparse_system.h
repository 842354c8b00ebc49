// SPDX-License-Identifier: MIT-0
#pragma once

template <class Try>
void call_sparse_system(Try& attempt) {
  attempt("SparseSystem",
          [](auto jacobian) { return integrate::SparseSystem<decltype(jacobian)>(jacobian); });
}
