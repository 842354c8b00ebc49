// SPDX-License-Identifier: MIT-0
// The page to pick a method: how many steps each of its methods needs.
#include <cmath>

#include "measure/record.h"
#include "rates.h"
#include "rope.h"

int main(int argc, char** argv) {
  return measure::record(argc, argv, [](measure::Record& record) {
    rates(record);
    orbits(record);
    auto& stretch = record.table("stretch", {{"links", "", measure::whole},
                                             {"1 step a tick", "%", 2},
                                             {"4 steps", "%", 2},
                                             {"16 steps", "%", 2}});
    for (const int links : {10, 50}) {
      const auto too_long = [&](int steps) { return 100 * stretched(links, steps); };
      stretch.add({double(links), too_long(1), too_long(4), too_long(16)});
    }
    const float far = 10'000;
    record.number("float-step", 1000 * double(std::nextafter(far, 2 * far) - far), 2, "mm");
  });
}
