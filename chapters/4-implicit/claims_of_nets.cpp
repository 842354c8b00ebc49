// SPDX-License-Identifier: MIT-0
// The claims of chapter 4 about nets: chain, rope and cloth. Each name is a sentence that the
// chapter says.
#include <Eigen/Dense>
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "blows.h"
#include "iterated.h"
#include "matrix_costs.h"
#include "measure/times.h"
#include "nets.h"
#include "seen.h"
#include "slide.h"
#include "struck_nets.h"

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using integrate::symplectic_euler;

namespace {

const double rounding = std::numeric_limits<double>::epsilon();

/// Multiplications of all substeps over those of one solved step.
template <class Scene, class Counted>
double saving(const Scene& scene, const Counted& counted) {
  return substeps_for(scene) * work_of_substep(counted) / work_of_step(counted);
}

double cloth_saving(int side) {
  return saving(cloth_of(side), cloth_of<Tallied>(side));
}

/// The largest size of any position after a second of a chain in substeps of symplectic Euler.
double chain_after(int substeps) {
  Struck s = struck(steel_chain, gentle);
  const double step = frame / substeps;
  for (int n = 0; n < 60 * substeps; ++n) symplectic_euler(s.x, s.v, 0.0, step, steel_chain);
  return s.x.cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
}

const std::string nets[] = {"chain", "rope", "cloth"};

/// All ways on one net after a gentle blow, worked out once.
const std::vector<Way>& all_ways(const std::string& net) {
  static std::map<std::string, std::vector<Way>> known;
  if (!known.contains(net)) known[net] = ways(net, gentle);
  return known[net];
}

double off(const std::string& net, const std::string& method, int steps = 1) {
  return way_of(all_ways(net), method, steps).off;
}

double work(const std::string& net, const std::string& method, int steps = 1) {
  return way_of(all_ways(net), method, steps).work;
}

}  // namespace

TEST_CASE("The talk's linear system takes the step of half as many unknowns on a chain") {
  Struck whole = struck(chain_of(12), gentle), half = whole;
  const auto scene = chain_of(12);
  slide_system(whole, frame, scene);
  auto system = system_of(scene);
  REQUIRE(integrate::backward_euler(half.x, half.v, 0.0, frame, scene, system));
  // The condition of the matrices is about (h omega)^2.
  CHECK((whole.v - half.v).norm() < 1e4 * rounding * gentle);
  CHECK((whole.x - half.x).norm() < 1e4 * rounding * gentle * frame);
}

TEST_CASE("One solve ends where the slope of the end leads back to the start, on a chain") {
  const Struck start = struck(steel_chain, gentle);
  Struck s = start;
  auto system = system_of(steel_chain);
  REQUIRE(integrate::backward_euler(s.x, s.v, 0.0, frame, steel_chain, system));
  const Eigen::VectorXd back = s.v - frame * steel_chain(s.x, s.v, 0.0);
  CHECK((back - start.v).cwiseAbs().maxCoeff() < 1e4 * rounding * gentle);
}

TEST_CASE("A pull at the last of three masses changes their velocities by 1, 3 and 8") {
  scenes::Chain<> chain{.count = 3, .mass = 2, .k = 2 / (frame * frame)};  // kappa is 1
  auto system = system_of(chain);
  const auto s = chain.start();
  Eigen::VectorXd change(3);
  change << 0, 0, 13;
  REQUIRE(system(s.x, s.v, 0.0, -frame * frame, -frame, change));
  CHECK_THAT(change[0], WithinRel(1, 10 * rounding));
  CHECK_THAT(change[1], WithinRel(3, 10 * rounding));
  CHECK_THAT(change[2], WithinRel(8, 10 * rounding));
}

TEST_CASE("Of the matrix of a chain three diagonals are not zero, and of its inverse all") {
  const Sparse matrix = step_matrix_of(steel_chain);
  CHECK(matrix.nonZeros() == 3 * steel_chain.count - 2);
  const Eigen::MatrixXd inverse = Eigen::MatrixXd(matrix).inverse();
  CHECK((inverse.array() > 0).all());
}

TEST_CASE("The factor has one entry a row of a chain, four of a rope, ever more of cloth") {
  const auto each = [](const auto& scene) {
    const Sparse factor = factor_of(step_matrix_of(scene));
    return double(factor.nonZeros()) / double(factor.cols());
  };
  CHECK_THAT(each(chain_of(1000)), WithinAbs(1, 0.002));
  CHECK_THAT(each(rope_of(1000)), WithinAbs(4, 0.02));
  CHECK_THAT(each(cloth_of(6)), WithinAbs(16, 1));
  CHECK_THAT(each(cloth_of(58)), WithinAbs(75, 3));
}

