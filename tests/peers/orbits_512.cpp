// SPDX-License-Identifier: MIT-0
// The same planet 512 times, a struct each: what a step costs when the processor need not wait for
// the one before.
#include "orbit/measure.h"

int main(int count, char** arguments) {
  return orbit::measure<512>(count, arguments);
}
