// SPDX-License-Identifier: MIT-0
// A SparseSystem notices when its Jacobian adds other entries than before.
#include <Eigen/Core>
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <vector>

#include "integrate/sparse_system.h"
#include "systems_try.h"

using namespace systems;

namespace {

// Of four masses in a row.
const std::vector<Entry> four_masses{{0, 0, -2, -0.5},  {0, 1, 1, 0.2}, {1, 0, 1, 0.2},
                                     {1, 1, -3, -0.5},  {1, 2, 1, 0.1}, {2, 1, 1, 0.1},
                                     {2, 2, -2, -0.25}, {3, 3, -1, 0}};

}  // namespace

TEST_CASE("A SparseSystem takes new values of the entries that it knows") {
  std::vector<Entry> entries = four_masses;
  integrate::SparseSystem<Entries> system(Entries{&entries});
  CHECK(solves(system, entries, 4));
  for (Entry& each : entries) each.dadx *= 1.5;
  CHECK(solves(system, entries, 4));
  CHECK(solves(system, entries, 4));
}

TEST_CASE("A SparseSystem takes its entries in another order") {
  std::vector<Entry> entries = four_masses;
  integrate::SparseSystem<Entries> system(Entries{&entries});
  CHECK(solves(system, entries, 4));
  std::reverse(entries.begin(), entries.end());
  CHECK(solves(system, entries, 4));
  std::swap(entries[1], entries[4]);
  CHECK(solves(system, entries, 4));
}

TEST_CASE("A SparseSystem takes entries that were not there before") {
  std::vector<Entry> entries = four_masses;
  integrate::SparseSystem<Entries> system(Entries{&entries});
  CHECK(solves(system, entries, 4));
  entries.push_back({3, 2, 0.5, 0});
  entries.push_back({2, 3, 0.5, 0});
  CHECK(solves(system, entries, 4));
  entries.insert(entries.begin(), {{3, 0, -0.25, 0}, {0, 3, -0.25, 0}});
  CHECK(solves(system, entries, 4));
}

TEST_CASE("A SparseSystem forgets entries that are no longer there") {
  std::vector<Entry> entries = four_masses;
  integrate::SparseSystem<Entries> system(Entries{&entries});
  CHECK(solves(system, entries, 4));
  entries.erase(entries.begin() + 4, entries.begin() + 6);
  CHECK(solves(system, entries, 4));
  entries.clear();
  CHECK(solves(system, entries, 4));
}

TEST_CASE("A SparseSystem adds up what is added twice") {
  std::vector<Entry> entries = four_masses;
  integrate::SparseSystem<Entries> system(Entries{&entries});
  entries.push_back({1, 1, -0.5, -0.125});
  entries.push_back({0, 0, -0.5, 0});
  CHECK(solves(system, entries, 4));
  entries.push_back({1, 1, -0.5, -0.125});
  CHECK(solves(system, entries, 4));
}

TEST_CASE("A SparseSystem takes another number of unknowns") {
  std::vector<Entry> entries = four_masses;
  integrate::SparseSystem<Entries> system(Entries{&entries});
  CHECK(solves(system, entries, 4));
  CHECK(solves(system, entries, 6));
  entries.push_back({5, 5, -2, -1});
  CHECK(solves(system, entries, 6));
  entries.assign(four_masses.begin(), four_masses.end() - 1);
  CHECK(solves(system, entries, 3));
}