TEST_CASE("The matrix of cloth has 27 entries in a row at most, at any size") {
  for (const int side : {6, 18}) {
    const Sparse matrix = step_matrix_of(cloth_of(side));
    Eigen::Index most = 0;
    for (int j = 0; j < matrix.cols(); ++j) most = std::max(most, matrix.col(j).nonZeros());
    CHECK(most == 27);
  }
}

TEST_CASE("Fifty substeps hold the chain, and 49 lose it") {
  CHECK(substeps_for(steel_chain) == 50);
  CHECK(chain_after(50) < 0.1);
  CHECK_FALSE(chain_after(49) < 1e6);  // nor is it a number
}

TEST_CASE("The fastest motion of the chain has twice the h omega of its springs") {
  CHECK_THAT(frame * std::sqrt(steel_k / bead_mass), WithinRel(50, 1e-12));
  // Neighbours against neighbours, at a place far from both ends.
  Eigen::VectorXd x(steel_chain.count);
  for (int i = 0; i < steel_chain.count; ++i)
    x[i] = steel_chain.start().x[i] + (i % 2 == 0 ? 1e-3 : -1e-3);
  const Eigen::VectorXd a = steel_chain(x, steel_chain.start().v, 0.0);
  CHECK_THAT(frame * std::sqrt(-a[50] / 1e-3), WithinRel(100, 1e-9));
  CHECK_THAT(frame * fastest(steel_chain), WithinRel(100, 0.001));
}

TEST_CASE(
    "In 50 substeps the chain has up to 59 times its energy, and in 81 at most a fifth more") {
  CHECK_THAT(most_energy(steel_chain, 50), WithinAbs(59, 0.5));
  CHECK(most_energy(steel_chain, 80) > 1.2);
  CHECK(most_energy(steel_chain, 81) < 1.2);
  CHECK_THAT(most_energy(steel_rope, 50), WithinAbs(2.2, 0.05));
  CHECK(most_energy(steel_rope, 56) > 1.2);
  CHECK(most_energy(steel_rope, 57) < 1.2);
  CHECK_THAT(most_energy(steel_cloth, 68), WithinAbs(1.9, 0.05));
  CHECK(most_energy(steel_cloth, 90) > 1.2);
  CHECK(most_energy(steel_cloth, 91) < 1.2);
  // In many substeps there is nothing to gain: it is the method that puts the energy in.
  for (const double most : {most_energy(steel_chain, 400), most_energy(steel_rope, 400)})
    CHECK(most < 1.01);
}

TEST_CASE("With its velocities as they are stored the chain shows 117 times its energy") {
  CHECK_THAT(most_energy(steel_chain, 50, 0), WithinAbs(117, 0.5));
  CHECK(most_energy(steel_chain, 177, 0) > 1.2);
  CHECK(most_energy(steel_chain, 178, 0) < 1.2);
}

TEST_CASE(
    "On cloth of 18 x 18 conjugate gradients to a thousandth take twice the work of elimination") {
  const auto loose = by_conjugate_gradients(cloth_of(18), 1e-2);
  const auto tight = by_conjugate_gradients(cloth_of(18), 1e-3);
  CHECK_THAT(loose.iterations, WithinAbs(48, 1));
  CHECK(loose.first > 2.5);
  CHECK_THAT(tight.iterations, WithinAbs(101, 1));
  CHECK_THAT(tight.multiplications * 3 * 18 * 18 / work_of_step(cloth_of<Tallied>(18)),
             WithinAbs(2.25, 0.25));
  const auto direct = shares(cloth_of(18), gentle, 60, solved_once);
  CHECK(direct[1] < 0.5);
  CHECK_THAT(tight.last, WithinRel(direct.back(), 0.01));
}

