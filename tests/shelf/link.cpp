// SPDX-License-Identifier: MIT-0
#include "shelf/link.h"

#include <algorithm>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "three.h"

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double g = 9.81;
constexpr auto length_of = [](double x) { return std::abs(x); };
constexpr auto anywhere = [](double x) { return x; };

// A rope that hangs straight down, or should.
struct Hanging {
  std::vector<double> x, before, tension, w;
  shelf::Rope<double> rope;

  Hanging(int links, double stiffness, double mass = 0.01)
      : tension(std::size_t(links)), w(std::size_t(links) + 1, 1 / mass) {
    rope.length = 2.0 / links;
    rope.compliance = 1 / stiffness;
    for (int i = 0; i <= links; ++i) x.push_back(-i * rope.length);
    before = x;
    w[0] = 0;
  }

  void run(double h, double duration) {
    for (int n = 0; n * h < duration; ++n) {
      shelf::rope_step(x, before, tension, w, x.size(), rope, -g, h, length_of, anywhere);
    }
  }

  // How far a point goes at most in one step of the next second.
  double restless(double h) {
    double most = 0;
    for (int n = 0; n * h < 1; ++n) {
      run(h, h / 2);
      for (std::size_t i = 0; i < x.size(); ++i) most = std::max(most, std::abs(x[i] - before[i]));
    }
    return most;
  }

  double stretch() const { return -x.back() / 2 - 1; }
};

// The stiffness at which springs let a rope of 2 m and masses of 10 g hang one per cent longer.
double one_per_cent(int links) {
  return 0.01 * g * links * (links + 1) / 2 / 0.02;
}

template <class Real>
struct Pair {
  Three<Real> x1, x2;
  Real w1, w2;
};

template <class Real>
std::vector<Pair<Real>> pairs() {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-1, 1), power(-3, 3);
  const auto point = [&] { return Three<Real>{Real(place(random)), Real(place(random)), 1}; };
  std::vector<Pair<Real>> all;
  for (int n = 0; n < 200; ++n) {
    all.push_back(
        {point(), point(), Real(std::pow(10, power(random))), Real(std::pow(10, power(random)))});
  }
  return all;
}

}  // namespace

TEMPLATE_TEST_CASE("A pull brings two points to their distance, the lighter one further", "", float,
                   double) {
  const long double rounding = 16 * std::numeric_limits<TestType>::epsilon();
  for (const auto& p : pairs<TestType>()) {
    for (const double length : {0.0, 0.3, 5.0}) {
      CAPTURE(p.w1, p.w2, length);
      auto x1 = p.x1, x2 = p.x2;
      shelf::pull(x1, x2, p.w1, p.w2, TestType(length), norm);
      const long double moved1 = apart(exactly(x1), exactly(p.x1));
      const long double moved2 = apart(exactly(x2), exactly(p.x2));
      CHECK(std::abs(apart(exactly(x1), exactly(x2)) - TestType(length)) < rounding);
      CHECK(std::abs(moved1 * p.w2 - moved2 * p.w1) < rounding * (p.w1 + p.w2));
    }
  }
}

TEMPLATE_TEST_CASE("A pull and a link leave the centre of mass where it was", "", float, double) {
  const long double rounding = 16 * std::numeric_limits<TestType>::epsilon();
  for (const auto& p : pairs<TestType>()) {
    const auto centre = [&](const auto& x1, const auto& x2) {
      const long double m1 = 1 / (long double)p.w1, m2 = 1 / (long double)p.w2;
      return (m1 / (m1 + m2)) * exactly(x1) + (m2 / (m1 + m2)) * exactly(x2);
    };
    auto x1 = p.x1, x2 = p.x2;
    shelf::pull(x1, x2, p.w1, p.w2, TestType(0.5), norm);
    CHECK(apart(centre(x1, x2), centre(p.x1, p.x2)) < rounding);
    TestType tension = 3;
    shelf::link(x1, x2, tension, p.w1, p.w2, TestType(0.2), TestType(1e-4), TestType(0.01), norm);
    CHECK(apart(centre(x1, x2), centre(p.x1, p.x2)) < rounding);
  }
}

