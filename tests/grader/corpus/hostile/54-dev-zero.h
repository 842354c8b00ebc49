// COMPILE_ERROR: includes what has no end
// says: No such file
// SPDX-License-Identifier: MIT-0
#include "/dev/zero"
