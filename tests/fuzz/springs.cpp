// SPDX-License-Identifier: MIT-0
// Springs and dampers in closed form.
#include "fuzz.h"
#include "integrate/backward_euler_spring.h"
#include "integrate/rk4_linear.h"
#include "integrate/spring_exact.h"
#include "shelf/damper.h"
#include "shelf/soft_constraint.h"

namespace fuzz {
namespace {

template <class Real>
constexpr Real rounding = std::numeric_limits<Real>::epsilon();

void add_steps(Cases& cases) {
  add(cases, "spring_exact", "any spring", []<class Vec, class Real>(Source& source) {
    Vec x = source.vector<Vec>(), v = source.vector<Vec>();
    const Real h = source.number<Real>(), omega = source.size<Real>(), zeta = source.size<Real>();
    integrate::spring_exact(x, v, h, omega, zeta);
    if (source.tame() && h >= Real(0)) require(finite(x) && finite(v), "exact for any h");
  });
  add(cases, "backward_euler_spring", "any spring", []<class Vec, class Real>(Source& source) {
    Vec x = source.vector<Vec>(), v = source.vector<Vec>();
    const Real h = source.number<Real>(), omega = source.size<Real>(), zeta = source.size<Real>();
    const Real before = length(x);
    integrate::backward_euler_spring(x, v, h, omega, zeta);
    if (source.tame() && h >= Real(0))
      require(finite(x) && finite(v) && finite(before), "stable for every h");
  });
  add(cases, "rk4_linear", "any force", []<class Vec, class Real>(Source& source) {
    Vec x = source.vector<Vec>(), v = source.vector<Vec>();
    const auto step = integrate::rk4_linear_start(source.number<Real>(), source.number<Real>(),
                                                  source.number<Real>());
    integrate::rk4_linear(x, v, step);
  });
}

void add_dampers(Cases& cases) {
  const auto check = [](Source& source, auto w1, auto w2, const auto& v1, const auto& v2,
                        const auto& start1, const auto& start2) {
    if (!source.tame()) return;
    if (w1 == 0)
      require(same(v1, start1), "a body of inverse mass 0 keeps its velocity to the bit");
    if (w2 == 0)
      require(same(v2, start2), "a body of inverse mass 0 keeps its velocity to the bit");
  };
  add(cases, "damper", "damper", [check]<class Vec, class Real>(Source& source) {
    Vec v1 = source.vector<Vec>(), v2 = source.vector<Vec>();
    const Vec start1 = v1, start2 = v2;
    const Real w1 = source.size<Real>(), w2 = source.size<Real>();
    shelf::damper(v1, v2, source.size<Real>(), source.size<Real>(), w1, w2);
    check(source, w1, w2, v1, v2, start1, start2);
    const Vec parting = start2 + Real(-1) * start1, left = v2 + Real(-1) * v1;
    const Real speeds = length(start1) + length(start2);
    if (source.tame()) {
      require(dot(left, parting) >= -8 * rounding<Real> * speeds * speeds,
              "the two never part the other way");
    }
  });
  add(cases, "damper", "along a line", [check]<class Vec, class Real>(Source& source) {
    Vec v1 = source.vector<Vec>(), v2 = source.vector<Vec>();
    const Vec start1 = v1, start2 = v2, along = source.direction<Vec>();
    const Real w1 = source.size<Real>(), w2 = source.size<Real>();
    shelf::damper_along(v1, v2, source.size<Real>(), source.size<Real>(), w1, w2, along, product);
    check(source, w1, w2, v1, v2, start1, start2);
  });
}

void add_soft(Cases& cases) {
  add_numbers(cases, "soft_constraint", "its numbers", []<class Real>(Source& source) {
    const Real h = source.above<Real>(), omega = source.size<Real>(), zeta = source.size<Real>();
    const auto soft = shelf::softness(h, omega, zeta);
    const bool meant = h > Real(0) && omega >= Real(0) && zeta >= Real(0) && finite(Real(1) / h) &&
                       finite(h * omega * (h * omega + 2 * zeta));
    if (meant) {
      require(finite(soft.bias_rate), "speed asked for by each metre of stretch");
      require(soft.mass_scale >= Real(0) && soft.mass_scale <= Real(1), "mass scale, 0 to 1");
      require(soft.impulse_scale >= Real(0) && soft.impulse_scale <= Real(1),
              "impulse scale, 1 less the mass scale");
    }
    const auto real = shelf::soft_motion(h, omega, zeta);
    if (source.tame() && omega > Real(0))
      require(real.omega > Real(0) && real.zeta > Real(0) && real.swing >= Real(0),
              "the spring that it really is");
  });
  add(cases, "soft_constraint", "solved", []<class Vec, class Real>(Source& source) {
    Vec v1 = source.vector<Vec>(), v2 = source.vector<Vec>();
    const Vec start1 = v1, start2 = v2, along = source.direction<Vec>();
    const Real w1 = source.size<Real>(), w2 = source.size<Real>();
    const auto soft =
        shelf::softness(source.above<Real>(), source.size<Real>(), source.size<Real>());
    Real impulse = source.number<Real>();
    shelf::soft_warm_start(v1, v2, impulse, along, w1, w2);
    shelf::soft_constraint(v1, v2, impulse, along, source.number<Real>(), w1, w2, soft, product);
    if (!source.tame()) return;
    if (w1 == 0 && w2 == 0)
      require(same(v1, start1) && same(v2, start2), "with both bodies immovable it does nothing");
    require(finite(v1) && finite(v2) && finite(impulse), "stable at any step");
  });
}

}  // namespace

Cases springs() {
  Cases cases;
  add_steps(cases);
  add_dampers(cases);
  add_soft(cases);
  return cases;
}

}  // namespace fuzz