TEMPLATE_TEST_CASE("A point of inverse mass 0 stays to the bit, and so do two at one place", "",
                   float, double) {
  using Vec = Three<TestType>;
  const Vec here{TestType(0.1), 2, 3}, there{1, TestType(0.7), -2};
  const TestType h = TestType(0.01), compliance = TestType(1e-3), one = 1, none = 0;
  for (const bool both : {false, true}) {
    Vec x1 = here, x2 = there;
    TestType tension = 5;
    shelf::pull(x1, x2, none, both ? none : one, one, norm);
    shelf::link(x1, x2, tension, none, both ? none : one, one / 2, compliance, h, norm);
    shelf::link_warm_start(x1, x2, tension, none, both ? none : one, h, norm);
    CHECK(x1 == here);
    CHECK((x2 == there) == both);
  }
  Vec x1 = here, x2 = here;
  TestType tension = 5;
  shelf::pull(x1, x2, one, one, one, norm);
  shelf::link(x1, x2, tension, one, one, one, compliance, h, norm);
  shelf::link_warm_start(x1, x2, tension, one, one, h, norm);
  CHECK(x1 == here);
  CHECK(x2 == here);
  CHECK(tension == 5);
}

TEMPLATE_TEST_CASE("A link with compliance makes the step of backward Euler", "", float, double) {
  // A mass on a spring at an anchor: x'' = -omega^2 (x - 1), by (e + h v) / (1 + (h omega)^2).
  const TestType h = TestType(1) / 60, w = 5;
  for (const double angle : {1e-6, 1e-4, 1e-2, 0.1, 0.5, 1.0, 10.0, 1e3}) {
    for (const double speed : {-3.0, 0.0, 2.0}) {
      CAPTURE(angle, speed);
      const long double omega = angle / (long double)h;
      const TestType compliance = TestType(w / (omega * omega));
      Three<TestType> anchor{0, 0, 0}, x{TestType(1.25), 0, 0};
      x = x + (h * TestType(speed)) * Three<TestType>{1, 0, 0};
      const long double moved = (long double)x.x - 1;
      TestType tension = 0;
      shelf::link(anchor, x, tension, TestType(0), w, TestType(1), compliance, h, norm);
      const long double exact = moved / (1 + (long double)(angle)*angle);
      const double epsilon = std::numeric_limits<TestType>::epsilon();
      CHECK_THAT(double(x.x - 1), WithinAbs(double(exact), 4 * epsilon));
      // The place is known to a rounding of 1 m, and the tension to what that stretches it by.
      const double known = 8 * epsilon / double(w * h * h) * angle * angle / (1 + angle * angle);
      CHECK_THAT(double(tension), WithinAbs(double(exact / compliance), known));
    }
  }
}

TEST_CASE("From any warm start one solve of one link ends at the same places and tension") {
  for (const double warm : {-40.0, 0.0, 3.0, 1e4}) {
    for (const double compliance : {1e-6, 1e-3, 1.0}) {
      CAPTURE(warm, compliance);
      const Three<double> start1{0, 0, 0}, start2{0.3, 0.4, 1.2};  // 1.3 m apart
      auto cold1 = start1, cold2 = start2, warm1 = start1, warm2 = start2;
      double tension = 0, kept = warm;
      shelf::link(cold1, cold2, tension, 2.0, 3.0, 1.0, compliance, 0.001, norm);
      shelf::link_warm_start(warm1, warm2, warm, 2.0, 3.0, 0.001, norm);
      shelf::link(warm1, warm2, kept, 2.0, 3.0, 1.0, compliance, 0.001, norm);
      CHECK(apart(exactly(cold1), exactly(warm1)) < 1e-13);
      CHECK(apart(exactly(cold2), exactly(warm2)) < 1e-13);
      CHECK_THAT(kept, WithinRel(tension, 1e-9));
      CHECK_THAT(tension * compliance, WithinRel(double(norm(cold2 + -1.0 * cold1)) - 1, 1e-9));
    }
  }
}

TEST_CASE("Without compliance a link is a pull") {
  for (const auto& p : pairs<double>()) {
    auto x1 = p.x1, x2 = p.x2, y1 = p.x1, y2 = p.x2;
    double tension = 0;
    shelf::pull(x1, x2, p.w1, p.w2, 0.7, norm);
    shelf::link(y1, y2, tension, p.w1, p.w2, 0.7, 0.0, 0.01, norm);
    CHECK(apart(exactly(x1), exactly(y1)) < 1e-14);
    CHECK(apart(exactly(x2), exactly(y2)) < 1e-14);
  }
}

