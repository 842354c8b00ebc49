// SPDX-License-Identifier: MIT-0
// One planet on an ellipse, one step after the other: what it costs to call a method.
#include "orbit/measure.h"

int main(int count, char** arguments) {
  return orbit::measure<1>(count, arguments);
}
