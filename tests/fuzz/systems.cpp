// SPDX-License-Identifier: MIT-0
// The linear systems: what they say they solved is made of numbers.
#include <algorithm>

#include "fuzz.h"
#include "integrate/band_system.h"
#include "integrate/dense_system.h"
#include "integrate/sparse_system.h"

namespace fuzz {
namespace {

// Entries of a Jacobian as they come, some of them outside of a band.
template <class Real>
struct Entries {
  struct Entry {
    int i, j;
    Real dadx, dadv;
  };
  std::vector<Entry> all;

  Entries(Source& source, int count) {
    if (count == 0) return;
    const bool symmetric = source.whole(0, 1) == 0;
    for (int n = source.whole(0, 3 * count); n > 0; --n) {
      const int i = source.whole(0, count - 1);
      const int j = source.whole(0, 4) == 0 ? source.whole(0, count - 1)
                                            : std::max(0, i - source.whole(0, 1));
      all.push_back({i, j, source.number<Real>(), source.number<Real>()});
      if (symmetric && i != j) all.push_back({j, i, all.back().dadx, all.back().dadv});
    }
  }

  // Whether none of them is further than this from the diagonal.
  bool within(int width) const {
    for (const Entry& entry : all) {
      if (std::abs(entry.i - entry.j) > width) return false;
    }
    return true;
  }
};

template <class Real>
using Unknowns = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

template <class Real>
Unknowns<Real> numbers(Source& source, int count) {
  Unknowns<Real> all(count);
  for (Real& one : all) one = source.number<Real>();
  return all;
}

// Solves twice, with the same entries or with others: `made(jacobian)` is the system, and
// `check(solved, entries, system)` what else is known of it.
template <class Real, class Made, class Check>
void solve(Source& source, Made made, Check check) {
  int count = source.whole(0, 6);
  Entries<Real> entries(source, count);
  auto system = made(
      [&](const auto&, const auto&, double, auto&& add) {
        for (const auto& [i, j, dadx, dadv] : entries.all) add(i, j, dadx, dadv);
      },
      count);
  for (int n = 0; n < 2; ++n) {
    const auto x = numbers<Real>(source, count), v = numbers<Real>(source, count);
    auto change = numbers<Real>(source, count);
    const bool solved =
        system(x, v, source.number<double>(), source.number<Real>(), source.number<Real>(), change);
    if (solved) require(change.allFinite(), "the answer is finite, or it is none");
    check(solved, entries, system);
    if (source.whole(0, 1) == 0) entries = Entries<Real>(source, count = source.whole(0, 6));
  }
}

}  // namespace

Cases systems() {
  Cases cases;
  const auto nothing_else = [](bool, const auto&, const auto&) {};
  add_numbers(cases, "dense_system", "entries", [=]<class Real>(Source& source) {
    solve<Real>(
        source,
        [](auto jacobian, int) {
          return integrate::DenseSystem<decltype(jacobian), Real>(jacobian);
        },
        nothing_else);
  });
  const auto band = []<int width>(Source& source, auto zero) {
    using Real = decltype(zero);
    solve<Real>(
        source,
        [](auto jacobian, int) {
          return integrate::BandSystem<width, decltype(jacobian), Real>(jacobian);
        },
        [](bool solved, const auto& entries, const auto&) {
          require(!solved || entries.within(width), "false if an entry lies outside of the band");
        });
  };
  add_numbers(cases, "band_system", "of width one",
              [=]<class Real>(Source& source) { band.template operator()<1>(source, Real(0)); });
  add_numbers(cases, "band_system", "of width three",
              [=]<class Real>(Source& source) { band.template operator()<3>(source, Real(0)); });
  add_numbers(cases, "sparse_system", "entries and masses", []<class Real>(Source& source) {
    solve<Real>(
        source,
        [&](auto jacobian, int count) {
          Unknowns<Real> masses =
              numbers<Real>(source, source.whole(0, 1) * (source.whole(0, 9) == 0 ? 3 : count));
          if (source.tame())
            masses = masses.cwiseAbs() + Unknowns<Real>::Constant(masses.size(), Real(0.1));
          return integrate::SparseSystem<decltype(jacobian), Real>(jacobian, masses);
        },
        [](bool solved, const auto&, const auto& system) {
          require(solved == (*system.problem() == 0),
                  "what went wrong in the last solve; empty if nothing did");
        });
  });
  return cases;
}

}  // namespace fuzz
