// SPDX-License-Identifier: MIT-0
/// @file
/// The tests of the judges, where there is no Catch2.
#pragma once

namespace page {

/// A test, known from the start of the module on.
class Registered {
 public:
  Registered(void (*run)(), const char* name, const char* tags);
};

/// Ends the test that runs.
[[noreturn]] void end_test();

}  // namespace page
