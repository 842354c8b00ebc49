// SPDX-License-Identifier: MIT-0
// Cloth of stiff springs, small and large: what an implicit step costs as the system grows.
#include <string>

#include "implicit/cloth_by_hand.h"
#include "implicit/with_headers.h"

namespace {

using namespace implicit;
using Cloth = scenes::Cloth<>;

std::vector<Variant> variants(const Cloth& cloth, const State& start) {
  const std::string side = std::to_string(cloth.side);
  const std::string group = "cloth of " + side + " x " + side + " masses";
  const auto by_cholesky = sparse(cloth);
  const int count = stable_substeps(cloth, start);
  const auto explicitly = substeps(cloth, count);
  return {
      {{group, "by hand, plain Eigen", ""}, by_hand::Cloth(cloth)},
      {{group, "header, SparseSystem", energy_after_a_second(cloth, start, by_cholesky)},
       by_cholesky},
      {{group, "setFromTriplets each step", ""}, triplets(cloth, false)},
      {{group, "the same, symbolic analysis each step", ""}, triplets(cloth, true)},
      {{group, "header, substeps of symplectic_euler",
        std::to_string(count) + " are stable; " + energy_after_a_second(cloth, start, explicitly)},
       explicitly,
       false},
  };
}

bool add_cloth(int side) {
  const Cloth cloth{.side = side, .width = side - 1.0, .mass = mass, .k = k, .g = 0};
  const State start = struck(cloth);
  auto all = variants(cloth, start);
  const long unknowns = start.x.size();
  if (unknowns <= 1000) {
    all.push_back({{all.front().row.group, "header, DenseSystem", ""}, dense(cloth)});
  }
  if (!agree(all, start)) return false;
  add(all, start, 1, cloth.nodes());
  return true;
}

}  // namespace

int main(int count, char** arguments) {
  run_for_a_while();
  for (const int side : {6, 18, 58}) {
    if (!add_cloth(side)) return 1;
  }
  return peers::measure_rows(count, arguments);
}
