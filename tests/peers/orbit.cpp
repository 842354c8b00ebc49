// SPDX-License-Identifier: MIT-0
// One planet on an ellipse, one step after the other: what it costs to call a method.
#include <cstdio>
#include <map>

#include "orbit/variants.h"

namespace {

using orbit::State;
using orbit::Variant;

std::vector<Variant> all_variants() {
  std::vector<Variant> all;
  for (const auto& some :
       {orbit::euler_variants(), orbit::symplectic_euler_variants(),
        orbit::velocity_verlet_variants(), orbit::rk4_variants(), orbit::sprk_variants()}) {
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

// Ten coarse steps, where no two formulas look alike. Each rounds numbers of up to 2 some thirty
// times, which comes to 1e-13; the rest is for roundings that grow on their way.
bool agree(const std::vector<Variant>& variants) {
  std::map<std::string, State> by_hand;
  bool all = true;
  for (const auto& [row, run, _] : variants) {
    const State end = run(orbit::start, 10, 0.05);
    const double away = distance(end, by_hand.try_emplace(row.group, end).first->second);
    if (away <= 1e-12) continue;
    std::fprintf(stderr, "%s: %s ends %g from where the formula by hand ends\n", row.group.c_str(),
                 row.variant.c_str(), away);
    all = false;
  }
  return all;
}

void add(const Variant& variant) {
  constexpr long steps = 20'000;
  peers::add_row(variant.row, steps / variant.steps_for_one,
                 [run = variant.run] { benchmark::DoNotOptimize(run(orbit::start, steps, 1e-3)); });
}

}  // namespace

int main(int count, char** arguments) {
  const std::vector<Variant> all = all_variants();
  if (!agree(all)) return 1;
  for (const Variant& variant : all) add(variant);
  return peers::measure_rows(count, arguments);
}
