// SPDX-License-Identifier: MIT-0
#include "report/plot_script.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "printable.h"

namespace grade {
namespace {

/// Up to as many, each point of a curve is marked.
constexpr std::size_t most_marks = 40;

constexpr const char* looks =
    "set terminal svg size 600,420 fixed noenhanced rounded background rgb 'white' font "
    "'Inter,system-ui,sans-serif,14'\n"
    "set encoding utf8\n"
    "set minussign\n"
    "set border 3 lw 1 lc rgb '#635f58'\n"
    "set tics out nomirror scale 0.6,0.3\n"
    "set grid back lc rgb '#e6e1d6' lw 1\n"
    "set key at graph 0,1.02 left bottom vertical maxcols 1 Left reverse samplen 3\n";

/// Each with another dash, for those who don't see the colours. The first is the student's.
constexpr std::array styles{"lc rgb '#c8420a' lw 2.2 pt 7 ps 0.5",
                            "lc rgb '#22211f' lw 1.6 dt (7,5) pt 6 ps 0.6",
                            "lc rgb '#0b63b0' lw 1.6 dt (2,3) pt 4 ps 0.6",
                            "lc rgb '#00784f' lw 1.6 dt (12,4,2,4) pt 8 ps 0.7"};

/// A text for gnuplot: what it would take for more than a letter is given as a number.
std::string in_quotes(std::string_view text) {
  std::string result = "\"";
  for (const char c : printable_name(text)) {
    switch (c) {
      case '"':
        result += "\\042";
        break;
      case '\\':
        result += "\\134";
        break;
      case '`':
        result += "\\140";
        break;
      default:
        result += c;
    }
  }
  return result + "\"";
}

std::string for_gnuplot(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

/// The labels of axes in powers of ten, which are the numbers themselves.
std::string for_gnuplot(double value, const Plot& plot) {
  return for_gnuplot(plot.logarithmic ? std::pow(10, value) : value);
}

std::string range(const char* axis, double low, double high, const Plot& plot) {
  if (!(low < high)) return "";
  return std::string("set ") + axis + "range [" + for_gnuplot(low, plot) + ":" +
         for_gnuplot(high, plot) + "]\n";
}

/// Points within reach: one that lies far outside is as good as at a thousand times the view's
/// width, where gnuplot's own arithmetic still holds.
double clamped(double value, double low, double high) {
  constexpr double far = 1000;
  const double width = std::max(high - low, std::abs(high) + std::abs(low));
  return std::clamp(value, low - far * width, high + far * width);
}

std::string block(std::size_t index, const Curve& curve, const Box& box, const Plot& plot) {
  std::string text = "$curve" + std::to_string(index) + " << end\n";
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    text += for_gnuplot(clamped(curve.x[i], box.left, box.right), plot) + " " +
            for_gnuplot(clamped(curve.y[i], box.bottom, box.top), plot) + "\n";
  }
  return text + "end\n";
}

std::string key(const Curve& curve, const Box& box) {
  if (curve.x.empty()) return curve.name + " (no finite point)";
  return leaves(curve, box) ? curve.name + " (leaves the picture)" : curve.name;
}

std::string drawn(std::size_t index, const Curve& curve, const Box& box) {
  const std::string source = curve.x.empty() ? "1/0" : "$curve" + std::to_string(index);
  const std::string kind = curve.x.size() <= most_marks ? " with linespoints " : " with lines ";
  return source + (curve.x.empty() ? " with lines " : kind) + styles[index % styles.size()] +
         " title " + in_quotes(key(curve, box));
}

}  // namespace

std::string plot_script(const Plot& plot, const std::vector<Curve>& curves, const Box& box) {
  std::string text = looks;
  // The key has a line for each curve, since gnuplot cuts what does not fit beside another, and the
  // title stands above it.
  const double lines = static_cast<double>(curves.size());
  text += "set tmargin " + for_gnuplot(3 + lines) + "\n";
  text += "set title " + in_quotes(plot.title) + " offset 0," + for_gnuplot(0.8 * lines) + "\n";
  text +=
      "set xlabel " + in_quotes(plot.x_label) + "\nset ylabel " + in_quotes(plot.y_label) + "\n";
  if (plot.same_scale) text += "set size ratio -1\n";
  if (plot.logarithmic) text += "set logscale xy\nset format '%.0e'\n";
  text += range("x", box.left, box.right, plot) + range("y", box.bottom, box.top, plot);
  std::string plots;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (!curves[i].x.empty()) text += block(i, curves[i], box, plot);
    plots += (i == 0 ? "plot " : ", ") + drawn(i, curves[i], box);
  }
  return text + plots + "\n";
}

}  // namespace grade