TEST_CASE("In a rope that hangs, the next link's tension times h^2/m opens a link further") {
  for (const int links : {3, 20}) {
    for (const double h : {1 / 60.0, 1 / 240.0, 1 / 960.0}) {
      for (const double tip : {0.01, 0.002, 0.05}) {
        CAPTURE(links, h, tip);
        Hanging hanging(links, 4e3);
        hanging.w[std::size_t(links)] = 1 / tip;
        hanging.run(h, 300);
        double weight = tip * g;  // of all that hangs on a link
        double below = 0;
        for (std::size_t i = std::size_t(links); i > 0; --i) {
          const double length = hanging.x[i - 1] - hanging.x[i];
          CHECK_THAT(length, WithinAbs(2.0 / links + weight / 4e3 + h * h / 0.01 * below, 1e-9));
          CHECK_THAT(hanging.tension[i - 1], WithinRel(weight, 1e-6));
          below = weight;
          weight += 0.01 * g;
        }
      }
    }
  }
}

TEST_CASE("A rope that should give 1 % gives that and (n - 1) n g h^2 / 2 more") {
  for (const int links : {5, 20, 40}) {
    for (const int substeps : {1, 4, 8, 32}) {
      const double h = 1 / 60.0 / substeps;
      Hanging springy(links, one_per_cent(links)), stiff(links, 1 / 0.0);
      springy.run(h, 300);
      stiff.run(h, 300);
      const double law = links * (links - 1) * g * h * h / 2 / 2;
      CHECK_THAT(springy.stretch(), WithinAbs(0.01 + law, 1e-4 * law + 1e-6));
      CHECK_THAT(stiff.stretch(), WithinAbs(law, 1e-4 * law + 1e-9));
    }
  }
}

TEST_CASE("More passes in a step stretch a rope less, down to what was asked") {
  double before = 1;
  for (const int passes : {1, 8, 32, 128, 1024}) {
    Hanging hanging(20, one_per_cent(20));
    hanging.rope.passes = passes;
    hanging.run(1 / 60.0, 30);
    CHECK(hanging.stretch() < before);
    CHECK(hanging.stretch() > 0.0099);
    before = hanging.stretch();
  }
  CHECK_THAT(before, WithinAbs(0.01, 1e-5));
}

TEST_CASE("Begun warm, a rope gives what was asked, and bursts at the stiffness of m/h^2") {
  Hanging warm(20, one_per_cent(20));
  warm.rope.warm = true;
  warm.run(1 / 480.0, 60);
  CHECK_THAT(warm.stretch(), WithinAbs(0.01, 1e-6));
  for (const int substeps : {4, 8, 16}) {
    CAPTURE(substeps);
    const double h = 1 / 60.0 / substeps;
    Hanging rests(20, 0.8 * 0.01 / (h * h)), bursts(20, 1.5 * 0.01 / (h * h));
    rests.rope.warm = bursts.rope.warm = true;
    rests.run(h, 60);
    bursts.run(h, 60);
    CHECK(rests.restless(h) < 1e-4);
    CHECK(bursts.restless(h) > 0.01);
  }
}

TEST_CASE("Torn over hundreds of metres, a rope comes back; begun cold it bears any stiffness") {
  for (const double stiffness : {10.0, 1e4, 1e12}) {
    Hanging torn(20, stiffness);
    for (std::size_t i = 1; i < torn.x.size(); ++i) torn.x[i] = (i % 2 ? 300.0 : -400.0);
    torn.before = torn.x;
    torn.run(1 / 60.0, 600);
    Hanging calm(20, stiffness);
    calm.run(1 / 60.0, 600);
    CHECK_THAT(torn.stretch(), WithinRel(calm.stretch(), 1e-3));
  }
}

