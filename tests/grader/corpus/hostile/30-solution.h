// COMPILE_ERROR: includes the solution
// says: No such file
// SPDX-License-Identifier: MIT-0
#include "../solution.h"
