// SPDX-License-Identifier: MIT-0
// Takes every time that the book shows, and keeps it: times FILE. Exit code 2 for bad arguments, 1
// if the file can't be written.
#include "times.h"

#include <cstdio>
#include <exception>

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "times: name the file to write, as in: times here.csv\n");
    return 2;
  }
  std::vector<measure::Timed> all;
  add_card_times(all);
  add_spring_times(all);
  add_shuttle_times(all);
  add_particle_times(all);
  try {
    measure::Times times = measure::take_times(all, COMPILER);
    forget_disturbed(times);
    measure::write_times(times, argv[1]);
    std::printf("%zu times taken%s: see %s\n", times.of.size(),
                times.alone() ? "" : ", while other programs ran", argv[1]);
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "times: %s\n", problem.what());
    return 1;
  }
}
