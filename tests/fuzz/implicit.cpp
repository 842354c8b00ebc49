// SPDX-License-Identifier: MIT-0
// The implicit methods, with solvers that fail now and then: what fails moves nothing.
#include "fuzz.h"
#include "integrate/backward_euler.h"
#include "integrate/bdf2.h"
#include "integrate/trapezoid.h"

namespace fuzz {
namespace {

// A method called as `step(x, v, previous, t, h, h_previous, force, solve, norm, tolerance)` that
// says how many iterations it took, at most 50, and none if it moved nothing.
template <class Step>
void add_solved(Cases& cases, const char* header, const char* name, Step step) {
  add(cases, header, name, [step]<class Vec, class Real>(Source& source) {
    Force<Vec, Real> force(source);
    Vec x = source.vector<Vec>(), v = source.vector<Vec>();
    integrate::Bdf2Previous<Vec> previous{source.vector<Vec>(), source.vector<Vec>()};
    const auto solve = [&](const Vec&, const Vec&, double, Real p, Real q, Vec& change) {
      change = (Real(1) / (Real(1) - p * force.k - q * force.c)) * change;
      return source.whole(0, 9) > 0;
    };
    const Real h = source.size<Real>(), h_previous = source.size<Real>(),
               tolerance = source.size<Real>();
    const Vec x_start = x, v_start = v;
    const auto previous_start = previous;
    const int iterations = step(x, v, previous, source.number<double>(), h, h_previous, force,
                                solve, length, tolerance);
    require(iterations >= 0 && iterations <= 50, "at most 50 iterations");
    if (iterations > 0) return;
    require(same(x, x_start) && same(v, v_start) && same(previous, previous_start),
            "x, v and previous are then as they were");
  });
}

}  // namespace

Cases implicit_methods() {
  Cases cases;
  add_solved(cases, "backward_euler", "one solve",
             [](auto& x, auto& v, auto&, auto t, auto h, auto, auto& force, auto& solve, auto&,
                auto) { return int(integrate::backward_euler(x, v, t, h, force, solve)); });
  add_solved(cases, "backward_euler", "Newton's method",
             [](auto& x, auto& v, auto&, auto t, auto h, auto, auto& force, auto& solve, auto& norm,
                auto tolerance) {
               return integrate::backward_euler_newton(x, v, t, h, force, solve, norm, tolerance);
             });
  add_solved(cases, "trapezoid", "one solve",
             [](auto& x, auto& v, auto&, auto t, auto h, auto, auto& force, auto& solve, auto&,
                auto) { return int(integrate::trapezoid(x, v, t, h, force, solve)); });
  add_solved(cases, "trapezoid", "Newton's method",
             [](auto& x, auto& v, auto&, auto t, auto h, auto, auto& force, auto& solve, auto& norm,
                auto tolerance) {
               return integrate::trapezoid_newton(x, v, t, h, force, solve, norm, tolerance);
             });
  add_solved(cases, "bdf2", "one solve",
             [](auto& x, auto& v, auto& previous, auto t, auto h, auto h_previous, auto& force,
                auto& solve, auto&, auto) {
               return int(integrate::bdf2(x, v, previous, t, h, h_previous, force, solve));
             });
  add_solved(cases, "bdf2", "Newton's method",
             [](auto& x, auto& v, auto& previous, auto t, auto h, auto h_previous, auto& force,
                auto& solve, auto& norm, auto tolerance) {
               return integrate::bdf2_newton(x, v, previous, t, h, h_previous, force, solve, norm,
                                             tolerance);
             });
  add(cases, "bdf2", "its start", []<class Vec, class Real>(Source& source) {
    Force<Vec, Real> force(source);
    (void)integrate::bdf2_start(source.vector<Vec>(), source.vector<Vec>(), source.number<double>(),
                                source.number<Real>(), force);
  });
  return cases;
}

}  // namespace fuzz
