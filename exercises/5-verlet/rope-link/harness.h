// SPDX-License-Identifier: MIT-0
#pragma once

const harness::Wanted<void(Vec& a, Vec& b, double rest, double inverse_a, double inverse_b)>
    wanted = pull;

inline void pull_once(harness::Call& call) {
  Vec a = call.vector(), b = call.vector();
  const double rest = call.number(), inverse_a = call.number(), inverse_b = call.number();
  wanted(a, b, rest, inverse_a, inverse_b);
  call.answer(a);
  call.answer(b);
}

// A chain of four links that starts at rest; answers with its lowest point after each step.
inline void let_fall(harness::Call& call) {
  constexpr std::size_t points = 5;
  std::vector<Vec> x(points);
  for (Vec& point : x) point = call.vector();
  const std::vector<double> inverse = call.numbers(points);
  const double rest = call.number(), h = call.number();
  std::vector<Vec> x_previous = x;
  for (int steps = call.whole_number(); steps > 0; --steps) {
    for (std::size_t i = 0; i < points; ++i) {
      const Vec push = inverse[i] == 0 ? Vec{} : Vec{0, -9.81 * h * h, 0};
      const Vec next = x[i] + (x[i] - x_previous[i]) + push;
      x_previous[i] = x[i];
      x[i] = next;
    }
    for (std::size_t i = 1; i < points; ++i) {
      wanted(x[i - 1], x[i], rest, inverse[i - 1], inverse[i]);
    }
    call.answer(x.back());
  }
}

void answer(harness::Call& call) {
  call.function() == 0 ? pull_once(call) : let_fall(call);
}
