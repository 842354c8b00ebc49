// SPDX-License-Identifier: MIT-0
#pragma once
#include "numbers.h"

template <class Kind>
void orientation_on(Numbers& found) {
  using Real = typename Kind::Real;
  using Vec = typename Kind::Vec;
  // Copied in and copied out, as the header says.
  const auto in = [](const Vec& v) {
    return shelf::Vec3<Real>{Kind::read(v, 0), Kind::read(v, 1), Kind::read(v, 2)};
  };
  const auto out = [&](const shelf::Vec3<Real>& v) {
    const Real numbers[] = {v.x, v.y, v.z};
    add_all<Kind>(found, Kind::make(numbers));
  };
  const auto turned = [&](const shelf::Quaternion<Real>& q) {
    out({q.x, q.y, q.z});
    found.add(double(q.w));
  };
  const Real edges[] = {Real(0.5), Real(2), Real(1)}, spin[] = {Real(-0.5), Real(2), Real(1)};
  const shelf::Vec3<Real> inertia = shelf::inertia_of_box(Real(3), in(Kind::make(edges)));
  const shelf::Vec3<Real> w = in(Kind::make(spin));
  const Real h = Real(0.0625);
  out(inertia);

  shelf::Quaternion<Real> q;
  shelf::turn(q, w, h);
  shelf::turn_exact(q, w, h);
  turned(q);
  turned(shelf::Quaternion<Real>{Real(0), Real(0.5), Real(0), Real(0)} * q);
  turned(normalised(shelf::Quaternion<Real>{Real(3), Real(0), Real(-4), Real(0)}));
  out(shelf::rotate(q, w));
  out(shelf::rotate_back(q, w));
  out(cross(w, inertia));
  found.add(double(dot(w, inertia)));
  found.add(double(shelf::inverse_mass_at(q, inertia, Real(0.5), w, {Real(0), Real(1), Real(0)})));

  shelf::Quaternion<Real> follower;
  shelf::Vec3<Real> its_w;
  shelf::turn_damp(follower, its_w, q, w, Real(3), h);
  turned(follower);
  out(its_w);
  out(shelf::turn_between(q, follower));

  shelf::Vec3<Real> L = shelf::angular_momentum(q, w, inertia);
  for (int n = 0; n < 3; ++n) {
    shelf::spin_by_rotations(q, L, inertia, h);
    shelf::spin_by_midpoint(q, L, inertia, h);
    shelf::spin_by_bullet(q, L, inertia, h);
    shelf::spin_damped(q, L, inertia, h, Real(0.5));
  }
  turned(q);
  out(L);
  out(shelf::angular_velocity(q, L, inertia));
  out(shelf::SpinEquation<Real>{w, inertia, h}.better(L));
}
