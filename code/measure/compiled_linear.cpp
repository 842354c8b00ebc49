// SPDX-License-Identifier: MIT-0
// The methods for springs and for linear damping.
#include "measure/compiled.h"
#include "measure/method_of.h"

namespace measure {

constinit const CompiledOf<EveryLinear> compiled_linear = methods_of(EveryLinear());

}  // namespace measure
