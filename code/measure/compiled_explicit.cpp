// SPDX-License-Identifier: MIT-0
// The methods that take any acceleration.
#include "measure/compiled.h"
#include "measure/method_of.h"

namespace measure {

constinit const CompiledOf<list::EveryExplicit> compiled_explicit =
    methods_of(list::EveryExplicit());

}  // namespace measure
