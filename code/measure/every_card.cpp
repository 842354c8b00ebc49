// SPDX-License-Identifier: MIT-0
// Which methods have a card, and which lines make sense on it.
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "integrate/dopri5.h"
#include "measure/card_lines.h"
#include "measure/compiled.h"
#include "measure/method_of.h"

namespace measure {
namespace {

using namespace card_lines;

constexpr scenes::LinearDrag<> braking{.c = 1, .g = 0};

void limits_and_energy(Card& card, const Method& method) {
  fall(card, method);
  drag_limit(card, method, braking);
  spring_limits(card, method);
  energy(card, method);
  card.timed_on = "an orbit";
}

template <class Scene>
Card any(const Method& method, const Scene& scene, const std::string& where, double h) {
  Card card{std::string(method.function), "any acceleration", {}, {}};
  orders(card, method, scene, "order", where, h);
  orders(card, method, damped, "drag-order", "on a damped spring");
  evaluations(card, method, scenes::Pendulum<>());
  limits_and_energy(card, method);
  return card;
}

Card implicit(const Method& method) {
  Card card{std::string(method.function), "any acceleration, given its Jacobian", {}, {}};
  // With longer steps implicit Euler brakes the planet, and it falls into its sun.
  orders(card, method, Passing(), "order", "on an orbit", 1.0 / 64);
  orders(card, method, damped, "drag-order", "on a damped spring");
  solves(card, method);
  limits_and_energy(card, method);
  return card;
}

void more_corrections(Card& card) {
  const auto add = [&card](const std::string& corrections, const Method& method) {
    card.rows.push_back({"corrections-" + corrections + "-drag",
                         "With " + corrections + " corrections, stable up to", "drag, ch",
                         limit(method, braking)});
    card.rows.push_back({"corrections-" + corrections + "-spring",
                         "With " + corrections + " corrections, stable up to",
                         "undamped spring, hω", limit(method, scenes::Spring<>())});
  };
  add("2", method_of(predicted_euler<2>));
  add("3", method_of(predicted_euler<3>));
}

template <class Listed>
Card explicit_one(Listed) {
  const Method& method = compiled<Listed>;
  // On an orbit, errors of higher order hide those of the fifth until rounding hides both.
  Card card = Listed::order < 5 ? any(method, Passing(), "on an orbit", 1.0 / 32)
                                : any(method, undamped, "on an undamped spring", 1.0 / 8);
  if constexpr (std::is_same_v<Listed, PredictedEuler>) more_corrections(card);
  return card;
}

// Drag is a spring that pulls so little that its damper is all there is.
constexpr scenes::Spring<> slack{.omega = 0.5e-6, .zeta = 1e6};

Card on_springs(const Method& method) {
  Card card{std::string(method.function), "one damped spring alone", {}, {}};
  orders(card, method, undamped, "order", "undamped");
  orders(card, method, damped, "drag-order", "damped");
  evaluations(card, method, damped);
  drag_limit(card, method, slack);
  spring_limits(card, method);
  energy(card, method);
  card.timed_on = "a damped spring";
  return card;
}

Card damping(const Method& method) {
  Card card{
      std::string(method.function), "any acceleration, with the engines’ linear damping", {}, {}};
  orders(card, method, undamped, "order", "without damping");
  orders(card, method, damped, "drag-order", "on a damped spring");
  evaluations(card, method, damped);
  fall(card, method);
  const scenes::LinearDrag<> leaf{.c = 2};
  const double speed = -after(method, leaf, leaf.start(), 0.05, 1000).v;
  card.rows.push_back({"terminal-speed", "Falling against drag, ch = 0.1",
                       "terminal speed over g/c", speed / leaf.terminal_speed(), 4});
  drag_limit(card, method, braking);
  spring_limits(card, method);
  energy(card, method);
  card.timed_on = "a damped spring";
  return card;
}

Card adaptive() {
  Card card{"dopri5_adaptive", "any acceleration", {}, {}};
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
  std::vector<Card> all;
  list::for_each(list::EveryExplicit(),
                 [&all](auto method) { all.push_back(explicit_one(method)); });
  all.push_back(adaptive());
  for (const Method* method : all_compiled(list::EveryImplicit())) all.push_back(implicit(*method));
  for (const Method* method : all_compiled(list::EveryOnSprings())) {
    all.push_back(on_springs(*method));
  }
  for (const Method* method : all_compiled(list::EveryDamping())) all.push_back(damping(*method));
  return all;
}

}  // namespace measure
