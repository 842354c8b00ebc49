// SPDX-License-Identifier: MIT-0
// Dormand and Prince, to a tolerance: no more steps than allowed, and nothing moved by what fails.
#include "fuzz.h"
#include "integrate/dopri5.h"

namespace fuzz {

Cases adaptive() {
  Cases cases;
  add(cases, "dopri5", "one step, and one along a path", []<class Vec, class Real>(Source& source) {
    Force<Vec, Real> force(source);
    Vec x = source.vector<Vec>(), v = source.vector<Vec>();
    const double t = source.number<double>();
    Vec a = integrate::dopri5_start(x, v, t, force);
    (void)integrate::dopri5(x, v, a, t, source.number<Real>(), force);
    auto path = integrate::dopri5_path(x, v, t, source.above<Real>(), force);
    (void)integrate::dopri5(path, source.number<Real>(), force);
    const double at = source.number<double>();
    if (path.holds(at)) (void)path.position(at), (void)path.velocity(at);
  });
  add(cases, "dopri5", "to a tolerance", []<class Vec, class Real>(Source& source) {
    Force<Vec, Real> force(source);
    Vec x = source.vector<Vec>(), v = source.vector<Vec>();
    const Vec x_start = x, v_start = v;
    Real h = source.above<Real>();
    const Real duration = source.number<Real>(), tolerance = source.size<Real>();
    const int most = source.whole(0, 60);
    const bool arrived = integrate::dopri5_adaptive(x, v, source.number<double>(), duration, h,
                                                    force, length, tolerance, most);
    require(force.asked <= 1 + 6 * most, "at most so many steps, each of six evaluations");
    if (!arrived) require(same(x, x_start) && same(v, v_start), "x and v are as at the start");
    if (arrived) require(finite(duration), "not finite: the duration");
    if (arrived && source.tame()) require(h > Real(0) && finite(h), "the size to try next");
  });
  add(cases, "dopri5", "along a path", []<class Vec, class Real>(Source& source) {
    Force<Vec, Real> force(source);
    auto path = integrate::dopri5_path(source.vector<Vec>(), source.vector<Vec>(),
                                       source.number<double>(), source.above<Real>(), force);
    for (int frame = 0; frame < 3; ++frame) {
      const double t = source.number<double>();
      const int most = source.whole(0, 40);
      force.asked = 0;
      const bool arrived =
          integrate::dopri5_adaptive(path, t, force, length, source.size<Real>(), most);
      require(force.asked <= 6 * most, "at most so many steps, each of six evaluations");
      require(!arrived || path.holds(t), "whether the path holds t");
    }
  });
  return cases;
}

}  // namespace fuzz
