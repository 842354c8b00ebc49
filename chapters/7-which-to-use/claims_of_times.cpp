// SPDX-License-Identifier: MIT-0
// The claims of chapter 7 about times, as they were recorded. Each name is a sentence that the
// chapter says.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "choose/entrants.h"
#include "particles.h"
#include "peers.h"
#include "work_precision.h"

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using measure::Method;
using method::backward_euler;
using method::euler;
using method::rk4;
using method::symplectic_euler;
using method::velocity_verlet;

namespace {

/// The recorded times of a step of the shuttle [ns].
double of_one(const Method& method) {
  return step_time("shuttle", one_body, method);
}
double of_512(const Method& method) {
  return step_time("shuttle", in_a_loop, method);
}

}  // namespace

TEST_CASE("Alone, a shuttle takes symplectic Euler as long as midpoint, twice as long as Euler") {
  CHECK_THAT(of_one(symplectic_euler) / of_one(method::midpoint), WithinAbs(1, 0.1));
  CHECK_THAT(of_one(symplectic_euler) / of_one(euler), WithinAbs(2, 0.2));
}

TEST_CASE(
    "Of 512 shuttles the swapped lines and Verlet take Euler's time, midpoint twice as much") {
  const double one = of_512(euler);
  for (const Method* asks_once :
       {&symplectic_euler, &velocity_verlet, &method::leapfrog, &method::stormer_verlet})
    CHECK_THAT(of_512(*asks_once) / one, WithinAbs(1, 0.1));
  for (const Method* asks_twice : {&method::midpoint, &method::heun, &method::predicted_euler})
    CHECK_THAT(of_512(*asks_twice) / one, WithinAbs(2, 0.2));
}

TEST_CASE("Of 512 shuttles RK4 takes five times Euler's time, Dormand-Prince ten times") {
  CHECK_THAT(of_512(rk4) / of_512(euler), WithinAbs(5, 0.5));
  CHECK_THAT(of_512(method::dopri5) / of_512(euler), WithinAbs(10, 0.8));
}

TEST_CASE("Alone, a shuttle takes RK4 twice as long as midpoint, and Yoshida three times") {
  CHECK_THAT(of_one(rk4) / of_one(method::midpoint), WithinAbs(2, 0.1));
  CHECK_THAT(of_one(method::yoshida4) / of_one(method::midpoint), WithinAbs(3, 0.15));
}

TEST_CASE("Of 512 shuttles Yoshida's step takes about as long as RK4's, not three of Verlet's") {
  CHECK_THAT(of_512(method::yoshida4) / of_512(rk4), WithinAbs(1, 0.15));
  CHECK(of_512(method::yoshida4) > 4 * of_512(velocity_verlet));
  // Alone, it is three of Verlet's: there, both wait.
  CHECK_THAT(of_one(method::yoshida4), WithinRel(3 * of_one(velocity_verlet), 0.1));
}

TEST_CASE(
    "Of 512 shuttles an implicit step takes nearly twice the time of its evaluations, or more") {
  const double one = of_512(euler);
  CHECK(of_512(backward_euler) > 1.8 * one * double(price(backward_euler, shuttle, frame)));
  CHECK(of_512(method::trapezoid) > 1.8 * one * double(price(method::trapezoid, shuttle, frame)));
}

TEST_CASE(
    "On the machine of the times a step of one of 100 000 shuttles takes what one of 512 takes") {
  for (const Method* entrant : entrants) {
    INFO(entrant->name);
    CHECK_THAT(step_time("shuttle", beyond_the_cache, *entrant) / of_512(*entrant),
               WithinAbs(1, 0.15));
  }
}

TEST_CASE("On the suspension one step of RK4 is nearer than four of velocity Verlet, and quicker") {
  const auto quick = [](const Method& method) {
    return step_time("suspension", in_a_loop, method);
  };
  CHECK(quick(rk4) < 4 * quick(velocity_verlet));
  CHECK(quick(rk4) > 3 * quick(velocity_verlet));
  CHECK(max_position_error(rk4, suspension, frame, 1) <
        max_position_error(velocity_verlet, suspension, frame / 4, 1));
}

TEST_CASE("In packs of floats a step takes a quarter of its time in structs of doubles, or less") {
  for (const Method* swings : {&symplectic_euler, &velocity_verlet}) {
    CHECK(step_time("packs of float", in_a_loop, *swings) <
          0.25 * step_time("structs of double", in_a_loop, *swings));
  }
}

