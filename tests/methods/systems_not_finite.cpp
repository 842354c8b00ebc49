// SPDX-License-Identifier: MIT-0
// What is not a number, or has overflown, does not pass through a linear system unnoticed.
#include <Eigen/Core>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <limits>
#include <vector>

#include "integrate/band_system.h"
#include "integrate/dense_system.h"
#include "integrate/sparse_system.h"
#include "systems_try.h"

using namespace systems;
using integrate::BandSystem;
using integrate::DenseSystem;
using integrate::SparseSystem;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

// A system of two unknowns, with one of its entries replaced after the other.
template <class System>
void check_refuses_entry(double bad) {
  std::vector<Entry> entries{{0, 0, -1}, {0, 1, 0.5}, {1, 0, 0.5}, {1, 1, -1}};
  System system(Entries{&entries});
  for (Entry& each : entries) {
    CAPTURE(bad, each.row, each.column);
    const double before = each.dadx;
    each.dadx = bad;
    CHECK_FALSE(solved(system, 2));
    each.dadx = before;
    CHECK(solved(system, 2));
  }
}

template <class System>
void check_refuses_right_side(double bad) {
  const std::vector<Entry> entries{{0, 0, -1}, {0, 1, 0.5}, {1, 0, 0.5}, {1, 1, -1}};
  System system(Entries{&entries});
  CAPTURE(bad);
  CHECK(solved(system, 2));
  CHECK_FALSE(solved(system, 2, bad));
}

}  // namespace

TEMPLATE_TEST_CASE("No system takes a derivative that is not a number", "", (DenseSystem<Entries>),
                   (DenseSystem<Entries, double, 2>), (BandSystem<1, Entries>),
                   (SparseSystem<Entries>)) {
  check_refuses_entry<TestType>(not_a_number);
}

TEMPLATE_TEST_CASE("No system takes a derivative that is infinite", "", (DenseSystem<Entries>),
                   (DenseSystem<Entries, double, 2>), (BandSystem<1, Entries>),
                   (SparseSystem<Entries>)) {
  for (const double bad : {infinite, -infinite}) check_refuses_entry<TestType>(bad);
}

TEMPLATE_TEST_CASE("No system takes a right side that is not a number or infinite", "",
                   (DenseSystem<Entries>), (DenseSystem<Entries, double, 2>),
                   (BandSystem<1, Entries>)) {
  for (const double bad : {not_a_number, infinite, -infinite}) {
    check_refuses_right_side<TestType>(bad);
  }
}

TEST_CASE("A SparseSystem takes no right side that is not a number or infinite") {
  for (const double bad : {not_a_number, infinite, -infinite}) {
    check_refuses_right_side<SparseSystem<Entries>>(bad);
  }
}

TEST_CASE("A DenseSystem refuses a singular matrix even if its right side has an answer") {
  const std::vector<Entry> ones{{0, 0, 0}, {0, 1, -1}, {1, 0, -1}, {1, 1, 0}};
  DenseSystem<Entries> system(Entries{&ones});
  CHECK_FALSE(solved(system, 2));
  CHECK_FALSE(solved(system, 2, 0));
}
