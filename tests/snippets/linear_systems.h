// SPDX-License-Identifier: MIT-0
// The solver objects for linear systems, each tried alone.
#pragma once
#include "diagonal.h"
#include "eigen_vectors.h"

struct Attempt {
  int wrong = 0;

  template <class Make>
  void operator()(const char* name, Make make) {
    auto system = make(diagonal);
    using Vec = typename decltype(system)::Vec;
    using Real = typename Vec::Scalar;
    const Real p = Real(-0.01), q = Real(-0.1), numbers[] = {1, -3, 4};
    const Vec start = EigenVectors<Vec>::make(numbers);
    Vec change = start;
    const bool solved = system(start, start, 0.25, p, q, change);
    for (int i = 0; i < 3; ++i) {
      Real alone = numbers[i];
      divide(alone, alone, 0.25, p, q, alone);
      if (solved && std::abs(change[i] - alone) < rounding<Real>()) continue;
      std::printf("%s: %.17g; alone %.17g\n", name, double(change[i]), double(alone));
      ++wrong;
    }
  }
};
