// SPDX-License-Identifier: MIT-0
// SUNDIALS has one set of functions for all of its steppers since 7.1. Before that each stepper has
// its own, and ERKStep's get the new names here.
#pragma once
#include <arkode/arkode_erkstep.h>
#include <sundials/sundials_config.h>

#if SUNDIALS_VERSION_MAJOR > 7 || (SUNDIALS_VERSION_MAJOR == 7 && SUNDIALS_VERSION_MINOR >= 1)
#define SUNDIALS_IS_NEW 1
#else
#define SUNDIALS_IS_NEW 0
#define SUN_COMM_NULL nullptr
inline int ARKodeSetFixedStep(void* memory, double h) {
  return ERKStepSetFixedStep(memory, h);
}
inline int ARKodeSetMaxNumSteps(void* memory, long n) {
  return ERKStepSetMaxNumSteps(memory, n);
}
inline int ARKodeSetStopTime(void* memory, double t) {
  return ERKStepSetStopTime(memory, t);
}
inline int ARKodeReset(void* memory, double t, N_Vector y) {
  return ERKStepReset(memory, t, y);
}
inline int ARKodeEvolve(void* memory, double t, N_Vector y, double* reached, int task) {
  return ERKStepEvolve(memory, t, y, reached, task);
}
inline void ARKodeFree(void** memory) {
  ERKStepFree(memory);
}
#endif
