// SPDX-License-Identifier: MIT-0
// What turns and tumbles.
#include "fuzz.h"
#include "shelf/contact.h"
#include "shelf/wheel.h"

namespace fuzz {
namespace {

template <class Real>
using Vec3 = shelf::Vec3<Real>;
template <class Real>
using Quaternion = shelf::Quaternion<Real>;

template <class Real>
Quaternion<Real> orientation(Source& source) {
  const Quaternion<Real> any{source.number<Real>(), source.number<Real>(), source.number<Real>(),
                             source.number<Real>()};
  const Real square = any.w * any.w + any.x * any.x + any.y * any.y + any.z * any.z;
  if (!source.tame()) return any;
  return square > Real(0) ? normalised(any) : Quaternion<Real>{};
}

template <class Real>
void check(Source& source, const Quaternion<Real>& q) {
  if (!source.tame()) return;
  const Real square = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
  require(std::abs(square - Real(1)) < 16 * std::numeric_limits<Real>::epsilon(),
          "the length of q stays one");
}

// A body of some metres with up to eight corners that may touch something, each something else.
void add_contacts(Cases& cases) {
  add_numbers(cases, "contact", "lands and rests", []<class Real>(Source& source) {
    const auto some = [&] {
      return source.tame() ? source.number<Real>() / 100 : source.number<Real>();
    };
    const auto vector = [&] { return Vec3<Real>{some(), some(), some()}; };
    const auto q = orientation<Real>(source);
    const auto edge = [&] { return source.tame() ? Real(0.1 + 4 * source.share()) : some(); };
    const auto inertia = shelf::inertia_of_box(edge(), {edge(), edge(), edge()});
    Vec3<Real> v = vector(), L = vector();
    shelf::Contact<Vec3<Real>, Real> contacts[8];
    const int count = source.whole(0, 8);
    const shelf::Surface<Real> surface{source.size<Real>(), Real(source.share()),
                                       source.size<Real>()};
    const auto spin = [&](const Vec3<Real>& now) { return angular_velocity(q, now, inertia); };
    const auto across = [](const Vec3<Real>& p, const Vec3<Real>& r) { return cross(p, r); };
    for (int n = 0; n < 4; ++n) {
      for (int i = 0; i < count; ++i) {
        contacts[i].r = vector();
        contacts[i].normal = source.direction<Vec3<Real>>();
        contacts[i].gap = some();
      }
      const Real h = source.size<Real>(), inverse_mass = edge();
      const Vec3<Real> a = vector();
      const auto way = shelf::contact_step(v, L, a, h, contacts, count, surface, inverse_mass, spin,
                                           product, across, 4);
      if (!source.tame()) continue;
      require(finite(v) && finite(L) && finite(way.v) && finite(way.L), "it is somewhere");
      for (int i = 0; i < count; ++i) {
        const auto& corner = contacts[i];
        require(corner.push >= Real(0), "nothing draws a body to a floor");
        require(length(corner.grip) <= surface.friction * corner.push * Real(1.001),
                "friction has its bound");
      }
    }
  });
}

}  // namespace

Cases bodies() {
  Cases cases;
  add_numbers(cases, "wheel", "one wheel", []<class Real>(Source& source) {
    Real force = source.size<Real>();
    for (int n = 0; n < 4; ++n) {
      const Real compression = source.number<Real>(), speed = source.number<Real>();
      const shelf::Suspension<Real> suspension{source.size<Real>(), source.size<Real>()};
      const Real push = shelf::wheel_push(force, compression, speed, source.size<Real>(),
                                          suspension, source.size<Real>());
      if (!source.tame()) continue;
      require(finite(force) && finite(push), "both stay numbers");
      require(force >= Real(0), "no wheel pulls");
    }
    Real grip = source.number<Real>();
    const Real most = source.size<Real>();
    shelf::wheel_grip(grip, source.number<Real>(), source.size<Real>(), most, source.above<Real>());
    if (source.tame()) require(std::abs(grip) <= most, "a grip stays within its bound");
  });
  add_numbers(cases, "orientation", "turns", []<class Real>(Source& source) {
    auto q = orientation<Real>(source);
    shelf::turn(q, source.vector<Vec3<Real>>(), source.number<Real>());
    check(source, q);
    shelf::turn_exact(q, source.vector<Vec3<Real>>(), source.number<Real>());
    check(source, q);
    q = q * orientation<Real>(source);
    const auto there = shelf::rotate(q, source.vector<Vec3<Real>>()),
               back = shelf::rotate_back(q, there);
    if (source.tame()) require(finite(there) && finite(back), "a vector that is turned");
  });
  add_numbers(cases, "orientation", "spins", []<class Real>(Source& source) {
    auto q = orientation<Real>(source);
    const Vec3<Real> inertia{source.above<Real>(), source.above<Real>(), source.above<Real>()};
    Vec3<Real> L = shelf::angular_momentum(q, source.vector<Vec3<Real>>(), inertia);
    const Real h = source.number<Real>();
    shelf::spin_by_rotations(q, L, inertia, h);
    check(source, q);
    shelf::spin_damped(q, L, inertia, source.size<Real>(), source.size<Real>());
    check(source, q);
    const auto w = shelf::angular_velocity(q, L, inertia);
    auto beside = q;
    if (std::abs(h) * length(w) <= Real(2)) {
      shelf::spin_by_midpoint(q, L, inertia, h);
      check(source, q);
    }
    shelf::spin_by_midpoint(beside, L, inertia, source.number<Real>());
    shelf::spin_by_bullet(beside, L, inertia, source.number<Real>());
  });
  add_numbers(cases, "orientation", "follows", []<class Real>(Source& source) {
    auto q = orientation<Real>(source);
    auto w = source.vector<Vec3<Real>>();
    for (int n = 0; n < 4; ++n) {
      const auto target = orientation<Real>(source);
      shelf::turn_damp(q, w, target, source.vector<Vec3<Real>>(), source.size<Real>(),
                       source.size<Real>());
      check(source, q);
      const auto left = shelf::turn_between(target, q);
      if (source.tame()) require(length(left) < Real(3.15), "the shorter way round");
    }
  });
  add_numbers(cases, "orientation", "pushes", []<class Real>(Source& source) {
    const auto q = orientation<Real>(source);
    const auto inertia = shelf::inertia_of_box(
        source.above<Real>(), {source.above<Real>(), source.above<Real>(), source.above<Real>()});
    const auto n = source.direction<Vec3<Real>>(), r = source.vector<Vec3<Real>>();
    const Real inverse = shelf::inverse_mass_at(q, inertia, source.size<Real>(), r, n);
    if (source.tame()) require(inverse >= Real(0), "what 1/mass is to a push");
  });
  add_contacts(cases);
  return cases;
}

}  // namespace fuzz