TEST_CASE("A rope that nobody holds falls as one body") {
  using Vec = Three<double>;
  std::vector<Vec> x, before;
  std::vector<double> w, tension(9);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-1, 1);
  for (int i = 0; i < 10; ++i) {
    x.push_back({place(random), place(random), place(random)});
    w.push_back(1 + i);
  }
  before = x;
  const auto centre = [&] {
    Long sum{0, 0, 0};
    long double mass = 0;
    for (std::size_t i = 0; i < 10; ++i) {
      sum = sum + (1 / (long double)w[i]) * exactly(x[i]);
      mass += 1 / (long double)w[i];
    }
    return (1 / mass) * sum;
  };
  const Long start = centre();
  const double h = 0.01;
  const auto free = [](const Vec& p) { return p; };
  for (int n = 1; n <= 100; ++n) {
    shelf::rope_step(x, before, tension, w, x.size(), {0.2, 1e-5, 3, false}, Vec{0, 0, -g}, h, norm,
                     free);
    const long double fallen = g * h * h * n * (n + 1) / 2;
    CHECK(apart(centre(), start + Long{0, 0, -fallen}) < 1e-12);
  }
}

TEMPLATE_TEST_CASE("No free point of a rope is below its floor, and a held one may be", "", float,
                   double) {
  using Vec = Three<TestType>;
  std::vector<Vec> x;
  std::vector<TestType> w(21, 100), tension(20);
  for (int i = 0; i < 21; ++i) x.push_back({TestType(0.1) * TestType(i), 0, TestType(0.5)});
  x[0].z = -1;
  w[0] = 0;
  auto before = x;
  const auto floor = [](const Vec& p) { return Vec{p.x, p.y, std::max(p.z, TestType(0))}; };
  const shelf::Rope<TestType> rope{TestType(0.1), 0, 4, false};
  for (int n = 0; n < 300; ++n) {
    shelf::rope_step(x, before, tension, w, x.size(), rope, Vec{0, 0, TestType(-g)},
                     TestType(1) / 60, norm, floor);
    for (std::size_t i = 1; i < x.size(); ++i) CHECK(x[i].z >= 0);
    CHECK(x[0].z == -1);
  }
}

namespace {

// Where the end of a rope is in half a second that nobody holds, or that swings from a hook, seen
// from its first point at the start. It lies level, at a height.
template <class Real>
Long end_of_rope(double height, double gravity, bool hook) {
  using Vec = Three<Real>;
  std::vector<Vec> x;
  std::vector<Real> tension(5), w(6, Real(100));
  for (int i = 0; i < 6; ++i) x.push_back({Real(0.1 * i), 0, Real(height)});
  if (hook) w[0] = 0;
  auto before = x;
  const Vec first = x[0];
  const auto free = [](const Vec& p) { return p; };
  const shelf::Rope<Real> rope{Real(0.1), Real(1e-4)};
  for (int n = 0; n < 240; ++n) {
    shelf::rope_step(x, before, tension, w, x.size(), rope, Vec{0, 0, Real(gravity)}, Real(1) / 480,
                     norm, free);
  }
  return exactly(x[5]) + -1.0L * exactly(first);
}

}  // namespace

TEST_CASE("In float a rope near the origin falls and swings as in double, and far away it stays") {
  const double added = 9.81 / 480 / 480;
  for (const bool hook : {false, true}) {
    for (const double share : {0.51, 0.6, 0.77, 0.93, 1.0}) {
      CAPTURE(hook, share);
      // Towards the origin, so that it stays within the bound.
      const double height = share * std::ldexp(added, 17);
      const Long in_double = end_of_rope<double>(height, -g, hook);
      const Long in_float = end_of_rope<float>(height, -g, hook);
      CHECK(apart(in_float, in_double) < 0.01 * apart(in_double, {0.5, 0, 0}));
    }
    const double far = std::ldexp(added, 25);
    CHECK(end_of_rope<float>(far, -g, hook).z == 0);
    CHECK(end_of_rope<double>(far, -g, hook).z < -0.2);
    // An eighth of that way off gravity is still there, but wrong by more than a per cent.
    CHECK(apart(end_of_rope<float>(far / 8 * 0.9, -g, hook),
                end_of_rope<double>(far / 8 * 0.9, -g, hook)) > 0.01);
  }
}

