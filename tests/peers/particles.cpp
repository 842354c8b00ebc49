// SPDX-License-Identifier: MIT-0
// Ten million particles: what layout and loop make of one header, beside the time in which the
// machine can read and write so many numbers at all.
#include <memory>
#include <thread>

#include "particles/agree.h"
#include "particles/variants.h"
#include "rows.h"

namespace {

using namespace particles;

constexpr long count = 10'000'000;

// Both shares are whole blocks, of float as of double.
constexpr long first_share = (count / 2 + 127) / 128 * 128;
static_assert(count % 128 == 0);

// A row of the limit leads each group, so that it is measured among the others.
template <class Real>
void add_rows(const std::string& type, const std::shared_ptr<Particles<Real>>& all, int threads) {
  const std::string group =
      "10 million particles, " + type + ", " + (threads == 1 ? "one thread" : "two threads");
  std::vector<Variant<Real>> some = variants<Real>();
  some.insert(some.begin(), limit<Real>());
  for (const auto& variant : some) {
    if (variant.threads < threads) continue;
    const peers::Row row{group, variant.name, variant.note};
    const auto run = variant.run;
    if (threads == 1) {
      peers::add_row(row, count * variant.steps, [run, all] { run(*all, {0, count}); });
    } else {
      peers::add_row(row, count * variant.steps, [run, all] {
        const std::jthread other([run, all] { run(*all, {first_share, count}); });
        run(*all, {0, first_share});
      })->UseRealTime();
    }
  }
}

// How fast the arithmetic of the substeps alone can be: one small range again and again.
template <class Real>
void add_cached_row(const std::string& type, const std::shared_ptr<Particles<Real>>& all) {
  constexpr long few = 640;
  static_assert(count % few == 0 && few % Block<Real>::SizeAtCompileTime == 0);
  const peers::Row row{"10 million particles, " + type + ", one thread",
                       "header, blocks, from the cache",
                       "640 particles again and again: what the arithmetic of 16 substeps takes"};
  peers::add_row(row, count * substeps, [all] {
    for (long n = 0; n < count; n += few) {
      step_blocks(all->arrays, {0, few}, h<Real>, substeps);
    }
  });
}

template <class Real>
void add_type(const std::string& type) {
  const auto all = std::make_shared<Particles<Real>>(count);
  add_rows(type, all, 1);
  add_cached_row(type, all);
  add_rows(type, all, 2);
}

}  // namespace

int main(int argument_count, char** arguments) {
  if (!agree<float>() || !agree<double>()) return 1;
  add_type<float>("float");
  add_type<double>("double");
  return peers::measure_rows(argument_count, arguments);
}
