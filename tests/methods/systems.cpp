// SPDX-License-Identifier: MIT-0
// The linear systems of the implicit methods, against elimination with full pivoting.
#include <Eigen/Core>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include "scenes/chain.h"
#include "systems_check.h"
#include "systems_try.h"

using namespace systems;
using scenes::Chain;

TEMPLATE_TEST_CASE("On a chain of twenty masses each system finds what full pivoting finds", "",
                   double, float) {
  for (const TestType tip : {TestType(0.5), TestType(30)}) {
    CAPTURE(tip);
    const Chain<TestType> scene = chain(tip);
    check(dense(scene), scene);
    check(band<1>(scene), scene);
    check(band<3>(scene), scene);
    check(sparse(scene, scene.masses()), scene);
  }
}
