// SPDX-License-Identifier: MIT-0
#pragma once
#include "numbers.h"

template <class Kind>
void contact_on(Numbers& found) {
  using Real = typename Kind::Real;
  using Vec = typename Kind::Vec;
  const auto cross = [](const Vec& p, const Vec& r) {
    const auto minor = [&](int i, int j) {
      return Kind::read(p, i) * Kind::read(r, j) - Kind::read(p, j) * Kind::read(r, i);
    };
    const Real numbers[] = {minor(1, 2), minor(2, 0), minor(0, 1)};
    return Kind::make(numbers);
  };
  const auto spin = [](const Vec& L) {  // of a ball: the same however it is turned
    return Vec(Real(0.25) * L);
  };
  const Real fast[] = {2, -3, 1}, turns[] = {Real(0.5), 0, -1}, down[] = {0, -8, 0},
             up[] = {0, 1, 0};
  Vec v = Kind::make(fast), L = Kind::make(turns);
  const Vec a = Kind::make(down);
  const shelf::Contact<Vec, Real> untouched{a, a, a};
  shelf::Contact<Vec, Real> contacts[] = {untouched, untouched, untouched, untouched};
  const shelf::Surface<Real> surface{Real(0.5), Real(0.25), Real(0.5)};
  for (int n = 0; n < 4; ++n) {
    for (int i = 0; i < 4; ++i) {
      const Real r[] = {Real(i & 1 ? 0.5 : -0.5), Real(-0.25), Real(i & 2 ? 0.375 : -0.375)};
      contacts[i].r = Kind::make(r);
      contacts[i].normal = Kind::make(up);
      contacts[i].gap = Real(i - 1) / Real(256);
    }
    const shelf::Way<Vec, Vec> way = shelf::contact_step(
        v, L, a, Real(0.0625), contacts, 4, surface, Real(0.5), spin, Dot<Kind>(), cross);
    for (const Vec& one : {v, L, way.v, way.L}) add_all<Kind>(found, one);
    for (const auto& contact : contacts) found.add(double(contact.push));
  }
  using Body = shelf::PushedBody<Vec, Vec, Real, decltype(spin), const Dot<Kind>, decltype(cross)>;
  const Dot<Kind> dot{};
  Body body{v, L, Real(0.5), spin, dot, cross};
  body.push(contacts[0].r, a);
  add_all<Kind>(found, body.velocity_at(contacts[0].r));
}