namespace {

/// Prices that are not those of the figure, from one that `rates[0]` steps of velocity Verlet cost.
std::vector<double> other_prices(double from, double to) {
  std::vector<double> all;
  for (double price = 1.01 * from; price < to; price *= 1.37) all.push_back(price);
  return all;
}

/// The nearest in a thing of the level, by price, at many prices.
/// @param cost  `&Offer::evaluations` or `&Offer::nanoseconds`
/// @param without  a method that is not taken; null if all are
std::map<double, BestForBudget> nearest(const std::string& wanted, double MethodCost::* cost,
                                        const Method* without = nullptr) {
  std::map<double, BestForBudget> found;
  for_each_thing([&](const std::string& thing, const auto& scene, double seconds) {
    if (thing != wanted) return;
    std::vector<MethodCost> costs = costs_of(entrants_on(scene), thing, scene);
    const auto verlet = std::find_if(costs.begin(), costs.end(), [](const MethodCost& candidate) {
      return candidate.method == &velocity_verlet;
    });
    const double least = rates[0] * (*verlet).*cost;
    std::erase_if(costs, [&](const MethodCost& candidate) { return candidate.method == without; });
    for (const double price : other_prices(least, 300 * least))
      found[price] = best_for(price, cost, costs, scene, seconds, nullptr);
  });
  return found;
}

bool is_ever_nearest(const Method& method, const std::string& thing, double MethodCost::* cost) {
  const auto all = nearest(thing, cost);
  return std::any_of(all.begin(), all.end(),
                     [&](const auto& one) { return one.second.method == &method; });
}

constexpr const char* things[] = {"jump", "leaf", "suspension", "hatch", "lamp", "shuttle"};

}  // namespace

TEST_CASE("For the fewest evaluations velocity Verlet is nearest on five of the six") {
  for (const std::string thing : things) {
    INFO(thing);
    CHECK((nearest(thing, &MethodCost::evaluations).begin()->second.method == &velocity_verlet) ==
          (thing != "hatch"));
  }
}

TEST_CASE(
    "For 300 evaluations or more Dormand-Prince is nearest on all that is not exact or stiff") {
  for (const std::string thing : {"suspension", "lamp", "shuttle"}) {
    for (const auto& [price, best] : nearest(thing, &MethodCost::evaluations)) {
      CAPTURE(thing, price);
      if (price >= 300 && best.error > 1e-9) CHECK(best.method == &method::dopri5);
    }
  }
}

TEST_CASE("By evaluations Yoshida's method is worth its price on the lamp and the shuttle alone") {
  for (const std::string thing : things) {
    INFO(thing);
    CHECK(is_ever_nearest(method::yoshida4, thing, &MethodCost::evaluations) ==
          (thing == "lamp" || thing == "shuttle"));
  }
}

TEST_CASE("By time Yoshida's method is nowhere twice as near as the best of the others") {
  for (const std::string thing : things) {
    const auto others = nearest(thing, &MethodCost::nanoseconds, &method::yoshida4);
    for (const auto& [price, best] : nearest(thing, &MethodCost::nanoseconds)) {
      CAPTURE(thing, price);
      if (best.method == &method::yoshida4) CHECK(others.at(price).error < 2 * best.error);
    }
  }
}

TEST_CASE(
    "By time the hatch belongs to the implicit methods from five centimetres to a millimetre") {
  int seen = 0;
  for (const auto& [price, best] : nearest("hatch", &MethodCost::nanoseconds)) {
    CAPTURE(price);
    if (best.error < 0.001 || best.error > 0.05) continue;
    CHECK((best.method == &method::backward_euler_spring || best.method == &method::trapezoid));
    ++seen;
  }
  CHECK(seen > 5);
}

TEST_CASE("Where the trapezoid rule is the answer on the hatch it does not ring") {
  const double fast = hatch.omega * (hatch.zeta + std::sqrt(hatch.zeta * hatch.zeta - 1));
  int seen = 0;
  const auto costs = costs_of(entrants_on(hatch), "hatch", hatch);
  for (const auto& [price, best] : answers(by_time("hatch"), costs, hatch, 1)) {
    if (best.method != &method::trapezoid) continue;
    const double rate = 1e3 * price / step_time("hatch", in_a_loop, method::trapezoid);
    CHECK(fast / rate < 2);  // from there on (1 - hr/2)/(1 + hr/2) is above zero
    ++seen;
  }
  CHECK(seen > 2);
  CHECK(fast * frame > 2);  // at one step a frame it rings
}

TEST_CASE("A step of a thousand things takes less than a hundredth of a frame under any method") {
  for_each_thing([](const std::string& thing, const auto& scene, double) {
    for (const auto& methods : {entrants_on(scene), exact_steps_of(scene)}) {
      for (const MethodCost& candidate : costs_of(methods, thing, scene)) {
        CAPTURE(thing, candidate.method->name);
        CHECK(1e-9 * 1000 * candidate.nanoseconds < 0.01 * frame);
      }
    }
  });
}

namespace {

/// The recorded time of a step of one particle [ns].
double particle_time(const std::string& layout, long count) {
  return measure::recorded_times().at(particles_name(layout, count)).median;
}

}  // namespace

TEST_CASE("To move particles never takes less time than to touch their memory") {
  for (const long count : particle_counts) {
    CHECK(particle_time("packs", count) >= particle_time("memory", count));
    CHECK(particle_time("structs", count) >= particle_time("memory", count));
  }
}

