// SPDX-License-Identifier: MIT-0
// SUNDIALS: ERKStep with the tableau of Runge-Kutta 4; and SPRKStep, for the symplectic methods.
#pragma once
#include <nvector/nvector_serial.h>

#include <memory>
#include <stdexcept>
#include <string>

#include "orbit/arkode.h"
#include "orbit/state.h"
#if SUNDIALS_IS_NEW
#include <arkode/arkode_sprkstep.h>
#endif

namespace orbit {

/// Any of its steppers, at steps of fixed length.
class WithSundials {
 public:
  State operator()(State s, long steps, double h) const {
    put(s);
    const double end = double(steps) * h;
    must(ARKodeReset(stepper_, 0, y_));
    must(ARKodeSetFixedStep(stepper_, h));
    must(ARKodeSetStopTime(stepper_, end));
    double reached = 0;
    must(ARKodeEvolve(stepper_, end, y_, &reached, ARK_NORMAL));
    const double* y = N_VGetArrayPointer(y_);
    return {y[0], y[1], y[2], y[3]};
  }

  ~WithSundials() {
    ARKodeFree(&stepper_);
    N_VDestroy(y_);
    SUNContext_Free(&context_);
  }

  /// Runge-Kutta 4. Its last time is written as less than 1: ERKStep 6.4.1 takes any method that
  /// ends at 1 for one whose last slope is the next step's first, and computes something else. No
  /// time enters this scene.
  static std::shared_ptr<WithSundials> rk4() {
    double c[] = {0, 0.5, 0.5, 1 - 1e-6};
    double A[] = {0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 1, 0};
    double b[] = {1. / 6, 1. / 3, 1. / 3, 1. / 6};
    const std::shared_ptr<WithSundials> made(new WithSundials);
    made->stepper_ = ERKStepCreate(all_slopes, 0, made->y_, made->context_);
    const ARKodeButcherTable table = ARKodeButcherTable_Create(4, 4, 0, c, A, b, nullptr);
    must(ERKStepSetTable(made->stepper_, table));
    ARKodeButcherTable_Free(table);
    must(ARKodeSetMaxNumSteps(made->stepper_, -1));
    return made;
  }

#if SUNDIALS_IS_NEW
  /// @param method  its name there: "ARKODE_SPRK_EULER_1_1" moves the velocity first, and
  ///     "ARKODE_SPRK_PSEUDO_LEAPFROG_2_2" is velocity Verlet
  static std::shared_ptr<WithSundials> symplectic(const std::string& method) {
    const std::shared_ptr<WithSundials> made(new WithSundials);
    made->stepper_ = SPRKStepCreate(accelerations, velocities, 0, made->y_, made->context_);
    must(SPRKStepSetMethodName(made->stepper_, method.c_str()));
    must(ARKodeSetMaxNumSteps(made->stepper_, -1));
    return made;
  }
#endif

 private:
  WithSundials() {
    must(SUNContext_Create(SUN_COMM_NULL, &context_));
    y_ = N_VNew_Serial(4, context_);
    put(start);
  }

  static void must(int status) {
    if (status < 0) throw std::runtime_error("SUNDIALS: error " + std::to_string(status));
  }

  void put(State s) const {
    double* y = N_VGetArrayPointer(y_);
    y[0] = s.x, y[1] = s.y, y[2] = s.vx, y[3] = s.vy;
  }

  static int all_slopes(double t, N_Vector y, N_Vector slope, void* data) {
    velocities(t, y, slope, data);
    return accelerations(t, y, slope, data);
  }

  static int velocities(double, N_Vector state, N_Vector slope, void*) {
    const double* y = N_VGetArrayPointer(state);
    double* f = N_VGetArrayPointer(slope);
    f[0] = y[2];
    f[1] = y[3];
    return 0;
  }

  static int accelerations(double, N_Vector state, N_Vector slope, void*) {
    const double* y = N_VGetArrayPointer(state);
    double* f = N_VGetArrayPointer(slope);
    const double p = pull(y[0] * y[0] + y[1] * y[1]);
    f[2] = p * y[0];
    f[3] = p * y[1];
    return 0;
  }

  SUNContext context_ = nullptr;
  N_Vector y_ = nullptr;
  void* stepper_ = nullptr;
};

inline auto with_sundials(std::shared_ptr<WithSundials> stepper) {
  return [stepper](State s, long steps, double h) { return (*stepper)(s, steps, h); };
}

}  // namespace orbit
