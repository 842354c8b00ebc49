// SPDX-License-Identifier: MIT-0
#include "integrate/euler.h"

int main() {
  double x = 1, v = 0;
  integrate::euler(x, v, 0.0, 0.1, [](double position, double, double) { return -position; });
}
