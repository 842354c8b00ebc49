// RUNTIME_ERROR: walks through the folders above
// SPDX-License-Identifier: MIT-0
#pragma once
#include <filesystem>
#include <iostream>
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  for (const auto& next : std::filesystem::recursive_directory_iterator("../.."))
    std::cerr << next.path() << '\n';
}