TEST_CASE("A point is kicked by what is taken off its last place, and slowed by a share of it") {
  const double h = 1 / 240.0;
  const double w[1] = {2};
  double x[1] = {0.5}, before[1] = {0.5}, tension[1] = {};
  const shelf::Rope<double> rope{1.0};
  before[0] = before[0] + (-h) * 3.0;
  const auto step = [&] {
    shelf::rope_step(x, before, tension, w, 1, rope, 0.0, h, length_of, anywhere);
  };
  for (int n = 0; n < 240; ++n) step();
  CHECK_THAT(x[0], WithinAbs(3.5, 1e-12));
  for (int n = 0; n < 240; ++n) {
    before[0] = before[0] + (0.7 * h) * (x[0] - before[0]);
    step();
  }
  CHECK_THAT((x[0] - before[0]) / h, WithinRel(3 * std::exp(-0.7), 2e-3));
}

TEST_CASE("The rope of the example bobs by 6.4 cm after ten seconds, and not if it is damped") {
  const double h = 1 / 960.0;
  for (const double share : {0.0, 2.0}) {
    Hanging hanging(20, 2000);
    hanging.w[20] = 1 / 0.5;
    double lowest = 0, highest = -9;
    for (int n = 0; n < 11 * 960; ++n) {
      for (std::size_t i = 0; i < hanging.x.size(); ++i) {
        hanging.before[i] =
            hanging.before[i] + (share * h) * (hanging.x[i] + -1.0 * hanging.before[i]);
      }
      hanging.run(h, h / 2);
      if (n < 10 * 960) continue;
      lowest = std::min(lowest, hanging.x[20]);
      highest = std::max(highest, hanging.x[20]);
    }
    if (share > 0) {
      CHECK(highest - lowest < 0.001);
    } else {
      CHECK_THAT(highest - lowest, WithinAbs(0.064, 0.0005));
    }
  }
}

TEST_CASE("A grapple swings lower and lower, and the lower the longer its steps") {
  for (const auto& [substeps, angle] : {std::pair{1, 0.894}, {4, 0.971}, {8, 0.986}, {16, 0.993}}) {
    const double h = 1 / 60.0 / substeps;
    using Place = Three<double>;
    std::vector<Place> x{{0, 0, 0}, {6 * std::sin(1.0), -6 * std::cos(1.0), 0}}, before = x;
    std::vector<double> tension{0}, w{0, 1};
    const shelf::Rope<double> rope{6};
    double widest = 0;
    for (int n = 0; n < 600 * substeps; ++n) {
      shelf::rope_step(x, before, tension, w, x.size(), rope, Place{0, -g, 0}, h, norm,
                       [](const Place& place) { return place; });
      if (n >= 300 * substeps) widest = std::max(widest, std::atan2(x[1].x, -x[1].y));
    }
    CAPTURE(substeps);
    CHECK_THAT(widest, WithinAbs(angle, 0.002));
  }
}

TEST_CASE("A point that is not a number stays alone with it") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  double x1 = nan, x2 = 2, tension = 1;
  shelf::pull(x1, x2, 1.0, 1.0, 1.0, length_of);
  shelf::link(x1, x2, tension, 1.0, 1.0, 1.0, 1e-3, 0.01, length_of);
  shelf::link_warm_start(x1, x2, tension, 1.0, 1.0, 0.01, length_of);
  CHECK(x2 == 2);
  CHECK(tension == 1);
}

TEMPLATE_TEST_CASE("Points that nearly touch stay where they are", "", float, double) {
  const auto size = [](TestType x) { return std::abs(x); };
  const TestType near = std::numeric_limits<TestType>::denorm_min(), held = 0, free = 1, h = 0.25;
  TestType x1 = 0, x2 = near, tension = 0;
  shelf::pull(x1, x2, held, free, TestType(2), size);
  shelf::link_warm_start(x1, x2, TestType(5), held, free, h, size);
  shelf::link(x1, x2, tension, held, free, TestType(2), TestType(0), h, size);
  CHECK(x1 == 0);
  CHECK(x2 == near);
}

TEST_CASE("A pull is worked out by the compiler") {
  constexpr double middle = [] {
    double x1 = 0, x2 = 4;
    shelf::pull(x1, x2, 1.0, 3.0, 2.0, [](double d) { return d < 0 ? -d : d; });
    return x1;
  }();
  CHECK(middle == 0.5);
}