TEST_CASE(
    "While the nearest caches hold the particles, packs take a fifth of the time of structs") {
  for (const long count : {4'096, 16'384})
    CHECK_THAT(particle_time("packs", count) / particle_time("structs", count),
               WithinAbs(0.2, 0.04));
}

TEST_CASE("A step of four million packs takes over twice as long, most of it for the memory") {
  const double packs = particle_time("packs", 4'194'304);
  CHECK(packs > 2 * particle_time("packs", 4'096));
  CHECK(particle_time("memory", 4'194'304) > 0.7 * packs);
}

TEST_CASE(
    "With 16 steps a visit a step takes the same time to a fifth, of each number of packs that was "
    "timed") {
  const double fewest = particle_time("blocks", 4'096);
  for (const long count : particle_counts)
    CHECK_THAT(particle_time("blocks", count) / fewest, WithinAbs(1, 0.2));
}

TEST_CASE("On a planet the headers take the time of a loop by hand, and so does odeint on arrays") {
  for (const char* method : {"symplectic_euler", "velocity_verlet", "rk4"}) {
    const double by_hand = library_time(method, "by hand");
    for (const char* called : {"header struct", "header Vector2d", "odeint array"}) {
      CAPTURE(method, called);
      CHECK_THAT(library_time(method, called) / by_hand, WithinAbs(1, 0.1));
    }
  }
}

TEST_CASE(
    "For a step of RK4 GSL takes twice the time of the loop by hand, SUNDIALS over twelve times") {
  const double by_hand = library_time("rk4", "by hand");
  CHECK_THAT(library_time("rk4", "GSL") / by_hand, WithinAbs(2.2, 0.3));
  CHECK_THAT(library_time("rk4", "SUNDIALS ERKStep") / by_hand, WithinAbs(12.5, 0.5));
}

TEST_CASE("Of 512 planets the headers on a struct take the time of a loop by hand") {
  for (const char* method : {"symplectic_euler", "velocity_verlet", "rk4", "dopri5"}) {
    CAPTURE(method);
    CHECK_THAT(library_time(method, "header struct", true) / library_time(method, "by hand", true),
               WithinAbs(1, 0.1));
  }
}

TEST_CASE("On the same vectors no library takes less time for one of 512 planets than a header") {
  struct Pair {
    const char *library, *header;
  };
  for (const char* method : {"symplectic_euler", "velocity_verlet", "rk4", "dopri5"})
    for (const auto& [library, header] : {Pair{"odeint array", "header struct"},
                                          {"odeint classic array", "header struct"},
                                          {"odeint Eigen", "header Vector2d"},
                                          {"odeint vector", "header one Vec"},
                                          {"GSL", "header struct"},
                                          {"SUNDIALS ERKStep", "header struct"}}) {
      const std::string name = library_name(method, library, true);
      if (!measure::recorded_times("libraries.csv").of.contains(name)) continue;
      CAPTURE(method, library);
      CHECK(library_time(method, library, true) > 0.93 * library_time(method, header, true));
    }
}

TEST_CASE("Of 512 planets RK4 takes GSL twice the time of the loop by hand, SUNDIALS six times") {
  const double by_hand = library_time("rk4", "by hand", true);
  CHECK_THAT(library_time("rk4", "GSL", true) / by_hand, WithinAbs(2, 0.3));
  CHECK_THAT(library_time("rk4", "SUNDIALS ERKStep", true) / by_hand, WithinAbs(6.3, 0.7));
}

TEST_CASE("Of 512 planets symplectic Euler takes a quarter of the time of one, RK4 over half") {
  const auto share = [](const char* method) {
    return library_time(method, "header struct", true) / library_time(method, "header struct");
  };
  CHECK_THAT(share("symplectic_euler"), WithinAbs(0.25, 0.03));
  CHECK_THAT(share("rk4"), WithinAbs(0.55, 0.05));
}

TEST_CASE("Times of particles that undercut their limit are forgotten, and others kept") {
  measure::Times times = measure::recorded_times();
  forget_if_disturbed(times);
  CHECK(times.of == measure::recorded_times().of);
  times.of[particles_name("packs", 65'536)].median = 0.9 * particle_time("memory", 65'536);
  forget_if_disturbed(times);
  CHECK_FALSE(times.of.contains(particles_name("structs", 4'096)));
  CHECK(times.of.contains("shuttle/1/rk4"));
}

TEST_CASE("What nobody took the time of has none, and is bought for no time") {
  CHECK(std::isnan(step_time("spoon", one_body, rk4)));
  const std::vector<MethodCost> costs{{&rk4, 4, NAN}, {&euler, 1, 3}};
  CHECK(best_for(1e6, &MethodCost::nanoseconds, costs, leaf, 2, nullptr).method == &euler);
  CHECK(best_for(1e6, &MethodCost::evaluations, costs, leaf, 2, nullptr).method == &rk4);
}
