// SPDX-License-Identifier: MIT-0
// A rope of stiff springs: what an implicit step costs when each mass has two neighbours in space.
#include "implicit/rope_by_hand.h"
#include "implicit/with_headers.h"

namespace {

using namespace implicit;
using Rope = scenes::Rope<>;

std::vector<Variant> variants(const Rope& rope, const State& start) {
  const std::string group = "rope of 333 masses";
  const auto by_band = band<5>(rope);
  const int count = stable_substeps(rope, start);
  const auto explicitly = substeps(rope, count);
  return {
      {{group, "by hand, Thomas with blocks", ""}, by_hand::Rope(rope)},
      {{group, "header, BandSystem", energy_after_a_second(rope, start, by_band)}, by_band},
      {{group, "header, SparseSystem", ""}, sparse(rope)},
      {{group, "header, DenseSystem", ""}, dense(rope)},
      {{group, "setFromTriplets each step", ""}, triplets(rope, false)},
      {{group, "the same, symbolic analysis each step", ""}, triplets(rope, true)},
      {{group, "header, substeps of symplectic_euler",
        std::to_string(count) + " are stable; " + energy_after_a_second(rope, start, explicitly)},
       explicitly,
       false},
  };
}

}  // namespace

int main(int count, char** arguments) {
  run_for_a_while();
  const Rope rope{.count = 333, .length = 332, .mass = mass, .k = k, .g = 0};
  const State start = struck(rope);
  const auto all = variants(rope, start);
  if (!agree(all, start)) return 1;
  add(all, start, 10, rope.count);
  return peers::measure_rows(count, arguments);
}