TEST_CASE("At 10 cm/s the chain's fastest motion goes 17 micrometres out of place") {
  // A chain of two masses between walls, neighbours against neighbours, has twice the springs'
  // rate.
  const double rate = 2 * std::sqrt(steel_k / bead_mass);
  CHECK_THAT(0.1 / rate, WithinRel(17e-6, 0.03));
  CHECK_THAT(rate / (2 * std::numbers::pi), WithinRel(1000, 0.05));
  // And the slowest: where its shape is pulled back to by all masses alike.
  Eigen::VectorXd shape(steel_chain.count);
  for (int i = 0; i < steel_chain.count; ++i) {
    shape[i] = std::sin((i + 1) * std::numbers::pi / (2 * steel_chain.count + 1));
  }
  const double slow = 2 * std::numbers::pi * 6.9;
  const Eigen::VectorXd a = steel_chain(shape, steel_chain.start().v, 0.0);
  CHECK((a + slow * slow * shape).norm() < 0.01 * a.norm());
}

TEST_CASE("What there is to see stays what it is in half the steps", "[long]") {
  for (const std::string& net : nets) CHECK(off_of_truth(net, gentle) < 1e-4);
}

TEST_CASE(
    "In just enough substeps what is seen is off by one per cent of the chain, a tenth of that of "
    "the rope and a hundredth of the cloth") {
  const auto fewest = [](const std::string& net) {
    return off(net, "symplectic Euler", fewest_substeps(net));
  };
  CHECK_THAT(fewest("chain"), WithinAbs(0.01, 0.001));
  CHECK_THAT(fewest("rope"), WithinAbs(0.0008, 0.0001));
  CHECK_THAT(fewest("cloth"), WithinAbs(0.0001, 0.00001));
}

TEST_CASE(
    "One solve of backward Euler is off by 95 per cent of the chain, 1.7 of the rope and 33 of the "
    "cloth") {
  CHECK_THAT(off("chain", "backward Euler"), WithinAbs(0.95, 0.005));
  CHECK_THAT(off("rope", "backward Euler"), WithinAbs(0.0165, 0.0005));
  CHECK_THAT(off("cloth", "backward Euler"), WithinAbs(0.326, 0.005));
}

TEST_CASE(
    "One solve of BDF2 halves what backward Euler is off by on cloth, for one per cent more work") {
  CHECK_THAT(off("cloth", "BDF2") / off("cloth", "backward Euler"), WithinAbs(0.49, 0.01));
  CHECK_THAT(work("cloth", "BDF2") / work("cloth", "backward Euler"), WithinAbs(1.01, 0.005));
}

TEST_CASE(
    "A second solve brings BDF2 four times nearer on the rope, and backward Euler no nearer "
    "anywhere") {
  CHECK_THAT(off("rope", "BDF2") / off("rope", "BDF2 twice"), WithinAbs(4.1, 0.1));
  for (const std::string& net : nets) {
    CHECK(off(net, "backward Euler twice") > 0.99 * off(net, "backward Euler"));
    CHECK(off(net, "backward Euler to the end") > 0.99 * off(net, "backward Euler"));
  }
}

TEST_CASE("Where the fewest substeps can be paid, as many as a solved step costs show a net better",
          "[long]") {
  for (const std::string& net : nets) {
    const int fewest = fewest_substeps(net);
    const double least = work(net, "symplectic Euler", fewest);
    for (const Way& way : all_ways(net)) {
      if (way.answers && way.work > least) CHECK(way.method == "symplectic Euler");
    }
    // Nor is there anything beside what the figure shows.
    std::vector<Ask> asked;
    for (const char* method : {"backward Euler", "BDF2", "trapezoid"}) {
      for (const int solves : {1, 2, 3}) {
        for (const int steps : {1, 2, 3, 5, 7, 11}) asked.push_back({method, steps, solves});
      }
    }
    std::vector<Way> solved = moved(net, gentle, asked);
    std::erase_if(solved,
                  [least](const Way& way) { return way.work < least || way.work > 3 * least; });
    CHECK(solved.size() > 5);
    std::vector<Ask> paid;
    for (const Way& way : solved) {
      paid.push_back({"symplectic Euler", int(way.work / least * fewest)});
    }
    const std::vector<Way> substeps = moved(net, gentle, paid);
    for (std::size_t n = 0; n < solved.size(); ++n) {
      CAPTURE(net, solved[n].method, solved[n].steps, solved[n].work, substeps[n].steps);
      CHECK(substeps[n].work <= solved[n].work);
      CHECK(substeps[n].off < solved[n].off / 2);
    }
  }
}

