// SPDX-License-Identifier: MIT-0
#pragma once

template <class Try>
void call_band_system(Try& attempt) {
  attempt("BandSystem",
          [](auto jacobian) { return integrate::BandSystem<1, decltype(jacobian)>(jacobian); });
}
