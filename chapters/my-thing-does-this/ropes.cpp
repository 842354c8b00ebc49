// SPDX-License-Identifier: MIT-0
// Ropes, links and Verlet's method.
#include <cmath>
#include <complex>

#include "frames/recorded.h"
#include "integrate/stormer_verlet.h"
#include "measure/sheet.h"
#include "shelf/grapple.h"
#include "shelf/link.h"
#include "sketch.h"

namespace {

using Flat = std::complex<double>;

const auto norm = [](double d) { return std::abs(d); };
const auto anywhere = [](double x) { return x; };

// A rope of two metres in 20 links of no compliance, with a weight as heavy as ten of its points.
// How long it is.
Line hanging(const char* label, double rate, int substeps, double compliance = 0) {
  constexpr int count = 21;
  struct State {
    double x[count], before[count], tension[count - 1], w[count];
  } rope;
  for (int i = 0; i < count; ++i) rope.x[i] = rope.before[i] = -0.1 * i, rope.w[i] = 1 / 0.01;
  for (double& tension : rope.tension) tension = 0;
  rope.w[0] = 0, rope.w[count - 1] = 1 / 0.1;
  return run(label, 2, rate, 2, [=](double h) mutable {
    const shelf::Rope<double> links{0.1, compliance};
    for (int n = 0; n < substeps; ++n) {
      shelf::rope_step(rope.x, rope.before, rope.tension, rope.w, count, links, -g, h / substeps,
                       norm, anywhere);
    }
    return -rope.x[count - 1];
  });
}

Sketch sags() {
  return {"sags",
          2,
          "t [s]",
          "m long",
          {hanging("one pass a frame", 60, 1), hanging("8 substeps of one pass", 60, 8)}};
}

Sketch softer_by_frames() {
  return {"softer-by-frames",
          2,
          "t [s]",
          "m long",
          {hanging("one pass, at 30 fps", 30, 1), hanging("at 120 fps", 120, 1),
           hanging("substeps of 1/480 s, at any", 30, 16)}};
}

// Two bodies of 10 g on a spring of 1000 N/m, pulled 1 cm apart.
Sketch stiff_explodes() {
  double x = 0.01, v = 0, left = 0, right = 0.11, before_left = 0, before_right = 0.11, tension = 0;
  return {"stiff-explodes",
          0.5,
          "t [s]",
          "m of stretch",
          {run("velocity first, at 60 Hz", 0.5, 60, 0.01,
               [&](double h) {
                 v -= h * 2 * 1000 / 0.01 * x;
                 return x += h * v;
               }),
           run("link, at 60 Hz", 0.5, 60, 0.01, [&](double h) {
             const double a = left, b = right;
             left += left - before_left, right += right - before_right;
             before_left = a, before_right = b;
             tension = 0;
             shelf::link(left, right, tension, 100.0, 100.0, 0.1, 1e-3, h, norm);
             return right - left - 0.1;
           })}};
}

// By how much the worst link of a sheet in free fall is too long or too short, in 16 substeps.
Sketch cloth_bursts() {
  const auto sheet = [](const char* label, bool shuffled) {
    measure::Sheet cloth;
    if (shuffled) cloth.shuffle();
    return run(label, 0.5, 60, 0, [=](double h) mutable {
      for (int n = 0; n < 16; ++n) cloth.step(float(h / 16), 1e-5f, 1);
      return 100 * cloth.worst();
    });
  };
  return {"cloth-bursts",
          0.5,
          "t [s]",
          "% off",
          {sheet("links cell by cell", false), sheet("the same links, shuffled", true)}};
}

Sketch loses_its_swing() {
  const auto dot = [](const Flat& a, const Flat& b) { return std::real(a * std::conj(b)); };
  const Flat start = 6.0 * Flat(std::sin(1.0), -std::cos(1.0));
  Flat x[] = {0, start}, before[] = {0, start}, y = start, v = 0;
  double tension[] = {0}, length = 6;
  const double w[] = {0, 1 / 80.0};
  const auto angle = [](const Flat& place) { return std::atan2(place.real(), -place.imag()); };
  return {"loses-its-swing",
          15,
          "t [s]",
          "rad",
          {run("one link", 15, 60, 1,
               [&](double h) {
                 shelf::rope_step(
                     x, before, tension, w, 2, shelf::Rope<double>{6}, Flat(0, -g), h,
                     [](const Flat& a) { return std::abs(a); }, [](const Flat& a) { return a; });
                 return angle(x[1]);
               }),
           run("grapple_step", 15, 60, 1, [&](double h) {
             shelf::grapple_step(y, v, length, Flat(0), Flat(0), 0, Flat(0, -g), h, dot);
             return angle(y);
           })}};
}

// A jump of 9 m/s in recorded frames: how far it is from where it should be.
Sketch verlet_in_uneven_frames() {
  const auto fall = [](double, double, double) { return -g; };
  const auto jump = [&](const char* label, bool knows) {
    frames::Playback frame;
    double h_before = 1 / 60.0, x = 0, x_previous = 0, t = 0;
    bool begun = false;
    return run(label, 1.8, 60, 0, [=](double) mutable {
      const double h = frame.next();
      if (!begun) {
        begun = true, h_before = h;
        x_previous = integrate::stormer_verlet_start(x, 9.0, 0.0, h, fall);
      }
      if (knows) {
        integrate::stormer_verlet_uneven(x, x_previous, t, h, h_before, fall);
      } else {
        integrate::stormer_verlet(x, x_previous, t, h, fall);
      }
      h_before = h, t += h;
      return x - (9 * t - g * t * t / 2);
    });
  };
  return {"verlet-in-uneven-frames",
          1.8,
          "t [s]",
          "m off",
          {jump("x + (x - before) + h^2 a", false), jump("stormer_verlet_uneven", true)}};
}

}  // namespace

std::vector<Sketch> sketches_of_ropes() {
  return {sags(),         softer_by_frames(), stiff_explodes(),
          cloth_bursts(), loses_its_swing(),  verlet_in_uneven_frames()};
}
