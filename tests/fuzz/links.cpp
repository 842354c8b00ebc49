// SPDX-License-Identifier: MIT-0
// Links and ropes of them.
#include "fuzz.h"
#include "shelf/grapple.h"
#include "shelf/link.h"

namespace fuzz {
namespace {

void add_single(Cases& cases) {
  const auto stay = [](Source& source, auto w1, auto w2, bool stays1, bool stays2) {
    if (!source.tame()) return;
    if (w1 == 0) require(stays1, "a point of inverse mass 0 stays to the bit");
    if (w2 == 0) require(stays2, "a point of inverse mass 0 stays to the bit");
  };
  add(cases, "link", "one link", [stay]<class Vec, class Real>(Source& source) {
    Vec x1 = source.vector<Vec>(), x2 = source.whole(0, 9) ? source.vector<Vec>() : x1;
    const Vec start1 = x1, start2 = x2;
    const Real w1 = source.size<Real>(), w2 = source.size<Real>(), h = source.above<Real>();
    Real tension = source.number<Real>();
    shelf::link_warm_start(x1, x2, tension, w1, w2, h, length);
    shelf::link(x1, x2, tension, w1, w2, source.size<Real>(), source.size<Real>(), h, length);
    shelf::pull(x1, x2, w1, w2, source.size<Real>(), length);
    stay(source, w1, w2, same(x1, start1), same(x2, start2));
    if (source.tame())
      require(finite(x1) && finite(x2) && finite(tension), "points stay somewhere");
    if (source.tame() && same(start1, start2))
      require(same(x1, x2), "at the same place, they stay there");
  });
  // As near as can be, and yet not at the same place.
  add_numbers(cases, "link", "two points that nearly touch", [stay]<class Real>(Source& source) {
    Real x1 = 0, x2 = std::ldexp(std::numeric_limits<Real>::denorm_min(), source.whole(0, 30)),
         tension = 0;
    const Real start2 = x2, w1 = source.size<Real>(), w2 = source.size<Real>(),
               h = source.above<Real>();
    const auto size = [](Real apart) { return std::abs(apart); };
    shelf::link_warm_start(x1, x2, source.number<Real>(), w1, w2, h, size);
    shelf::pull(x1, x2, w1, w2, source.size<Real>(), size);
    shelf::link(x1, x2, tension, w1, w2, source.size<Real>(), source.size<Real>(), h, size);
    stay(source, w1, w2, same(x1, Real(0)), same(x2, start2));
    if (source.tame()) require(finite(x1) && finite(x2), "points stay somewhere");
  });
}

}  // namespace

Cases links() {
  Cases cases;
  add_single(cases);
  add(cases, "link", "a rope", []<class Vec, class Real>(Source& source) {
    constexpr int most = 5;
    Vec x[most], before[most];
    Real w[most], tension[most];
    for (int i = 0; i < most; ++i) {
      x[i] = before[i] = source.vector<Vec>();
      w[i] = source.size<Real>();
      tension[i] = Real(0);
    }
    const int count = source.whole(0, most);
    shelf::Rope<Real> rope{source.size<Real>(), source.size<Real>(), source.whole(1, 3),
                           source.whole(0, 1) == 0};
    const Vec held = x[0], a = source.vector<Vec>(), ground = source.vector<Vec>();
    const auto floor = [&](const Vec& place) { return source.whole(0, 1) ? place : ground; };
    for (int n = 0; n < 3; ++n)
      shelf::rope_step(x, before, tension, w, count, rope, a, source.above<Real>(), length, floor);
    if (source.tame() && w[0] == 0) require(same(x[0], held), "a point of inverse mass 0 stays");
  });
  add(cases, "link", "a rope on the floor", []<class Vec, class Real>(Source& source) {
    Vec x[] = {source.vector<Vec>(), source.vector<Vec>(), source.vector<Vec>()};
    Vec before[] = {x[0], x[1], x[2]};
    Real w[] = {Real(0), Real(1), source.above<Real>()}, tension[] = {Real(0), Real(0)};
    const Vec up = source.direction<Vec>(), ground = source.vector<Vec>();
    // Whatever isn't above the ground, what is not a number included, is put onto it.
    const auto floor = [&](const Vec& place) {
      return dot(place, up) > dot(ground, up) ? place : ground;
    };
    const shelf::Rope<Real> rope{source.size<Real>(), source.size<Real>(), source.whole(1, 3)};
    shelf::rope_step(x, before, tension, w, 3, rope, source.vector<Vec>(), source.above<Real>(),
                     length, floor);
    for (int i = 1; i < 3; ++i) {
      if (w[i] > Real(0))
        require(!(dot(x[i], up) < dot(ground, up)),
                "no free point is below the floor after a step");
    }
  });
  add(cases, "grapple", "a player on a rope", []<class Vec, class Real>(Source& source) {
    Vec x = source.vector<Vec>(), v = source.vector<Vec>();
    const Vec hook = source.vector<Vec>(), moves = source.vector<Vec>(), a = source.vector<Vec>();
    Real rope = source.size<Real>();
    for (int n = 0; n < 4; ++n) {
      const Real pull = shelf::grapple_step(x, v, rope, hook, moves, source.number<Real>(), a,
                                            source.above<Real>(), product);
      if (!source.tame()) continue;
      require(finite(x) && finite(v) && finite(rope) && finite(pull), "all stay numbers");
      require(rope >= Real(0) && pull >= Real(0), "no rope of less than nothing, and none pushes");
    }
  });
  return cases;
}

}  // namespace fuzz
