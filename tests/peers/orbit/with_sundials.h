// SPDX-License-Identifier: MIT-0
// SUNDIALS, with all planets as one system: ERKStep with the tableau of Runge-Kutta 4 and with its
// own of Dormand and Prince; and SPRKStep, for the symplectic methods.
#pragma once
#include <nvector/nvector_serial.h>

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "orbit/arkode.h"
#include "orbit/state.h"
#if SUNDIALS_IS_NEW
#include <arkode/arkode_sprkstep.h>
#endif

namespace orbit {

/// Any of its steppers, at steps of fixed length.
class WithSundials {
 public:
  explicit WithSundials(const std::vector<State>& from) {
    must(SUNContext_Create(SUN_COMM_NULL, &context_));
    y_ = N_VNew_Serial(long(4 * from.size()), context_);
    double* y = N_VGetArrayPointer(y_);
    for (const State& s : from) {
      for (const double number : {s.x, s.y, s.vx, s.vy}) *y++ = number;
    }
  }

  ~WithSundials() {
    ARKodeFree(&stepper_);
    N_VDestroy(y_);
    SUNContext_Free(&context_);
  }

  WithSundials(const WithSundials&) = delete;
  WithSundials& operator=(const WithSundials&) = delete;

  /// Runge-Kutta 4. Its last time is written as less than 1: ERKStep 6.4.1 takes any method that
  /// ends at 1 for one whose last slope is the next step's first, and computes something else. No
  /// time enters this scene.
  void choose_rk4() {
    double c[] = {0, 0.5, 0.5, 1 - 1e-6};
    double A[] = {0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 1, 0};
    double b[] = {1. / 6, 1. / 3, 1. / 3, 1. / 6};
    stepper_ = ERKStepCreate(all_slopes, 0, y_, context_);
    const ARKodeButcherTable table = ARKodeButcherTable_Create(4, 4, 0, c, A, b, nullptr);
    must(ERKStepSetTable(stepper_, table));
    ARKodeButcherTable_Free(table);
  }

  void choose_dopri5() {
    stepper_ = ERKStepCreate(all_slopes, 0, y_, context_);
    must(ERKStepSetTableNum(stepper_, ARKODE_DORMAND_PRINCE_7_4_5));
  }

#if SUNDIALS_IS_NEW
  /// @param method  its name there: "ARKODE_SPRK_EULER_1_1" moves the velocity first, and
  ///     "ARKODE_SPRK_PSEUDO_LEAPFROG_2_2" is velocity Verlet
  void choose_symplectic(const std::string& method) {
    stepper_ = SPRKStepCreate(accelerations, velocities, 0, y_, context_);
    must(SPRKStepSetMethodName(stepper_, method.c_str()));
  }
#endif

  std::vector<State> steps(long count, double h) {
    const double end = double(count) * h;
    must(ARKodeSetMaxNumSteps(stepper_, -1));
    must(ARKodeSetFixedStep(stepper_, h));
    must(ARKodeSetStopTime(stepper_, end));
    double reached = 0;
    must(ARKodeEvolve(stepper_, end, y_, &reached, ARK_NORMAL));
    std::vector<State> all;
    const double* y = N_VGetArrayPointer(y_);
    for (long i = 0; i < N_VGetLength(y_); i += 4) {
      all.push_back({y[i], y[i + 1], y[i + 2], y[i + 3]});
    }
    return all;
  }

 private:
  static void must(int status) {
    if (status < 0) throw std::runtime_error("SUNDIALS: error " + std::to_string(status));
  }

  static int all_slopes(double t, N_Vector y, N_Vector slope, void* data) {
    velocities(t, y, slope, data);
    return accelerations(t, y, slope, data);
  }

  static int velocities(double, N_Vector state, N_Vector slope, void*) {
    const double* y = N_VGetArrayPointer(state);
    double* f = N_VGetArrayPointer(slope);
    const long numbers = N_VGetLength(state);
    for (long i = 0; i < numbers; i += 4) {
      f[i] = y[i + 2];
      f[i + 1] = y[i + 3];
    }
    return 0;
  }

  static int accelerations(double, N_Vector state, N_Vector slope, void*) {
    const double* y = N_VGetArrayPointer(state);
    double* f = N_VGetArrayPointer(slope);
    const long numbers = N_VGetLength(state);
    for (long i = 0; i < numbers; i += 4) {
      const double p = pull(y[i] * y[i] + y[i + 1] * y[i + 1]);
      f[i + 2] = p * y[i];
      f[i + 3] = p * y[i + 1];
    }
    return 0;
  }

  SUNContext context_ = nullptr;
  N_Vector y_ = nullptr;
  void* stepper_ = nullptr;
};

/// @param choose  called with a WithSundials, whose method it chooses
template <class Choose>
auto with_sundials(Choose choose) {
  return [choose](const std::vector<State>& from, long steps, double h) {
    WithSundials all(from);
    choose(all);
    return all.steps(steps, h);
  };
}

}  // namespace orbit
