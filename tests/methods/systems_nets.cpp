// SPDX-License-Identifier: MIT-0
// The linear systems on ropes and nets, against elimination with full pivoting.
#include <catch2/catch_template_test_macros.hpp>

#include "scenes/chain.h"
#include "scenes/cloth.h"
#include "scenes/rope.h"
#include "systems_check.h"
#include "systems_try.h"

using namespace systems;
using scenes::Chain;
using scenes::Cloth;
using scenes::Rope;

namespace {

template <class Real>
Rope<Real> rope_at(Real tip) {
  return {.count = 12, .mass = Real(0.01), .tip = tip, .k = 200, .c = Real(0.3)};
}

}  // namespace

TEMPLATE_TEST_CASE("On a rope in space each system finds what full pivoting finds", "", double,
                   float) {
  for (const TestType tip : {TestType(0.01), TestType(2)}) {
    CAPTURE(tip);
    const Rope<TestType> scene = rope_at(tip);
    check(band<5>(scene), scene);
    check(sparse(scene, scene.masses()), scene);
  }
}

TEMPLATE_TEST_CASE("Equal masses need not be given to a SparseSystem", "", double, float) {
  const Chain<TestType> in_a_row = chain(TestType(0.5));
  check(sparse(in_a_row, Many<TestType>()), in_a_row);
  const Rope<TestType> in_space = rope_at(TestType(0.01));
  check(sparse(in_space, Many<TestType>()), in_space);
  const Cloth<TestType> net{.side = 5, .mass = TestType(0.01), .k = 200, .c = TestType(0.3)};
  check(sparse(net, Many<TestType>()), net);
}
