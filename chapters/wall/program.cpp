// SPDX-License-Identifier: MIT-0
// The page for the wall: how many steps each of its methods needs.
#include <cmath>

#include "../cast.h"
#include "measure/record.h"
#include "measure/run.h"
#include "rates.h"

int main(int argc, char** argv) {
  return measure::record(argc, argv, [](measure::Record& record) {
    rates(record);
    const auto fallen =
        measure::after(method::linear_damping_exact, leaf, leaf.start(), frame, 120);
    record.number("leaf-off", 100 * std::abs(fallen.x - leaf.exact(2).x), 2, "cm");
    const float far = 10'000;
    record.number("float-step", 1000 * double(std::nextafter(far, 2 * far) - far), 2, "mm");
  });
}
