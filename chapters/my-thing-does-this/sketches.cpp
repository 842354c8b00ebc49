// SPDX-License-Identifier: MIT-0
#include <stdexcept>

#include "sketch.h"

std::vector<Sketch> every_sketch() {
  std::vector<Sketch> all;
  for (const auto& some :
       {sketches_of_frames(), sketches_of_the_air(), sketches_of_springs(), sketches_of_ropes(),
        sketches_of_contacts(), sketches_of_turning(), sketches_of_long_runs()}) {
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

Sketch sketch(const std::string& name) {
  static const std::vector<Sketch> all = every_sketch();  // each is run once
  for (const Sketch& one : all) {
    if (one.name == name) return one;
  }
  throw std::logic_error("there is no sketch " + name);
}
