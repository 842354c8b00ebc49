// WRONG_ANSWER: leaves something for the next submission
// SPDX-License-Identifier: MIT-0
#pragma once
#include <fcntl.h>
#include <unistd.h>
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  for (const char* path : {"/dev/shm/corpus-was-here", "/tmp/corpus-was-here", "corpus-was-here"})
    close(open(path, O_CREAT | O_WRONLY, 0666));
}
