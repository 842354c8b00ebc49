// PROTOCOL_ERROR|WRONG_ANSWER: forges an answer in a destructor
// SPDX-License-Identifier: MIT-0
#pragma once
#include <unistd.h>
#include "given.h"

struct Forger {
  ~Forger() {
    double answer[32] = {2, 30};
    (void)!write(3, answer, sizeof answer);
    _exit(0);
  }
};
inline Forger forger;

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
}
