// SPDX-License-Identifier: MIT-0
// What is timed for chapter 3: steps of the suspension.
#include "../times.h"

#include "integrate/rk4_linear.h"
#include "integrate/spring_exact.h"
#include "measure/methods.h"
#include "measure/time_of.h"
#include "rest.h"

namespace {

// Steps by four numbers that are worked out once.
auto by(const integrate::Rk4Linear<double>& folded) {
  return [folded](auto& x, auto& v, auto, auto, auto&&) { integrate::rk4_linear(x, v, folded); };
}
auto by(const integrate::SpringFolded<double>& folded) {
  return [folded](auto& x, auto& v, auto, auto, auto&&) { integrate::spring_folded(x, v, folded); };
}

}  // namespace

void add_spring_times(std::vector<measure::Timed>& all) {
  const auto add = [&](const char* name, auto step, const scenes::Spring<>& scene) {
    all.push_back(
        {name, [step, scene] { return measure::time_of(step, scene, scene.start(), frame); }});
  };
  const double k = suspension.omega * suspension.omega;
  const auto folded = by(integrate::rk4_linear_start(k, suspension.damping(), frame));
  add("spring/RK4", measure::rk4, suspension);
  add("spring/RK4 folded", folded, suspension);
  add("spring/exact folded",
      by(integrate::spring_folded_start(frame, suspension.omega, suspension.zeta)), suspension);
  add("spring/RK4 at rest", measure::rk4, at_rest);
  add("spring/RK4 folded at rest", folded, at_rest);
}
