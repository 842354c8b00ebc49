// SPDX-License-Identifier: MIT-0
// What bounces, and the clock that a game is stepped by.
#include "fuzz.h"
#include "shelf/blend.h"
#include "shelf/bounce.h"
#include "shelf/event.h"
#include "shelf/fixed_step.h"
#include "shelf/jump.h"

namespace fuzz {
namespace {

template <class... Numbers>
bool any_is_not_a_number(Numbers... numbers) {
  return (... || (numbers != numbers));
}

template <class Real>
void check(shelf::Impact<Real> impact, Real h, bool senseless) {
  if (senseless) require(!impact.hit, "none if an argument is not a number");
  if (impact.hit)
    require(impact.time >= Real(0) && impact.time <= h, "the first moment within the step");
}

void add_impacts(Cases& cases) {
  add_numbers(cases, "bounce", "a plane is met", []<class Real>(Source& source) {
    const Real height = source.number<Real>(), speed = source.number<Real>(),
               a = source.number<Real>(), h = source.size<Real>();
    check(shelf::impact_plane(height, speed, a, h), h, any_is_not_a_number(height, speed, a, h));
  });
  add(cases, "bounce", "a sphere is met", []<class Vec, class Real>(Source& source) {
    const Vec x = source.vector<Vec>(), v = source.vector<Vec>(), a = source.vector<Vec>();
    const Real radius = source.size<Real>(), h = source.size<Real>();
    const bool straight = any_is_not_a_number(dot(x, x), dot(v, v), radius, h);
    check(shelf::impact_sphere(x, v, radius, h, product), h, straight);
    check(shelf::impact_sphere(x, v, a, radius, h, product), h,
          straight || any_is_not_a_number(dot(a, a)));
  });
}

void add_steps(Cases& cases) {
  add(cases, "bounce", "bounces and slides", []<class Vec, class Real>(Source& source) {
    Vec v = source.vector<Vec>();
    const Vec normal = source.direction<Vec>();
    const Real push = shelf::bounce(v, normal, source.size<Real>(), source.number<Real>(), product);
    require(!(push < Real(0)) || !source.tame(), "the push of the plane, 0 if it goes away anyway");
    const Real before = length(v);
    shelf::friction(v, normal, source.size<Real>(), product);
    if (source.tame()) require(length(v) <= before * Real(1.0001), "it brakes");
  });
  add(cases, "bounce", "steps above a plane", []<class Vec, class Real>(Source& source) {
    Vec x = source.vector<Vec>(), v = source.vector<Vec>();
    const Vec a = source.vector<Vec>();
    const Real back = source.tame() ? Real(source.share()) : source.size<Real>();
    const shelf::Plane<Vec, Real> plane{source.direction<Vec>(), source.number<Real>(), back,
                                        source.size<Real>(), source.size<Real>()};
    for (int n = 0; n < 4; ++n) {
      const Real h = source.size<Real>();
      const Real way = length(x) + h * (length(v) + h * length(a)) + std::abs(plane.level);
      const int bounces = shelf::bounce_step(x, v, a, h, plane, product);
      require(bounces >= 0 && bounces <= 64, "64 times at most");
      if (!source.tame()) continue;
      const Real height = dot(x, plane.normal) - plane.level;
      require(height >= -256 * std::numeric_limits<Real>::epsilon() * (Real(1) + way),
              "nothing gets through");
    }
  });
}

void add_moving(Cases& cases) {
  add(cases, "bounce", "steps above a plane that moves", []<class Vec, class Real>(Source& source) {
    Vec x = source.vector<Vec>(), v = source.vector<Vec>();
    const Vec a = source.vector<Vec>();
    const auto moving = [&] {
      const Real back = source.tame() ? Real(source.share()) : source.size<Real>();
      return shelf::MovingPlane<Vec, Real>{{source.direction<Vec>(), source.number<Real>(), back,
                                            source.size<Real>(), source.size<Real>()},
                                           source.vector<Vec>(),
                                           source.vector<Vec>()};
    };
    shelf::MovingPlane<Vec, Real> before = moving();
    for (int n = 0; n < 4; ++n) {
      const shelf::MovingPlane<Vec, Real> now = moving();
      const int bounces = shelf::bounce_step(x, v, a, source.size<Real>(), before, now, product);
      require(bounces >= 0 && bounces <= 64, "64 times at most");
      if (source.tame()) require(finite(x) && finite(v), "it is somewhere");
      before = now;
    }
  });
}

}  // namespace

Cases bounces() {
  Cases cases;
  add_impacts(cases);
  add_steps(cases);
  add_moving(cases);
  add_numbers(cases, "fixed_step", "frames of any length", []<class Real>(Source& source) {
    shelf::FixedStep<Real> clock{Real(0.001 + source.share())};
    clock.longest_frame = source.share();
    for (int n = 0; n < 8; ++n) {
      const long long before = clock.steps;
      const double time = clock.time(), frame = source.number<double>();
      const Real sizes[] = {Real(0.001 + source.share()), Real(-source.share()), Real(NAN)};
      clock.change_step(sizes[n % 3]);
      require(std::abs(clock.time() - time) <= 1e-12 * time, "no time is lost");
      clock.frame(frame, [](double t) { require(t > -1e-9, "the time at the start of a step"); });
      require(clock.saved >= 0 && (!(frame > 0) || clock.saved < double(clock.h)),
              "time not yet spent, under one step until h changes");
      require(clock.blend() >= Real(0) && clock.blend() <= Real(1),
              "0 at the older one, 1 at the newer");
      if (!(frame > 0))
        require(clock.steps == before, "a frame that is negative or not a number takes no step");
    }
  });
  add(cases, "blend", "between two places", []<class Vec, class Real>(Source& source) {
    const Vec before = source.vector<Vec>(), now = source.vector<Vec>(), v = source.vector<Vec>();
    const Real share = Real(source.share()), h = source.size<Real>();
    const Vec straight = shelf::blend(before, now, share);
    const Vec curved = shelf::blend_curved(before, v, now, source.vector<Vec>(), h, share);
    const Vec turned = shelf::blend_turned(before, now, share, product);
    if (source.tame()) require(finite(straight) && finite(curved), "somewhere between");
    if (!source.tame() || !finite(turned)) return;  // as where both have no length
    require(std::abs(length(turned) - Real(1)) < Real(1e-3), "of length one");
  });
  add_numbers(cases, "event", "within a step", []<class Real>(Source& source) {
    const Real start = source.number<Real>(), h = source.size<Real>(), a = source.number<Real>(),
               b = source.number<Real>();
    int asked = 0;
    const auto step = [&](Real& x, Real part) { ++asked, x = x + part * (a + part * b); };
    const auto found = shelf::first_crossing(start, h, step, [](Real x) { return x; }, 3);
    require(asked <= 400, "comes back soon");
    if (!found.found) return;
    Real there = start;
    step(there, found.time);
    require(!(there > Real(0)), "not above zero there");
    require(found.time >= Real(0) && found.time <= h, "within the step");
  });
  add_numbers(cases, "jump", "a jump in steps of any length", []<class Real>(Source& source) {
    const Real rising = source.size<Real>(), falling = source.size<Real>();
    Real x = source.number<Real>(), v = source.number<Real>();
    const Real top = v > Real(0) ? x + v / rising * v / Real(2) : x;
    const Real allowed = 64 * std::numeric_limits<Real>::epsilon() * (std::abs(x) + std::abs(top));
    for (int n = 0; n < 8; ++n) {
      shelf::jump_step(x, v, rising, falling, source.size<Real>());
      if (source.tame() && std::isfinite(top))
        require(x <= top + allowed, "no higher than its top");
      if (source.tame()) require(finite(x) && finite(v), "a jump is somewhere");
    }
  });
  return cases;
}

}  // namespace fuzz
