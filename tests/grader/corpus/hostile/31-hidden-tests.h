// COMPILE_ERROR: includes the tests
// says: No such file
// SPDX-License-Identifier: MIT-0
#include "../exercises/2-euler/orbit-drift/judge.cpp"
