// SPDX-License-Identifier: MIT-0
/// @file
/// Code of ours that is called in this process, where a student's has a driver.
#pragma once
#include "harness/given.h"

namespace judge {

/// Answers what that code asks of a force that only the judge knows, for as long as this lives.
class Answering {
 public:
  explicit Answering(Acceleration acceleration);
  ~Answering();
  Answering(const Answering&) = delete;
  Answering& operator=(const Answering&) = delete;
};

}  // namespace judge