TEST_CASE(
    "In a tenth more than the fewest substeps a net is shown at least four times as well as by "
    "anything cheaper, after each of three blows",
    "[long]") {
  for (const std::string& net : nets) {
    std::vector<Ask> asked{{"symplectic Euler", fewest_substeps(net) * 11 / 10}};
    for (const char* method : {"backward Euler", "BDF2", "trapezoid"}) {
      for (const int solves : {1, 2}) {
        for (const int steps : {1, 2, 3, 6}) asked.push_back({method, steps, solves});
      }
    }
    for (const unsigned blow : {1u, 2u, 3u}) {
      const std::vector<Way> all = moved(net, gentle, asked, blow);
      for (const Way& way : all) {
        CAPTURE(net, blow, way.method, way.steps, way.work, all[0].work);
        if (way.work < all[0].work) CHECK(way.off > 4 * all[0].off);
      }
    }
  }
}

TEST_CASE("Conjugate gradients cost twice to fifty times an elimination, and show no net better") {
  for (const std::string& net : nets) {
    for (const char* gradients : {"gradients to a hundredth", "gradients to a thousandth"}) {
      CAPTURE(net, gradients);
      CHECK(work(net, gradients) > 2 * work(net, "backward Euler"));
      CHECK(work(net, gradients) < 50 * work(net, "backward Euler"));
      CHECK(off(net, gradients) > 0.99 * off(net, "backward Euler"));
    }
  }
}

TEST_CASE("Four times the stiffness takes twice the substeps and the same work to solve") {
  auto stiffer = steel_chain;
  stiffer.k *= 4;
  CHECK(substeps_for(stiffer) == 2 * substeps_for(steel_chain));
  auto counted = chain_of<Tallied>(steel_chain.count), four_times = counted;
  four_times.k *= 4;
  CHECK(work_of_step(four_times) == work_of_step(counted));
}

TEST_CASE(
    "A rope on a nail takes 17 substeps at 10 kN/m, and one less loses it, at any stiffness") {
  CHECK(substeps_for(rope_on_a_nail(1e4)) == 17);
  for (const double stiffness : {1e3, 1e4, 1e5}) {
    const auto scene = rope_on_a_nail(stiffness);
    const auto size = [&](int substeps) {
      Struck s = scene.start();
      for (int n = 0; n < 180 * substeps; ++n) {
        symplectic_euler(s.x, s.v, 0.0, frame / substeps, scene);
      }
      return s.x.norm();
    };
    CHECK(size(substeps_for(scene)) < std::sqrt(scene.count) * 1.1 * scene.length);
    CHECK_FALSE(size(substeps_for(scene) - 1) < 1e6);  // nor is it a number
  }
}

TEST_CASE("Cloth of any size needs about seventy substeps") {
  for (const int side : {6, 10, 18, 32}) CHECK_THAT(substeps_for(cloth_of(side)), WithinAbs(70, 2));
}

TEST_CASE(
    "A solved chain saves twelve times the multiplications, a rope three times, at any size") {
  for (const int count : {50, 500}) {
    CHECK_THAT(saving(chain_of(count), chain_of<Tallied>(count)), WithinAbs(12.5, 0.5));
    CHECK_THAT(saving(rope_of(count), rope_of<Tallied>(count)), WithinAbs(3.2, 0.1));
  }
}

TEST_CASE("Cloth of 10 x 10 is cheaper solved, of 18 x 18 as cheap, of 32 x 32 dearer") {
  CHECK(cloth_saving(10) > 1.5);
  CHECK_THAT(cloth_saving(18), WithinAbs(1, 0.1));
  CHECK(cloth_saving(32) < 0.6);
}

TEST_CASE(
    "A second of BDF2 leaves a struck cloth twice what backward Euler does, and a chain nothing") {
  const auto of_cloth = shares(steel_cloth, gentle, 60, bdf2_once());
  const auto by_backward_euler = shares(steel_cloth, gentle, 60, solved_once);
  REQUIRE(of_cloth.size() == 61);
  CHECK_THAT(of_cloth.back() / by_backward_euler.back(), WithinAbs(2, 0.3));
  CHECK_THAT(shares(steel_rope, gentle, 60, bdf2_once()).back(), WithinAbs(0.71, 0.01));
  CHECK(shares(steel_chain, gentle, 60, bdf2_once()).back() < 1e-3);
}

TEST_CASE("A second after a gentle blow the rope has two thirds of its energy, the chain none") {
  const auto left = [](const auto& scene) { return shares(scene, gentle, 60, solved_once).back(); };
  CHECK(left(steel_chain) < 1e-12);
  CHECK_THAT(left(steel_rope), WithinAbs(0.68, 0.01));
  CHECK_THAT(left(steel_cloth), WithinAbs(0.085, 0.005));
}

