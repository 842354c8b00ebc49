// SPDX-License-Identifier: MIT-0
// The method that the reader has written, in a module of its own, which the page joins to this one.
#include "live/own.h"

#ifdef __wasm__
#define FROM_PAGE(name) extern "C" __attribute__((import_module("reader"), import_name(#name)))
FROM_PAGE(step) void reader_step(double* state, double t, double h);
#else
static void reader_step(double*, double, double) {}
#endif

namespace live {
namespace {

const Force* asked_of = nullptr;

// Of each run: place, velocity, an acceleration that some methods keep, and 1 once the run has
// begun.
class Reader final : public Own {
  double state_[10]{};

  void start(const scenes::State<Vec3>& start, double, const Force&) override {
    Eigen::Map<Vec3>{state_} = start.x;
    Eigen::Map<Vec3>{state_ + 3} = start.v;
    state_[9] = 0;
  }
  void step(double t, double h, const Force& force) override {
    asked_of = &force;
    reader_step(state_, t, h);
  }
  scenes::State<Vec3> now(double, double, const Force&) const override {
    return {Vec3{state_}, Vec3{state_ + 3}};
  }
};

}  // namespace

std::unique_ptr<Own> reader() {
  return std::make_unique<Reader>();
}

void answer_reader(double (&asked)[7]) {
  Eigen::Map<Vec3>{asked} = (*asked_of)(Vec3{asked}, Vec3{asked + 3}, asked[6]);
}

}  // namespace live
