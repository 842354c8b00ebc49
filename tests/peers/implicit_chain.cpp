// SPDX-License-Identifier: MIT-0
// A chain of stiff springs: what an implicit step costs when each mass has two neighbours.
#include "implicit/chain_by_hand.h"
#include "implicit/with_headers.h"

namespace {

using namespace implicit;
using Chain = scenes::Chain<>;

std::vector<Variant> variants(const Chain& chain, const State& start) {
  const std::string group = "chain of 10,000 masses";
  const auto by_band = band<1>(chain);
  const int count = stable_substeps(chain, start);
  const auto explicitly = substeps(chain, count);
  return {
      {{group, "by hand, Thomas", ""}, by_hand::Chain(chain)},
      {{group, "header, BandSystem", energy_after_a_second(chain, start, by_band)}, by_band},
      {{group, "header, SparseSystem", ""}, sparse(chain)},
      {{group, "setFromTriplets each step", ""}, triplets(chain, false)},
      {{group, "the same, symbolic analysis each step", ""}, triplets(chain, true)},
      {{group, "header, substeps of symplectic_euler",
        std::to_string(count) + " are stable; " + energy_after_a_second(chain, start, explicitly)},
       explicitly,
       false},
  };
}

}  // namespace

int main(int count, char** arguments) {
  run_for_a_while();
  const Chain chain{.count = 10'000, .mass = mass, .k = k, .stretch = 0};
  const State start = struck(chain);
  const auto all = variants(chain, start);
  if (!agree(all, start)) return 1;
  add(all, start, 10, chain.count);
  return peers::measure_rows(count, arguments);
}
