// SPDX-License-Identifier: MIT-0
#include "judge/attempt.h"

namespace judge {

bool attempt(const std::function<void()>& act) {
  try {
    act();
    return true;
  } catch (...) {
    return false;
  }
}

}  // namespace judge
