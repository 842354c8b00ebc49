// SPDX-License-Identifier: MIT-0
// Takes every time that the book shows, and keeps it: times FILE [TURNS]. In each turn everything
// is timed once. Exit code 2 for bad arguments, 1 if the file can't be written.
#include "times.h"

#include <cstdio>
#include <cstdlib>
#include <exception>

int main(int argc, char** argv) {
  const int turns = argc > 2 ? std::atoi(argv[2]) : 31;
  if (argc < 2 || argc > 3 || turns < 1) {
    std::fprintf(stderr,
                 "times: name the file to write, and how often to time everything if not 31 "
                 "times, as in: times here.csv 11\n");
    return 2;
  }
  std::vector<measure::Timed> all;
  add_card_times(all);
  add_spring_times(all);
  add_net_times(all);
  add_step_times(all);
  add_particle_times(all);
  try {
    measure::Times times = measure::take_times(all, COMPILER, turns);
    forget_disturbed(times);
    measure::write_times(times, argv[1]);
    std::printf("%zu times taken%s: see %s\n", times.of.size(),
                times.alone() ? "" : ", while other programs ran", argv[1]);
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "times: %s\n", problem.what());
    return 1;
  }
}
