// SPDX-License-Identifier: MIT-0
// In the page nothing is thrown: what would be is a trap, which the page catches for us.
#include "judge/attempt.h"

/// Calls call_attempted, and returns 0 if that did not come back.
extern "C" [[clang::import_module("page"), clang::import_name("attempt")]] int page_attempt(
    const std::function<void()>* act);

extern "C" [[clang::export_name("call_attempted")]] void call_attempted(
    const std::function<void()>* act) {
  (*act)();
}

bool judge::attempt(const std::function<void()>& act) {
  return page_attempt(&act) != 0;
}
