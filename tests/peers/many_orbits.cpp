// SPDX-License-Identifier: MIT-0
// Thirty-two planets at once: what a step costs when the processor need not wait for the one
// before.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <vector>

#include "many/by_hand.h"
#include "many/with_headers.h"
#include "orbit/by_hand.h"
#include "rows.h"

namespace {

using many::Orbits;
using orbit::State;

struct Variant {
  peers::Row row;
  std::function<Orbits(const Orbits&, long, double)> run;
};

template <class Step>
std::vector<Variant> with_header(const std::string& group, Step step) {
  using namespace many::with_headers;
  return {
      {{group, "header, blocks", "Vec is an Eigen array of 32 x 2"},
       [step](const Orbits& s, long n, double h) { return in_blocks(s, n, h, step); }},
      {{group, "header, plain loop",
        "wants -fno-math-errno: without it a root must leave word in errno when its number is "
        "negative, and only the one-at-a-time function does"},
       [step](const Orbits& s, long n, double h) { return one_by_one(s, n, h, step); }},
  };
}

std::vector<Variant> symplectic_euler_variants() {
  const std::string group = "32 orbits, symplectic_euler";
  auto all = with_header(group, [](auto&&... args) { integrate::symplectic_euler(args...); });
  all.insert(all.begin(), {{group, "vectorised by hand", ""}, many::by_hand::symplectic_euler});
  return all;
}

std::vector<Variant> rk4_variants() {
  const std::string group = "32 orbits, rk4";
  auto all = with_header(group, [](auto&&... args) { integrate::rk4(args...); });
  all.insert(all.begin(), {{group, "vectorised by hand", ""}, many::by_hand::rk4});
  return all;
}

State planet(const Orbits& all, std::size_t i) {
  return {all.x[i], all.y[i], all.vx[i], all.vy[i]};
}

// Against each planet alone. How far roundings may lead them apart: see orbit.cpp.
template <class ByHand>
bool agree(const std::vector<Variant>& variants) {
  bool all = true;
  for (const auto& [row, run] : variants) {
    const Orbits end = run(many::start(), 10, 0.05);
    double away = 0;
    for (std::size_t i = 0; i < many::count; ++i) {
      const auto alone = orbit::loop<1, ByHand>({planet(many::start(), i)}, 10, 0.05);
      away = std::max(away, distance(planet(end, i), alone[0]));
    }
    if (away <= 1e-12) continue;
    std::fprintf(stderr, "%s: %s ends %g from where each planet alone ends\n", row.group.c_str(),
                 row.variant.c_str(), away);
    all = false;
  }
  return all;
}

void add(const std::vector<Variant>& variants) {
  constexpr long steps = 2'000;
  for (const Variant& variant : variants) {
    peers::add_row(variant.row, steps * long(many::count), [run = variant.run] {
      benchmark::DoNotOptimize(run(many::start(), steps, 1e-3));
    });
  }
}

}  // namespace

int main(int count, char** arguments) {
  const auto euler = symplectic_euler_variants();
  const auto rk4 = rk4_variants();
  using namespace orbit::by_hand;
  if (!agree<SymplecticEuler>(euler) || !agree<Rk4>(rk4)) return 1;
  add(euler);
  add(rk4);
  return peers::measure_rows(count, arguments);
}
