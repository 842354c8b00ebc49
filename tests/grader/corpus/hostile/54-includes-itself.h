// COMPILE_LIMIT: includes itself twice
// SPDX-License-Identifier: MIT-0
#include __FILE__
#include __FILE__
