// SPDX-License-Identifier: MIT-0
#include "judge/method.h"

#include <string_view>
#include <type_traits>
#include <utility>

#include "integrate/stormer_verlet.h"
#include "measure/methods.h"
#include "measure/run.h"

namespace judge {
namespace {

// The words that a sentence has for a method, if these are not its name.
std::string called(std::string_view name) {
  static constexpr std::pair<std::string_view, const char*> phrases[] = {
      {"Euler", "Euler's method"},
      {"midpoint", "the midpoint method"},
      {"Heun", "Heun's method"},
      {"constant acceleration", "the step of constant acceleration"},
      {"Yoshida 4", "Yoshida's method"}};
  for (const auto& [known, phrase] : phrases)
    if (known == name) return phrase;
  return std::string(name);
}

// A method of the book, with what it keeps from step to step. Its clock begins at zero.
template <class Of>
Step begin() {
  using Memory = decltype(measure::start(Of(), scenes::State<Vec>(), 0.0, Acceleration()));
  return [memory = Memory(), from = 0.0, begun = false](Vec& x, Vec& v, double t, double h,
                                                        const Acceleration& acceleration) mutable {
    if (!begun) from = t;
    const auto scene = [&](const Vec& at, const Vec& with, double since) {
      return acceleration(at, with, from + since);
    };
    if (!begun) memory = measure::start(Of(), scenes::State<Vec>{x, v}, h, scene);
    begun = true;
    measure::advance(Of(), memory, t - from, h, scene);
    const auto end = measure::to_state(Of(), memory, t - from + h, h, scene);
    x = end.x;
    v = end.v;
  };
}

template <class Of>
Method of_the_book() {
  return {called(Of::name), begin<Of>};
}

// Its velocity is the one of half a step ago; no other belongs to it.
Step begin_position_verlet() {
  return [previous = Vec{}, begun = false](Vec& x, Vec& v, double t, double h,
                                           const Acceleration& acceleration) mutable {
    if (!begun) previous = integrate::stormer_verlet_start(x, v, t, h, acceleration);
    begun = true;
    integrate::stormer_verlet(x, previous, t, h, acceleration);
    v = integrate::stormer_verlet_velocity(x, previous, h);
  };
}

}  // namespace

Method method(std::string name, Step step) {
  return {std::move(name), [step] { return step; }};
}

const Method euler = of_the_book<measure::Euler>();
const Method symplectic_euler = of_the_book<measure::SymplecticEuler>();
const Method symplectic_euler_position_first = of_the_book<measure::SymplecticEulerPositionFirst>();
const Method midpoint = of_the_book<measure::Midpoint>();
const Method heun = of_the_book<measure::Heun>();
const Method rk4 = of_the_book<measure::Rk4>();
const Method velocity_verlet = of_the_book<measure::VelocityVerlet>();
const Method yoshida4 = of_the_book<measure::Yoshida4>();
const Method position_verlet{"position Verlet", begin_position_verlet};

const std::vector<Method>& methods() {
  static const std::vector<Method> all = [] {
    std::vector<Method> methods;
    list::for_each(list::EveryExplicit(),
                   [&](auto of) { methods.push_back(of_the_book<decltype(of)>()); });
    methods.push_back(position_verlet);
    return methods;
  }();
  return all;
}

Path run(const Method& method, const Start& start, double h, int steps, int every,
         const Acceleration& acceleration) {
  const Step step = method.begin();
  Path path{start.t, h, every, {{start.x, start.v}}, {}};
  State now = path.states.front();
  for (int n = 0; n < steps; ++n) {
    step(now.x, now.v, start.t + n * h, h, acceleration);
    if ((n + 1) % every == 0) path.states.push_back(now);
  }
  return path;
}

Path watch(const Method& method, const Start& start, double h, int steps,
           const Acceleration& acceleration) {
  std::vector<Evaluation> evaluations;
  const Acceleration kept = [&](const Vec& x, const Vec& v, double t) {
    evaluations.push_back({x, v, t, acceleration(x, v, t)});
    return evaluations.back().a;
  };
  Path path = run(method, start, h, steps, 1, kept);
  path.evaluations = std::move(evaluations);
  return path;
}

Path truth(const Start& start, double h, int steps, int every, const Acceleration& acceleration) {
  constexpr double small = 1.0 / 1024;
  const int parts = static_cast<int>(std::ceil(std::abs(h) / small));
  Path path = run(rk4, start, h / parts, steps * parts, every * parts, acceleration);
  path.h = h;
  path.every = every;
  return path;
}

State truth_past_a_sun(const Start& start, double duration, double mu,
                       const Acceleration& acceleration) {
  constexpr double part = 0.005;  // of the time that a radian of a circle takes
  const Step step = rk4.begin();
  State now{start.x, start.v};
  for (double t = 0, h = 0; t < duration; t += h) {
    h = std::min(part * std::sqrt(std::pow(length(now.x), 3) / mu), duration - t);
    step(now.x, now.v, start.t + t, h, acceleration);
  }
  return now;
}

}  // namespace judge