TEST_CASE("In a hundred substeps a frame the rope keeps its energy to four per cent for a second") {
  REQUIRE(steel_rope.count == 36);
  Struck s = struck(steel_rope, gentle);
  const double first = steel_rope.energy(s.x, s.v), step = frame / 100;
  double least = first, most = first;
  for (int n = 0; n < 60 * 100; ++n) {
    symplectic_euler(s.x, s.v, 0.0, step, steel_rope);
    // Half a kick later the velocity belongs to the time of the position.
    const Eigen::VectorXd now = s.v + step / 2 * steel_rope(s.x, s.v, 0.0);
    least = std::min(least, steel_rope.energy(s.x, now));
    most = std::max(most, steel_rope.energy(s.x, now));
  }
  CHECK(least > 0.96 * first);
  CHECK(most < 1.04 * first);
}

TEST_CASE("A rope takes five or six of Newton's iterations, cloth after a hard blow eighteen") {
  CHECK(changes(steel_rope, gentle).size() == 5);
  CHECK(changes(steel_rope, hard).size() == 6);
  CHECK(changes(steel_cloth, hard).size() == 18);
}

TEST_CASE(
    "Rope and cloth leave out of their matrix how a compressed spring pushes its ends aside") {
  // A push across a spring, and what the matrix says that it does.
  const auto check = [](const auto& scene, double longer, bool same) {
    auto s = scene.start();
    s.x *= longer;
    const int middle = 3 * (scene.nodes() / 2) + 1;  // upwards, where nothing lies
    double in_matrix = 0;
    scene.jacobian(s.x, s.v, 0.0, [&](int i, int j, double dadx, double) {
      if (i == middle && j == middle) in_matrix += dadx;
    });
    auto aside = s.x;
    aside[middle] += 1e-6;
    const double true_slope = scene(aside, s.v, 0.0)[middle] / 1e-6;
    if (same) {
      CHECK(true_slope < 0);
      CHECK_THAT(in_matrix, WithinRel(true_slope, 1e-3));
    } else {
      CHECK(true_slope > 0);
      CHECK_THAT(in_matrix, WithinAbs(0, 1e-9 * true_slope));
    }
  };
  check(rope_of(9), 1.1, true);
  check(rope_of(9), 0.9, false);
  check(cloth_of(5), 1.1, true);
  check(cloth_of(5), 0.9, false);
}

TEST_CASE(
    "After a gentle blow most springs of the rope end their step compressed, after a hard one "
    "none") {
  const auto compressed = [](double speed) {
    Struck s = struck(steel_rope, speed);
    auto system = system_of(steel_rope);
    REQUIRE(to_the_end(s, steel_rope, system));
    int count = 0;
    for (int i = 1; i < steel_rope.count; ++i) {
      count += (s.x.segment<3>(3 * i) - s.x.segment<3>(3 * i - 3)).norm() <
               steel_rope.length / (steel_rope.count - 1);
    }
    return count;
  };
  CHECK(compressed(gentle) > steel_rope.count / 2);
  CHECK(compressed(hard) == 0);
}

TEST_CASE("On cloth the matrix is not quite the derivative, and each iteration gains a factor") {
  const auto found = changes(steel_cloth, hard);
  for (std::size_t n = 10; n < 17; ++n) {
    CHECK_THAT(found[n] / found[n - 1], WithinAbs(0.28, 0.02));
  }
}

TEST_CASE("After a hard blow one solve a step lifts the rope's energy by half, Newton by nothing") {
  const auto once = shares(steel_rope, hard, 60, solved_once);
  REQUIRE(once.size() == 61);
  CHECK_THAT(*std::max_element(once.begin(), once.end()), WithinAbs(1.57, 0.02));
  const auto end = shares(steel_rope, hard, 60, to_the_end);
  REQUIRE(end.size() == 61);
  for (std::size_t n = 1; n < end.size(); ++n) CHECK(end[n] < end[n - 1]);
  CHECK_THAT(end.back(), WithinAbs(0.47, 0.01));
}

TEST_CASE(
    "After a hard blow two solves of backward Euler never gain, and end within three per cent of "
    "Newton's end") {
  const auto check = [](const auto& scene) {
    const auto twice = shares(scene, hard, 60, solved_twice);
    REQUIRE(twice.size() == 61);
    for (std::size_t n = 1; n < twice.size(); ++n) CHECK(twice[n] < twice[n - 1]);
    CHECK_THAT(twice.back(), WithinRel(shares(scene, hard, 60, to_the_end).back(), 0.03));
  };
  check(steel_rope);
  check(steel_cloth);
}

