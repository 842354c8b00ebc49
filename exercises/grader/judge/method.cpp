// SPDX-License-Identifier: MIT-0
#include "judge/method.h"

#include "integrate/stormer_verlet.h"
#include "integrate/velocity_verlet.h"
#include "integrate/yoshida4.h"
#include "measure/methods.h"

namespace judge {
namespace {

// The acceleration that velocity Verlet and Yoshida's method carry from step to step.
template <class Begin, class Advance>
std::function<Step()> carrying(Begin begin, Advance advance) {
  return [=]() -> Step {
    return [=, a = Vec{}, begun = false](Vec& x, Vec& v, double t, double h,
                                         const Acceleration& acceleration) mutable {
      if (!begun) a = begin(x, v, t, acceleration);
      begun = true;
      advance(x, v, a, t, h, acceleration);
    };
  };
}

const auto begin_verlet = [](auto&... all) { return integrate::velocity_verlet_start(all...); };
const auto verlet = [](auto&... all) { integrate::velocity_verlet(all...); };
const auto begin_yoshida = [](auto&... all) { return integrate::yoshida4_start(all...); };
const auto yoshida = [](auto&... all) { integrate::yoshida4(all...); };

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

const Method euler = method("Euler's method", measure::euler);
const Method symplectic_euler = method("symplectic Euler", measure::symplectic_euler);
const Method symplectic_euler_position_first =
    method("symplectic Euler, position first", measure::symplectic_euler_position_first);
const Method midpoint = method("the midpoint method", measure::midpoint);
const Method heun = method("Heun's method", measure::heun);
const Method rk4 = method("RK4", measure::rk4);
const Method constant_acceleration =
    method("the step of constant acceleration", measure::constant_acceleration);
const Method velocity_verlet{"velocity Verlet", carrying(begin_verlet, verlet)};
const Method yoshida4{"Yoshida's method", carrying(begin_yoshida, yoshida)};
const Method position_verlet{"position Verlet", begin_position_verlet};

const std::vector<Method>& methods() {
  static const std::vector<Method> all{
      euler, symplectic_euler, symplectic_euler_position_first, midpoint,        heun,
      rk4,   velocity_verlet,  constant_acceleration,           position_verlet, yoshida4};
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
