// SPDX-License-Identifier: MIT-0
#include "judge/answering.h"

#include <utility>

#include "harness/call.h"

namespace judge {
namespace {

Acceleration answering;

}  // namespace

Answering::Answering(Acceleration acceleration) {
  answering = std::move(acceleration);
}

Answering::~Answering() {
  answering = nullptr;
}

}  // namespace judge

Vec harness::ask(const Vec& x, const Vec& v, double t) {
  return judge::answering(x, v, t);
}
