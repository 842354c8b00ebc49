// SPDX-License-Identifier: MIT-0
// The explicit methods: they come back from anything.
#include "measure/methods.h"

#include "fuzz.h"
#include "integrate/leapfrog.h"
#include "integrate/linear_damping.h"
#include "integrate/predicted_euler.h"
#include "integrate/stormer_verlet.h"
#include "integrate/velocity_verlet.h"
#include "integrate/yoshida4.h"
#include "shelf/first_order.h"

namespace fuzz {
namespace {

// A few steps of any size under any force, with a clock of doubles: `step(x, v, t, h, force,
// source)`.
template <class Step>
void add_steps(Cases& cases, const std::string& header, const std::string& name, Step step) {
  add(cases, header, name, [step]<class Vec, class Real>(Source& source) {
    Force<Vec, Real> force(source);
    Vec x = source.vector<Vec>(), v = source.vector<Vec>();
    const double t = source.number<double>();
    for (int n = 0; n < 3; ++n) step(x, v, t, source.number<Real>(), force, source);
  });
}

// All of the book's that keep nothing from step to step.
void add_plain(Cases& cases) {
  list::for_each(list::EveryExplicit(), [&]<class Method>(Method) {
    if constexpr (std::is_invocable_v<Method, double&, double&, double, double,
                                      Force<double, double>&>) {
      const auto header = Method::header.substr(0, Method::header.find('.'));
      add_steps(cases, std::string(header), std::string(Method::function),
                [](auto& x, auto& v, auto t, auto h, auto& force, Source&) {
                  Method()(x, v, t, h, force);
                });
    }
  });
}

// The same of a way to damp.
template <class Step>
void add_damped(Cases& cases, const char* name, Step step) {
  add_steps(cases, "linear_damping", name,
            [step](auto& x, auto& v, auto t, auto h, auto& force, Source& source) {
              const auto c = source.size<decltype(h)>();
              step(x, v, t, h, c, force);
            });
}

void add_verlets(Cases& cases) {
  add_steps(cases, "stormer_verlet", "stormer_verlet",
            [](auto& x, auto& v, auto t, auto h, auto& force, Source&) {
              integrate::stormer_verlet(x, v, t, h, force);
              v = integrate::stormer_verlet_start(x, v, t, h, force);
              v = integrate::stormer_verlet_velocity(x, v, h);
            });
  add_steps(cases, "stormer_verlet", "stormer_verlet_carried",
            [](auto& x, auto& v, auto t, auto h, auto& force, Source&) {
              auto a = force(x, v, t);
              integrate::stormer_verlet_carried(x, v, a, t, h, force);
              v = integrate::stormer_verlet_carried_velocity(x, v, a, h);
            });
  add_steps(cases, "stormer_verlet", "stormer_verlet_distance",
            [](auto& x, auto& v, auto t, auto h, auto& force, Source&) {
              v = integrate::stormer_verlet_distance_start(x, v, t, h, force);
              integrate::stormer_verlet_distance(x, v, t, h, force);
            });
  add_steps(cases, "stormer_verlet", "stormer_verlet_uneven",
            [](auto& x, auto& v, auto t, auto h, auto& force, Source& source) {
              integrate::stormer_verlet_uneven(x, v, t, h, source.number<decltype(h)>(), force);
            });
}

void add_leapfrogs(Cases& cases) {
  add_steps(cases, "leapfrog", "leapfrog",
            [](auto& x, auto& v, auto t, auto h, auto& force, Source&) {
              v = integrate::leapfrog_start(x, v, t, h, force);
              integrate::leapfrog(x, v, t, h, force);
              v = integrate::leapfrog_velocity(x, v, t, h, force);
            });
  add_steps(cases, "velocity_verlet", "velocity_verlet",
            [](auto& x, auto& v, auto t, auto h, auto& force, Source&) {
              auto a = integrate::velocity_verlet_start(x, v, t, force);
              integrate::velocity_verlet(x, v, a, t, h, force);
            });
  add_steps(cases, "yoshida4", "yoshida4",
            [](auto& x, auto& v, auto t, auto h, auto& force, Source&) {
              auto a = integrate::yoshida4_start(x, v, t, force);
              integrate::yoshida4(x, v, a, t, h, force);
            });
}

void add_dampings(Cases& cases) {
  add_damped(cases, "explicit_last",
             [](auto&... all) { integrate::linear_damping_explicit_last(all...); });
  add_damped(cases, "explicit_first",
             [](auto&... all) { integrate::linear_damping_explicit_first(all...); });
  add_damped(cases, "implicit_last",
             [](auto&... all) { integrate::linear_damping_implicit_last(all...); });
  add_damped(cases, "implicit_first",
             [](auto&... all) { integrate::linear_damping_implicit_first(all...); });
  add_damped(cases, "exponential_last",
             [](auto&... all) { integrate::linear_damping_exponential_last(all...); });
  add_damped(cases, "exponential_first",
             [](auto&... all) { integrate::linear_damping_exponential_first(all...); });
  add_damped(cases, "exact", [](auto&... all) { integrate::linear_damping_exact(all...); });
}

}  // namespace

Cases methods() {
  Cases cases;
  add_verlets(cases);
  add_leapfrogs(cases);
  add_dampings(cases);
  add_plain(cases);
  add_steps(cases, "predicted_euler", "any number of corrections",
            [](auto& x, auto& v, auto t, auto h, auto& force, Source& source) {
              integrate::predicted_euler(x, v, t, h, force, source.whole(-2, 9));
            });
  add_steps(cases, "first_order", "all three",
            [](auto& x, auto& v, auto t, auto h, auto& force, Source&) {
              const auto flow = [&](const auto& place, auto at) { return force(place, v, at); };
              shelf::first_order_euler(x, t, h, flow);
              shelf::first_order_midpoint(x, t, h, flow);
              shelf::first_order_rk4(x, t, h, flow);
            });
  return cases;
}

}  // namespace fuzz
