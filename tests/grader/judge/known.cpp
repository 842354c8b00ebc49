// SPDX-License-Identifier: MIT-0
// What the grader makes of answers that a known wrong way gives, too.
#include "judge/known.h"

#include <catch2/catch_test_macros.hpp>
#include <cstdlib>

using judge::Exchange;
using judge::Known;
using Says = std::vector<std::string>;

namespace {

constexpr const char* exercise = "0-none/square-of-a-number";

void square(harness::Call& call) {
  const double x = call.number();
  call.answer(x * x);
}

void twice(harness::Call& call) {
  call.answer(2 * call.number());
}

void added(harness::Call& call) {
  const double x = call.number();
  call.answer(x + x);
}

void cube(harness::Call& call) {
  const double x = call.number();
  call.answer(x * x * x);
}

// Right once.
void remembers(harness::Call& call) {
  static double first = call.number();
  call.answer(first * first);
}

// Where the acceleration is asked for and what it is times two.
void asks(harness::Call& call) {
  const Vec a = harness::ask({call.number(), 0, 0}, {}, 0);
  call.answer(2 * a.x);
}

void never_returns(harness::Call&) {
  for (volatile bool on = true; on;) {
  }
}

void crashes(harness::Call&) {
  std::abort();
}

const Known known(exercise, square,
                  {{"this is twice the number", twice},
                   {"the number is added to itself", added},
                   {"this is the cube", cube},
                   {"the first number counts for all", remembers},
                   {"this asks, and takes it twice", asks},
                   {"this crashes", crashes}});

constexpr const char* endless = "0-none/endless";
const Known known_endless(endless, square,
                          {{"this never returns", never_returns}, {"this is the cube", cube}});

Says recognised(const judge::Programs& programs) {
  return Known::recognised(exercise, programs);
}

}  // namespace

TEST_CASE("A known wrong way speaks where the answers are its own, and nowhere else",
          "[grader][judge]") {
  CHECK(recognised({{{0, {3}, {}, {27}}}}) == Says{"this is the cube"});
  CHECK(recognised({{{0, {3}, {}, {28}}}}).empty());
  CHECK(recognised({{{0, {3}, {}, {9}}}}).empty());
  // In one call right and in another wrong in its way.
  CHECK(recognised({{{0, {1}, {}, {1}}, {0, {3}, {}, {27}}}}) == Says{"this is the cube"});
  CHECK(recognised({{{0, {3}, {}, {27}}, {0, {2}, {}, {5}}}}).empty());
}

TEST_CASE("A known wrong way that never returns is no answer", "[grader][judge]") {
  CHECK(Known::recognised(endless, {{{0, {3}, {}, {27}}}}) == Says{"this is the cube"});
}

TEST_CASE("Known wrong ways that answer alike are named together", "[grader][judge]") {
  CHECK(recognised({{{0, {3}, {}, {6}}}}) ==
        Says{"either this is twice the number, or the number is added to itself"});
}

TEST_CASE("What a known wrong way remembers ends with its program", "[grader][judge]") {
  const std::vector<Exchange> program{{0, {3}, {}, {9}}, {0, {4}, {}, {9}}};
  CHECK(recognised({program}) == Says{"the first number counts for all"});
  CHECK(recognised({program, {{0, {5}, {}, {25}}}}) == Says{"the first number counts for all"});
  CHECK(recognised({{program[0], program[1], {0, {5}, {}, {25}}}}).empty());
}

TEST_CASE("A known wrong way is told what the student was told, where it asks the same",
          "[grader][judge]") {
  const judge::Evaluation there{{3, 0, 0}, {}, 0, {7, 0, 0}},
      elsewhere{{4, 0, 0}, {}, 0, {7, 0, 0}};
  CHECK(recognised({{{0, {3}, {there}, {14}}}}) == Says{"this asks, and takes it twice"});
  CHECK(recognised({{{0, {3}, {elsewhere}, {14}}}}).empty());
}

TEST_CASE("Ten digits are enough to be known, and seven are those of a float", "[grader][judge]") {
  CHECK(recognised({{{0, {3}, {}, {27 + 1e-10}}}}) == Says{"this is the cube"});
  CHECK(recognised({{{0, {3}, {}, {27 + 1e-6}}}}).empty());
  const Says a_float{"right to seven digits and no further: a float, or a constant with an f?"};
  CHECK(recognised({{{0, {3}, {}, {9 + 1e-6}}}}) == a_float);
}

TEST_CASE("The first wrong answer is found, if nothing must come before it", "[grader][judge]") {
  const judge::Programs programs{{{0, {3}, {}, {9}}, {0, {4}, {}, {9}}}};
  const Exchange* wrong = Known::first_wrong(exercise, programs);
  REQUIRE(wrong);
  CHECK(wrong->arguments[0] == 4);
  CHECK(Known::first_wrong(exercise, {{{0, {3}, {}, {9}}}}) == nullptr);
  CHECK(Known::is_right(exercise, {0, {4}, {}, {16}}));
}
