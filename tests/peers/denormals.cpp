// SPDX-License-Identifier: MIT-0
// Springs that have all but come to rest: numbers too small to keep all of their digits.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "integrate/symplectic_euler.h"
#include "rows.h"
#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace {

constexpr long steps = 200;
constexpr std::size_t count = 1024;
constexpr double smallest_normal = std::numeric_limits<double>::min();
constexpr double tiny = smallest_normal / 1024;

using Springs = std::array<double, count>;

/// The farthest that a spring is out at the end.
double swing(double start) {
  Springs x, v;
  x.fill(start);
  v.fill(0);
  const auto pull = [](double at, double, double) { return -4 * at; };
  for (long n = 0; n < steps; ++n) {
    for (std::size_t i = 0; i < count; ++i) {
      integrate::symplectic_euler(x[i], v[i], 0.0, 1 / 60.0, pull);
    }
  }
  return std::abs(*std::ranges::max_element(x, {}, [](double at) { return std::abs(at); }));
}

#ifdef __SSE2__
constexpr bool can_flush = true;

/// With the processor told to take such numbers, and to give them, as 0. Volatile, or else the
/// compiler would see no reason not to swing before the switch.
double swing_flushed(double start) {
  constexpr unsigned flush = 0x8040;
  const unsigned before = _mm_getcsr();
  _mm_setcsr(before | flush);
  const volatile double from = start;
  const volatile double end = swing(from);
  _mm_setcsr(before);
  return end;
}
#else
constexpr bool can_flush = false;
double swing_flushed(double) {
  return 0;
}
#endif

bool are_what_they_are_called() {
  const double normal = swing(1), denormal = swing(tiny), flushed = swing_flushed(tiny);
  if (normal > smallest_normal && denormal > 0 && denormal < smallest_normal && flushed == 0) {
    return true;
  }
  std::fprintf(stderr, "springs at rest: normal %g, denormal %g, flushed %g\n", normal, denormal,
               flushed);
  return false;
}

void add(const peers::Row& row, double (*run)(double), double start) {
  peers::add_row(row, steps * long(count), [run, start] { benchmark::DoNotOptimize(run(start)); });
}

}  // namespace

int main(int argument_count, char** arguments) {
  if (!are_what_they_are_called()) return 1;
  const std::string group = "1024 springs near rest";
  add({group, "normal numbers", ""}, swing, 1);
  add({group, "denormal numbers", "trap on many processors, not on all"}, swing, tiny);
  const peers::Row flushed{group, "denormal numbers, flushed to 0", "a switch of the processor"};
  if (can_flush) {
    add(flushed, swing_flushed, tiny);
  } else {
    peers::lacks_row({group, flushed.variant, "Known here for x86 only."});
  }
  return peers::measure_rows(argument_count, arguments);
}
