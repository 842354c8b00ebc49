// SPDX-License-Identifier: MIT-0
// The methods that solve for the end of a step.
#include "measure/compiled.h"
#include "measure/method_of.h"

namespace measure {

constinit const CompiledOf<list::EveryImplicit> compiled_implicit =
    methods_of(list::EveryImplicit());

}  // namespace measure
