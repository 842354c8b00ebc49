// SPDX-License-Identifier: MIT-0
// What the linear systems refuse, and that they recover from it.
#include <Eigen/Core>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <string>
#include <vector>

#include "integrate/band_system.h"
#include "integrate/dense_system.h"
#include "integrate/sparse_system.h"
#include "systems_try.h"

using namespace systems;
using Catch::Matchers::ContainsSubstring;
using integrate::BandSystem;
using integrate::DenseSystem;
using integrate::SparseSystem;

TEMPLATE_TEST_CASE("No system takes a singular matrix, and all recover", "", (DenseSystem<Entries>),
                   (DenseSystem<Entries, float>), (DenseSystem<Entries, double, 2>),
                   (BandSystem<1, Entries>), (BandSystem<2, Entries, float>),
                   (SparseSystem<Entries>), (SparseSystem<Entries, float>)) {
  std::vector<Entry> entries{{0, 0, 1}, {1, 1, -1}};  // 1 - 1 and 1 + 1
  TestType system(Entries{&entries});
  CHECK_FALSE(solved(system, 2));
  entries[0].dadx = -1;
  CHECK(solved(system, 2));
  entries = {{0, 0, 0}, {0, 1, -2}, {1, 0, -2}, {1, 1, -3}};  // 1, 2; 2, 4
  CHECK_FALSE(solved(system, 2));
  entries[0].dadx = -3;
  CHECK(solved(system, 2));
}

TEST_CASE("A DenseSystem takes a matrix that needs pivoting, a BandSystem refuses it") {
  const std::vector<Entry> entries{{0, 0, 1}, {0, 1, -2}, {1, 0, -3}, {1, 1, -1}};
  DenseSystem<Entries> dense(Entries{&entries});
  CHECK(solves(dense, entries, 2));
  BandSystem<1, Entries> band(Entries{&entries});
  CHECK_FALSE(solved(band, 2));
}

TEST_CASE("A BandSystem refuses an entry outside of its band") {
  std::vector<Entry> entries{{0, 0, -1}, {2, 2, -1}};
  BandSystem<1, Entries> system(Entries{&entries});
  CHECK(solves(system, entries, 4));
  for (const auto& [row, column] : {std::pair(0, 2), std::pair(3, 1), std::pair(0, 3)}) {
    entries.push_back({row, column, 0.1});
    CHECK_FALSE(solved(system, 4));
    entries.pop_back();
  }
  entries.push_back({3, 2, 0.1});
  CHECK(solves(system, entries, 4));
}

TEST_CASE("A SparseSystem refuses what is not symmetric and says what to do") {
  const std::vector<Entry> entries{{0, 0, -2}, {0, 1, 1}, {1, 0, 0.5}, {1, 1, -1}};
  SparseSystem<Entries> without(Entries{&entries});
  CHECK_FALSE(solved(without, 2));
  CHECK_THAT(without.problem(), ContainsSubstring("not symmetric"));
  CHECK_THAT(without.problem(), ContainsSubstring("masses"));
  SparseSystem<Entries> with(Entries{&entries}, Eigen::VectorXd{{1, 2}});
  CHECK(solves(with, entries, 2));
  CHECK(std::string(with.problem()).empty());
  const std::vector<Entry> lopsided{{0, 0, -2}, {1, 0, 0.5}};
  SparseSystem<Entries> half(Entries{&lopsided});
  CHECK_FALSE(solved(half, 2));
  CHECK_THAT(half.problem(), ContainsSubstring("not symmetric"));
}

TEST_CASE("A SparseSystem refuses what is not positive definite and says what to do") {
  std::vector<Entry> entries{{0, 0, 0}, {0, 1, -2}, {1, 0, -2}, {1, 1, 0}};  // eigenvalues 3, -1
  SparseSystem<Entries> system(Entries{&entries});
  CHECK_FALSE(solved(system, 2));
  CHECK_THAT(system.problem(), ContainsSubstring("not positive definite"));
  CHECK_THAT(system.problem(), ContainsSubstring("smaller step"));
  for (Entry& each : entries) each.dadx /= 4;
  CHECK(solves(system, entries, 2));
  CHECK(std::string(system.problem()).empty());
}
