// SPDX-License-Identifier: MIT-0
#include "judge/diagnose.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "format_values.h"
#include "judge/describe.h"

namespace judge {
namespace {

using grade::number;

// Two things agree if they do to ten digits: what a rounding apart never misses, and a mistake
// never meets.
constexpr double ten_digits = 1e-10;

double size(const Path& path) {
  double largest = 0;
  for (const State& state : path.states) largest = larger(largest, distance(state, State{}));
  return largest;
}

double apart(const Path& a, const Path& b) {
  double largest = 0;
  for (std::size_t n = 0; n < std::min(a.states.size(), b.states.size()); ++n) {
    largest = larger(largest, distance(a.states[n], b.states[n]));
  }
  return largest;
}

bool alike(const Path& a, const Path& b) {
  return apart(a, b) <= ten_digits * size(b);
}

// The path with its states moved by so many places.
bool shifted(const Path& yours, const Path& expected, std::size_t late, std::size_t early) {
  if (expected.states.size() < 3) return false;
  double largest = 0;
  for (std::size_t n = 1; n + 1 < expected.states.size(); ++n) {
    largest = larger(largest, distance(yours.states[n + late], expected.states[n + early]));
  }
  return largest <= ten_digits * size(expected);
}

Path negative(Path path) {
  for (State& state : path.states) state = {-state.x, -state.v};
  return path;
}

bool never_changes(const Path& path) {
  return std::all_of(path.states.begin(), path.states.end(),
                     [&](const State& state) { return distance(state, path.states.front()) == 0; });
}

// Right to about seven digits after one step, and no further: something went through a float.
// Right to nine: a float that counts little, or a number that was typed.
std::string too_few_digits(const Path& yours, const Path& expected) {
  const std::size_t questions = std::min(yours.evaluations.size(), expected.evaluations.size());
  for (std::size_t n = 0; n < questions; ++n) {
    const double right = expected.evaluations[n].t;
    if (std::abs(yours.evaluations[n].t - right) > 1e-5 * (1 + std::abs(right))) return "";
  }
  const double first = distance(yours.states[1], expected.states[1]) / size(expected);
  if (first > 1e-9 && first < 2e-6)
    return "right to seven digits and no further: a float, or a constant with an f?";
  if (first > ten_digits && first <= 1e-9)
    return "right to nine digits and no further: a constant with too few digits, or a float?";
  return "";
}

struct Part {
  double of_step;
  const char* name;
};

constexpr std::array<Part, 7> parts{{{0, ""},
                                     {1, "h"},
                                     {0.5, "h/2"},
                                     {1.0 / 3, "h/3"},
                                     {2.0 / 3, "2h/3"},
                                     {0.25, "h/4"},
                                     {0.75, "3h/4"}}};

// The first question that was asked elsewhere than it should; how many both have if there is none.
std::size_t first_elsewhere(const Path& yours, const Path& expected) {
  const double tolerance = ten_digits * size(expected);
  std::size_t n = 0;
  for (; n < std::min(yours.evaluations.size(), expected.evaluations.size()); ++n) {
    const Evaluation &a = yours.evaluations[n], &b = expected.evaluations[n];
    const double off = larger(larger(length(a.x - b.x), length(a.v - b.v)), std::abs(a.t - b.t));
    if (!(off <= tolerance)) break;
  }
  return n;
}

// The number of evaluations of a step, with the one to begin with of a method that carries its
// last.
std::size_t in_first_step(const Path& path) {
  const std::size_t steps = path.states.size() - 1;
  return path.evaluations.size() / steps + path.evaluations.size() % steps;
}

// "x + h v", if it lies so along the rate; else its numbers. Who takes steps back has an h above
// zero, and the time at the start of the step.
std::string along(const Vec& got, const Vec& from, const Vec& rate, const std::string& name,
                  const std::string& name_of_rate, const Path& path, double tolerance) {
  if (!std::isfinite(length(got))) return "not a number";
  if (length(got - from) <= tolerance) return name;
  for (const Part& part : parts) {
    for (const double sign : {1.0, -1.0}) {
      const double way = sign * part.of_step * std::abs(path.h);
      if (length(got - (from + way * rate)) > tolerance) continue;
      return name + (sign > 0 ? " + " : " - ") + part.name + " " + name_of_rate;
    }
  }
  return describe(got);
}

std::string clock(double t, const Path& path, double tolerance) {
  const double start = path.t + std::min(path.h, 0.0);
  for (const Part& part : parts) {
    for (const double sign : {1.0, -1.0}) {
      const double away = t - (start + sign * part.of_step * std::abs(path.h));
      if (!(std::abs(away) <= tolerance)) continue;
      return part.of_step == 0 ? "t" : std::string(sign > 0 ? "t + " : "t - ") + part.name;
    }
  }
  return number(t);
}

// The place of an evaluation in the terms of the first step: by its x, v and t, and by the first
// acceleration.
std::string where(const Evaluation& asked, const Path& expected, double tolerance) {
  const State& start = expected.states.front();
  const Vec a = expected.evaluations.front().a;
  return "(" + along(asked.x, start.x, start.v, "x", "v", expected, tolerance) + ", " +
         along(asked.v, start.v, a, "v", "a", expected, tolerance) + ", " +
         clock(asked.t, expected, tolerance) + ")";
}

// The method with a mistake that leaves every line as it is.
struct Mistake {
  const char* says;
  Method method;
};

Mistake with_wrong_sign(const Method& right) {
  return {"the acceleration counts with the wrong sign",
          {right.name, [right] {
             return Step([step = right.begin()](Vec& x, Vec& v, double t, double h,
                                                const Acceleration& acceleration) {
               step(x, v, t, h, [&](const Vec& at, const Vec& with, double when) {
                 return -acceleration(at, with, when);
               });
             });
           }}};
}

Mistake without_h(const Method& right) {
  return {"h is missing: this is a step of one second",
          {right.name, [right] {
             return Step([step = right.begin()](Vec& x, Vec& v, double t, double h,
                                                const Acceleration& acceleration) {
               step(x, v, t, std::copysign(1, h), acceleration);
             });
           }}};
}

// A second step that is off by more than a float, of which the first may have shown nothing.
bool first_step_alone(const Path& yours, const Path& expected) {
  constexpr double of_a_float = 2e-6;
  return expected.every == 1 && expected.states.size() > 2 &&
         distance(yours.states[1], expected.states[1]) <= ten_digits * size(expected) &&
         distance(yours.states[2], expected.states[2]) > of_a_float * size(expected);
}

// The questions of the first step are right, and what is made of them is not.
std::string wrong_sum(const Path& yours, const Path& expected, std::size_t first_elsewhere) {
  const std::size_t in_a_step = in_first_step(expected);
  const double tolerance = ten_digits * size(expected);
  const State &end = yours.states[1], &right = expected.states[1];
  const bool x = length(end.x - right.x) > tolerance, v = length(end.v - right.v) > tolerance;
  if (expected.every != 1 || in_a_step == 0 || first_elsewhere < in_a_step || (!x && !v)) return "";
  return std::string(
             "the first step asks for the acceleration where it should, and then ends with "
             "the wrong ") +
         (x && v ? "place and velocity: look at the last lines"
          : x    ? "place: look at the line that moves x"
                 : "velocity: look at the line that changes v");
}

struct Ratio {
  double value;
  const char* says;
};

constexpr std::array<Ratio, 8> ratios{{
    {-1, "this is minus the right answer"},
    {180 / std::numbers::pi, "57.3 times the right answer: degrees where radians are meant?"},
    {std::numbers::pi / 180, "the right answer over 57.3: radians where degrees are meant?"},
    {1000, "1000 times the right answer: milli?"},
    {0.001, "a thousandth of the right answer: milli?"},
    {2 * std::numbers::pi, "2 pi times the right answer: turns or radians?"},
    {2, "twice the right answer"},
    {0.5, "half the right answer"},
}};

}  // namespace

std::vector<std::string> asked_elsewhere(const Path& yours, const Path& expected) {
  const std::size_t both = std::min(yours.evaluations.size(), expected.evaluations.size());
  const bool as_many = yours.evaluations.size() == expected.evaluations.size();
  const double tolerance = ten_digits * size(expected);
  const std::size_t n = first_elsewhere(yours, expected);
  // What comes in the next step's place, because a step asks more or less often, is no place of its
  // own.
  const std::size_t in_a_step = std::min(in_first_step(yours), in_first_step(expected));
  if (n < both && (as_many || n < in_a_step)) {
    const Evaluation &a = yours.evaluations[n], &b = expected.evaluations[n];
    return {"evaluation " + std::to_string(n + 1) + " of the acceleration was at " +
            where(a, expected, tolerance) + "; here it should be at " +
            where(b, expected, tolerance)};
  }
  if (as_many) return {};
  return {"it evaluated the acceleration " + std::to_string(yours.evaluations.size()) +
          " times in these steps; this method does " + std::to_string(expected.evaluations.size()) +
          " times"};
}

std::vector<std::string> diagnose(const Path& yours, const Method& asked,
                                  const std::function<Path(const Method&)>& run_by) {
  const Path expected = run_by(asked);
  const std::size_t broken = first_not_finite(yours);
  if (broken < yours.states.size()) {
    return {"the first state that is not a finite number comes after step " +
            std::to_string(broken * static_cast<std::size_t>(yours.every))};
  }
  if (never_changes(yours)) return {"the state never changes"};
  for (const Method& known : methods()) {
    const Path theirs = run_by(known);
    if (!alike(yours, theirs)) continue;
    const double off = apart(yours, theirs) / size(theirs);
    return {"this is " + known.name + " to " + number(std::max(off, 1e-16), 1)};
  }
  for (const Mistake& mistake : {with_wrong_sign(asked), without_h(asked)}) {
    if (alike(yours, run_by(mistake.method))) return {mistake.says};
  }
  std::vector<std::string> found;
  if (alike(yours, negative(expected))) found.push_back("this is minus the right path");
  if (shifted(yours, expected, 0, 1)) found.push_back("this is one step ahead");
  if (shifted(yours, expected, 1, 0)) found.push_back("this is one step behind");
  if (const std::string digits = too_few_digits(yours, expected); !digits.empty()) {
    found.push_back(digits);
    return found;
  }
  if (first_step_alone(yours, expected)) {
    found.push_back(
        "the first step is right, and the second is not: what is left over from the first?");
  }
  const bool as_often = yours.evaluations.size() == expected.evaluations.size();
  const std::string sum =
      as_often ? wrong_sum(yours, expected, first_elsewhere(yours, expected)) : "";
  const std::vector<std::string> elsewhere =
      sum.empty() ? asked_elsewhere(yours, expected) : std::vector{sum};
  found.insert(found.end(), elsewhere.begin(), elsewhere.end());
  return found;
}

std::vector<std::string> diagnose(double yours, double expected) {
  if (std::isnan(yours)) return {"this is not a number (NaN)"};
  if (std::isinf(yours)) return {"this is infinite"};
  const double ratio = yours / expected;
  for (const Ratio& known : ratios) {
    if (std::abs(ratio / known.value - 1) < ten_digits) return {known.says};
  }
  if (yours == std::trunc(expected) && std::abs(yours) >= 1) {
    return {"the right answer without what stands behind its point: a division of integers?"};
  }
  if (like_a_float(std::abs(ratio - 1))) {
    return {"right to seven digits and no further: a float, or a constant with an f?"};
  }
  return {};
}

}  // namespace judge