TEST_CASE(
    "After a hard blow one solve of BDF2 lifts the rope's energy by a third, and cloth's to twice, "
    "and two lift neither") {
  const auto most = [](const auto& scene, auto step) {
    const auto left = shares(scene, hard, 60, step);
    REQUIRE(left.size() == 61);
    return *std::max_element(left.begin() + 1, left.end());
  };
  CHECK_THAT(most(steel_rope, bdf2_once()), WithinAbs(1.34, 0.02));
  CHECK_THAT(most(steel_cloth, bdf2_once()), WithinAbs(2.3, 0.2));
  CHECK(most(steel_rope, bdf2_twice()) < 1);
  CHECK(most(steel_cloth, bdf2_twice()) < 1);
}

TEST_CASE(
    "With one solve a step the trapezoid rule lifts the rope's energy 19 times, cloth's a "
    "million times") {
  const auto of_rope = shares(steel_rope, hard, 60, trapezoid_once);
  REQUIRE(of_rope.size() == 61);
  CHECK_THAT(of_rope.back(), WithinAbs(19, 1));
  CHECK(shares(steel_cloth, hard, 60, trapezoid_once).back() > 1e6);
}

TEST_CASE("Solved to the end the trapezoid rule keeps the rope's energy within a fifth") {
  const auto left = shares(steel_rope, hard, 60, trapezoid_to_the_end);
  REQUIRE(left.size() == 61);
  for (const double share : left) CHECK_THAT(share, WithinAbs(0.9, 0.11));
}

TEST_CASE("After a hard blow the trapezoid rule takes 23 solves a step to its end") {
  CHECK_THAT(solves_of_trapezoid(steel_rope, hard, 60), WithinAbs(23, 1));
}

TEST_CASE("Closed to a ring a chain of 108 has twice the entries in its factor") {
  Sparse matrix = step_matrix_of(steel_chain);
  matrix.coeffRef(0, 107) = matrix.coeffRef(107, 0) = matrix.coeff(0, 1);
  CHECK(factor_of(matrix).nonZeros() == 2 * 108 - 3);
}

namespace {

/// The recorded time of a frame, for each unknown [ns].
double time_of_frame(const std::string& net, const std::string& function) {
  return measure::recorded_times().of.at(frame_name(net, function)).median;
}

/// How much longer the fewest substeps take than one solved step.
double saved_time(const std::string& net) {
  return time_of_frame(net, "symplectic_euler") / time_of_frame(net, "backward_euler");
}

}  // namespace

TEST_CASE(
    "By the clock the fewest substeps take seven times a solved step of the chain, five of the "
    "rope, three of the cloth") {
  CHECK_THAT(saved_time("chain"), WithinAbs(7, 0.5));
  CHECK_THAT(saved_time("rope"), WithinAbs(5, 0.5));
  CHECK(saved_time("cloth") > 3);
  CHECK(saved_time("cloth") < 4);
  CHECK(saving(steel_chain, chain_of<Tallied>(steel_chain.count)) > 1.5 * saved_time("chain"));
  CHECK(saving(steel_rope, rope_of<Tallied>(steel_rope.count)) < 0.8 * saved_time("rope"));
  const auto& cloth = all_ways("cloth");
  CHECK(way_of(cloth, "symplectic Euler", fewest_substeps("cloth")).work <
        0.9 * saved_time("cloth") * way_of(cloth, "backward Euler").work);
}

TEST_CASE(
    "By the clock nothing solved in less time than the fewest substeps comes within four times "
    "their distance") {
  const std::map<std::string, std::string> functions{
      {"backward Euler", "backward_euler"}, {"BDF2", "bdf2"}, {"trapezoid", "trapezoid"}};
  for (const std::string& net : nets) {
    const auto& all = all_ways(net);
    const double nearest = way_of(all, "symplectic Euler", fewest_substeps(net)).off;
    int compared = 0;
    for (const Way& way : all) {
      const auto function = functions.find(way.method);
      if (function == functions.end()) continue;
      if (way.steps * time_of_frame(net, function->second) >=
          time_of_frame(net, "symplectic_euler"))
        continue;
      INFO(net << ": " << way.method << ", " << way.steps);
      CHECK(way.off > 4 * nearest);
      ++compared;
    }
    CHECK(compared >= 6);
  }
}
