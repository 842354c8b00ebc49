// SPDX-License-Identifier: MIT-0
#include "report/plot.h"

#include <algorithm>
#include <system_error>

#include "report/curve.h"
#include "report/escape.h"
#include "report/files.h"
#include "report/gnuplot.h"
#include "report/plot_script.h"
#include "report/words.h"

namespace grade {
namespace {

/// Points in all curves together: about 25 bytes each, so that a picture stays below 30 kB.
constexpr std::size_t most_points = 800;

void replace(std::string& text, std::string_view what, std::string_view by) {
  if (const std::size_t at = text.find(what); at != std::string::npos) {
    text.replace(at, what.size(), by);
  }
}

std::vector<Curve> drawable(const Plot& plot) {
  std::vector<Curve> curves;
  for (const Curve& curve : plot.curves) {
    const Curve whole = plot.logarithmic ? logarithm(curve) : finite(curve);
    curves.push_back(thinned(whole, most_points / plot.curves.size()));
  }
  return curves;
}

}  // namespace

bool can_be_drawn(const Plot& plot) {
  const std::vector<Curve> curves = drawable(plot);
  return !curves.empty() && view(curves);
}

std::string_view why_no_picture(const Plot& plot) {
  return can_be_drawn(plot) ? "gnuplot could not draw it, or is not installed here"
                            : "there is no finite number to draw";
}

std::optional<std::string> svg(const Plot& plot) {
  const std::vector<Curve> curves = drawable(plot);
  if (curves.empty()) return std::nullopt;
  const std::optional<Box> box = view(curves);
  if (!box) return std::nullopt;
  std::optional<std::string> picture = gnuplot(plot_script(plot, curves, *box));
  if (!picture || !picture->ends_with("</svg>\n\n")) return std::nullopt;
  replace(*picture, "<title>Gnuplot</title>", "<title>" + html(plot.title) + "</title>");
  return picture;
}

std::vector<std::filesystem::path> plots_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> found;
  if (no_folder(folder / "plots")) return found;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "plots", none)) {
    const std::string file = entry.path().filename().string();
    if (file.starts_with("test-") && file.ends_with(".svg")) found.push_back(entry.path());
  }
  return found;
}

void draw(Report& report, const std::filesystem::path& folder) {
  for (const auto& old : plots_in(folder)) std::filesystem::remove(old);
  for (std::size_t i = 0; i < report.tests.size(); ++i) {
    for (Finding& finding : report.tests[i].findings) {
      if (finding.held || !has_plot(finding)) continue;
      const std::optional<std::string> picture = svg(finding.plot);
      if (!picture) continue;
      const std::string file = "plots/test-" + std::to_string(i + 1) + ".svg";
      if (no_folder(folder / "plots")) throw NotOwn(folder / "plots");
      std::filesystem::create_directory(folder / "plots");
      write_whole(folder / file, *picture);
      finding.plot.file = file;
    }
  }
}

}  // namespace grade
