// SPDX-License-Identifier: MIT-0
// Which methods have a card, and which lines make sense on it.
#include <stdexcept>
#include <utility>

#include "measure/card_lines.h"
#include "measure/implicit_methods.h"
#include "measure/linear_methods.h"
#include "measure/methods.h"
#include "measure/methods_with_memory.h"

namespace measure {
namespace {

using namespace card_lines;

constexpr scenes::LinearDrag<> braking{.c = 1, .g = 0};

template <class Step>
void limits_and_energy(Card& card, const Step& step) {
  fall(card, step);
  drag_limit(card, step, braking);
  spring_limits(card, step);
  energy(card, step);
  timed(card, step, scenes::Orbit<>(), "an orbit");
}

template <class Step, class Scene = Passing>
Card any(const std::string& method, const Step& step, const Scene& scene = {},
         const std::string& where = "on an orbit", double h = 1.0 / 32) {
  Card card{method, "any acceleration", {}, {}, {}};
  orders(card, step, scene, "order", where, h);
  orders(card, step, damped, "drag-order", "on a damped spring");
  evaluations(card, step, scenes::Pendulum<>());
  limits_and_energy(card, step);
  return card;
}

// On an orbit, errors of higher order hide those of the fifth until rounding hides both.
Card fifth_order() {
  return any("dopri5", dopri5, undamped, "on an undamped spring", 1.0 / 8);
}

template <class Step>
Card implicit(const std::string& method, const Step& step) {
  Card card{method, "any acceleration, given its Jacobian", {}, {}, {}};
  // With longer steps implicit Euler brakes the planet, and it falls into its sun.
  orders(card, step, Passing(), "order", "on an orbit", 1.0 / 64);
  orders(card, step, damped, "drag-order", "on a damped spring");
  solves(card, step);
  limits_and_energy(card, step);
  return card;
}

Card predicted() {
  Card card = any("predicted_euler", predicted_euler<1>);
  const auto add = [&card](const std::string& corrections, const auto& step) {
    card.rows.push_back({"corrections-" + corrections + "-drag",
                         "With " + corrections + " corrections, stable up to", "drag, ch",
                         limit(step, braking)});
    card.rows.push_back({"corrections-" + corrections + "-spring",
                         "With " + corrections + " corrections, stable up to",
                         "undamped spring, hω", limit(step, scenes::Spring<>())});
  };
  add("2", predicted_euler<2>);
  add("3", predicted_euler<3>);
  return card;
}

// Drag is a spring that pulls so little that its damper is all there is.
constexpr scenes::Spring<> slack{.omega = 0.5e-6, .zeta = 1e6};

template <class Step>
Card on_springs(const std::string& method, const Step& step) {
  Card card{method, "one damped spring alone", {}, {}, {}};
  orders(card, step, undamped, "order", "undamped");
  orders(card, step, damped, "drag-order", "damped");
  evaluations(card, step, damped);
  drag_limit(card, step, slack);
  spring_limits(card, step);
  energy(card, step);
  timed(card, step, damped, "a damped spring");
  return card;
}

template <class Step>
Card damping(const std::string& method, const Step& step) {
  Card card{method, "any acceleration, with the engines’ linear damping", {}, {}, {}};
  orders(card, step, undamped, "order", "without damping");
  orders(card, step, damped, "drag-order", "on a damped spring");
  evaluations(card, step, damped);
  fall(card, step);
  const scenes::LinearDrag<> leaf{.c = 2};
  const double speed = -after(step, leaf, leaf.start(), 0.05, 1000).v;
  card.rows.push_back({"terminal-speed", "Falling against drag, ch = 0.1",
                       "terminal speed over g/c", speed / leaf.terminal_speed(), 4});
  drag_limit(card, step, braking);
  spring_limits(card, step);
  energy(card, step);
  timed(card, step, damped, "a damped spring");
  return card;
}

Card adaptive() {
  Card card{"dopri5_adaptive", "any acceleration", {}, {}, {}};
  const scenes::Orbit<> orbit;
  const auto norm = [](const Eigen::Vector2d& y) { return y.norm(); };
  for (const auto& [name, tolerance] :
       {std::pair{"10⁻³", 1e-3}, std::pair{"10⁻⁶", 1e-6}, std::pair{"10⁻⁹", 1e-9}}) {
    const Counted<scenes::Orbit<>> counted{orbit};
    auto [x, v] = orbit.start();
    double h = 0.1;
    if (!integrate::dopri5_adaptive(x, v, 0.0, 5.0, h, counted, norm, tolerance)) {
      throw std::runtime_error("dopri5_adaptive did not arrive");
    }
    const std::string about = std::string("Most of an orbit, tolerance ") + name;
    card.rows.push_back({"adaptive-evaluations", about, "evaluations of the acceleration",
                         double(counted.evaluations), whole});
    card.rows.push_back(
        {"adaptive-error", about, "error at the end", (x - orbit.exact(5).x).norm(), 2, "m"});
  }
  return card;
}

}  // namespace

const Cell& Card::at(const std::string& name) const {
  for (const CardRow& row : rows) {
    if (row.name == name) return row.measured;
  }
  throw std::out_of_range("the card of " + method + " has no line \"" + name + "\"");
}

std::vector<Card> every_card() {
  return {
      any("euler", euler),
      any("constant_acceleration", constant_acceleration),
      any("symplectic_euler", symplectic_euler),
      any("symplectic_euler_position_first", symplectic_euler_position_first),
      any("midpoint", midpoint),
      any("heun", heun),
      any("rk4", rk4),
      any("stormer_verlet", stormer_verlet),
      any("stormer_verlet_carried", stormer_verlet_carried),
      any("stormer_verlet_uneven", stormer_verlet_uneven),
      any("leapfrog", leapfrog),
      any("velocity_verlet", velocity_verlet),
      any("yoshida4", yoshida4),
      predicted(),
      fifth_order(),
      adaptive(),
      implicit("backward_euler", backward_euler),
      implicit("backward_euler_newton", backward_euler_newton),
      implicit("trapezoid", trapezoid),
      implicit("trapezoid_newton", trapezoid_newton),
      on_springs("spring_exact", spring_exact),
      on_springs("backward_euler_spring", backward_euler_spring),
      on_springs("rk4_linear", rk4_linear),
      damping("linear_damping_explicit_last", linear_damping_explicit_last),
      damping("linear_damping_explicit_first", linear_damping_explicit_first),
      damping("linear_damping_implicit_last", linear_damping_implicit_last),
      damping("linear_damping_implicit_first", linear_damping_implicit_first),
      damping("linear_damping_exponential_last", linear_damping_exponential_last),
      damping("linear_damping_exponential_first", linear_damping_exponential_first),
      damping("linear_damping_exact", linear_damping_exact),
  };
}

}  // namespace measure
