// SPDX-License-Identifier: MIT-0
// What follows a target, and what the air brakes.
#include "fuzz.h"
#include "shelf/aim.h"
#include "shelf/quadratic_drag.h"
#include "shelf/smooth_damp.h"

namespace fuzz {

Cases followers() {
  Cases cases;
  add_numbers(cases, "smooth_damp", "the share", []<class Real>(Source& source) {
    const Real rate = source.size<Real>(), h = source.size<Real>();
    const Real share = shelf::smoothing_share(rate, h);
    if (rate >= Real(0) && h >= Real(0) && finite(rate) && finite(h)) {
      require(share >= Real(0) && share <= Real(1), "between 0 and 1");
    }
  });
  add(cases, "smooth_damp", "all three", []<class Vec, class Real>(Source& source) {
    Vec x = source.vector<Vec>(), v = source.vector<Vec>();
    const Vec target = source.vector<Vec>(), moves = source.vector<Vec>();
    shelf::smooth(x, target, moves, source.size<Real>(), source.size<Real>());
    shelf::smooth_damp(x, v, target, moves, source.size<Real>(), source.size<Real>());
    shelf::smooth_damp_no_overshoot(x, v, target, moves, source.size<Real>(), source.size<Real>(),
                                    product);
    if (source.tame()) require(finite(x) && finite(v), "a follower stays somewhere");
  });
  add(cases, "smooth_damp", "limits", []<class Vec, class Real>(Source& source) {
    Vec x = source.vector<Vec>(), v = source.vector<Vec>();
    const Vec target = source.vector<Vec>(), moves = source.vector<Vec>();
    for (int n = 0; n < 4; ++n) {
      const Real top = source.size<Real>(), most = source.size<Real>();
      shelf::smooth_damp_limited(x, v, target, moves, source.size<Real>(), top, most,
                                 source.size<Real>(), product);
      if (source.tame()) require(finite(x) && finite(v), "a follower stays somewhere");
    }
  });
  add_numbers(cases, "smooth_damp", "no overshoot", []<class Real>(Source& source) {
    Real x = source.number<Real>(), v = source.number<Real>();
    const Real target = source.number<Real>(), omega = source.size<Real>();
    Real allowed = 0;
    const Real side = x < target ? Real(-1) : Real(1);
    // So fast as it is promised for.
    if (std::abs(v) > Real(100) * omega * std::abs(x - target)) v = Real(0);
    for (int n = 0; n < 10; ++n) {
      allowed += 8 * std::numeric_limits<Real>::epsilon() * (std::abs(x) + std::abs(target));
      shelf::smooth_damp_no_overshoot(x, v, target, Real(0), omega, source.size<Real>(), product);
      if (source.tame()) require(side * (x - target) >= -allowed, "never passes its target");
    }
  });
  add(cases, "aim", "at anything", []<class Vec, class Real>(Source& source) {
    const Vec from = source.vector<Vec>(), place = source.vector<Vec>(), a = source.vector<Vec>();
    const Real h = source.size<Real>(), speed = source.size<Real>(), within = source.size<Real>();
    const shelf::Gun<Real> gun{speed, h, Real(20) * h, within};
    const auto step = [&](Vec& x, Vec& v) { v = v + h * a, x = x + h * v; };
    const auto target = [&](Real) { return place; };
    const auto shot = shelf::aim(from, target, step, product, gun, source.size<Real>());
    const auto height = [&](const Vec& x) { return product(x, place); };
    const auto fall = shelf::landing(from, place, h, Real(20) * h, step, height);
    if (!source.tame()) return;
    require(finite(shot.velocity) && finite(shot.time), "a throw is a number");
    require(finite(fall.place) && finite(fall.time), "a landing is a number");
    if (shot.found) require(shot.time > Real(0) && shot.time <= gun.longest, "within the time");
  });
  add(cases, "quadratic_drag", "any way", []<class Vec, class Real>(Source& source) {
    Vec x = source.vector<Vec>(), v = source.vector<Vec>();
    const Vec a = source.vector<Vec>(), wind = source.vector<Vec>();
    for (int n = 0; n < 4; ++n) {
      shelf::quadratic_drag(x, v, a, wind, source.size<Real>(), source.size<Real>(), length);
      if (source.tame()) require(finite(x) && finite(v), "both stay numbers");
    }
  });
  add_numbers(cases, "quadratic_drag", "along a line", []<class Real>(Source& source) {
    Real x = source.number<Real>(), v = source.number<Real>();
    const Real a = source.number<Real>();
    for (int n = 0; n < 4; ++n) {
      const bool goes_along = (v < Real(0)) == (a < Real(0));
      const Real before = x, h = source.size<Real>();
      shelf::quadratic_drag_fall(x, v, a, source.size<Real>(), h);
      if (!source.tame()) continue;
      require(finite(x) && finite(v), "both stay numbers");
      if (goes_along && a < Real(0)) require(x <= before, "what falls goes on to fall");
    }
  });
  return cases;
}

}  // namespace fuzz
