// SPDX-License-Identifier: MIT-0
#include "home/plot_film.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "format_values.h"

namespace grade {
namespace {

constexpr double width = 16, height = 9;

/// An axis: what lies between two values lies between 0 and the length.
struct Axis {
  double low = INFINITY, high = -INFINITY, length = 0;
  bool logarithmic = false;

  double scaled(double value) const { return logarithmic ? std::log10(value) : value; }

  void hold(double value) {
    if (!std::isfinite(scaled(value))) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }

  double place(double value) const {
    const double range = scaled(high) - scaled(low);
    return range > 0 ? length * (scaled(value) - scaled(low)) / range : length / 2;
  }
};

struct Axes {
  Axis x, y;

  explicit Axes(const Plot& plot) {
    x.logarithmic = y.logarithmic = plot.logarithmic;
    for (const Curve& curve : plot.curves) {
      for (const double value : curve.x) x.hold(value);
      for (const double value : curve.y) y.hold(value);
    }
    x.length = width;
    y.length = height;
    if (plot.same_scale) alike();
  }

  Vec operator()(double right, double up) const { return {x.place(right), y.place(up), 0}; }

 private:
  void alike() {
    const double scale = std::min(width / (x.high - x.low), height / (y.high - y.low));
    if (!std::isfinite(scale)) return;
    x.length = scale * (x.high - x.low);
    y.length = scale * (y.high - y.low);
  }
};

std::size_t longest(const Plot& plot) {
  std::size_t most = 0;
  for (const Curve& curve : plot.curves)
    most = std::max(most, std::min(curve.x.size(), curve.y.size()));
  return most;
}

void draw_axes(Stage& stage, const Axes& axes, const Plot& plot) {
  stage.line({0, 0, 0}, {width, 0, 0}, "scenery");
  stage.line({0, 0, 0}, {0, height, 0}, "scenery");
  stage.label({width / 2, -1.1, 0},
              plot.x_label + ", " + number(axes.x.low, 3) + " to " + number(axes.x.high, 3));
  stage.label({width / 2, height + 0.8, 0},
              plot.y_label + ", " + number(axes.y.low, 3) + " to " + number(axes.y.high, 3));
}

/// The point of a curve that is drawn in this picture, of so many.
Vec point(const Curve& curve, const Axes& axes, std::size_t picture, std::size_t pictures) {
  const std::size_t size = std::min(curve.x.size(), curve.y.size());
  const std::size_t n = pictures < 2 ? size - 1 : picture * (size - 1) / (pictures - 1);
  return axes(curve.x[n], curve.y[n]);
}

}  // namespace

Stage film_of(const Plot& plot) {
  constexpr std::size_t most = 400;
  constexpr double seconds = 5;
  constexpr std::array colours{"yours", "true", "scenery"};
  const Axes axes(plot);
  const std::size_t pictures = std::min(most, longest(plot));
  Stage stage({{-1, -2}, {width + 1, height + 1.6}});
  for (std::size_t picture = 0; picture < pictures; ++picture) {
    stage.picture(seconds / static_cast<double>(pictures));
    draw_axes(stage, axes, plot);
    for (std::size_t n = 0; n < plot.curves.size(); ++n) {
      const Curve& curve = plot.curves[n];
      if (std::min(curve.x.size(), curve.y.size()) == 0) continue;
      const Vec at = point(curve, axes, picture, pictures);
      const char* const colour = colours[std::min(n, colours.size() - 1)];
      stage.trail(curve.name, at, colour);
      stage.ball(curve.name, at, 0.12, colour);
    }
  }
  return stage;
}

}  // namespace grade
