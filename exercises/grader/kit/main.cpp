// SPDX-License-Identifier: MIT-0
// make_kit FOLDER COMPILER: for the build, with the compiler that it has found.
#include <cstdio>
#include <exception>

#include "kit/make_kit.h"

int main(int argc, char** argv) {
  if (argc != 3) return std::fputs("make_kit FOLDER COMPILER\n", stderr), 2;
  try {
    grade::make_kit(argv[1], argv[2]);
    return 0;
  } catch (const std::exception& problem) {
    return std::fprintf(stderr, "make_kit: %s\n", problem.what()), 1;
  }
}
