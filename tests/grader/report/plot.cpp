// SPDX-License-Identifier: MIT-0
#include "report/plot.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cstdlib>

#include "report/curve.h"
#include "sample.h"

using namespace grade;

namespace {

Plot plot() {
  return failed_finding().plot;
}

double width(const Box& box) {
  return box.right - box.left;
}

}  // namespace

TEST_CASE("a plot is the same each time, and its lines differ without colour") {
  const std::optional<std::string> first = svg(plot());
  REQUIRE(first);
  CHECK(first == svg(plot()));
  CHECK(has(*first, "<title>Five steps</title>"));
  CHECK(has(*first, "stroke-dasharray"));
  CHECK(has(*first, "x [m]"));
  CHECK(has(*first, "yours"));
}

TEST_CASE("a plot of a long run stays below 30 kB") {
  Plot long_run = plot();
  long_run.curves.clear();
  for (const char* name : {"yours", "a", "b", "c"}) {
    long_run.curves.push_back(curve(name, 1e-4, 100'000));
  }
  const std::optional<std::string> picture = svg(long_run);
  REQUIRE(picture);
  CHECK(picture->size() < 30'000);
}

TEST_CASE("points that are not finite are left out of a plot") {
  Plot broken = plot();
  for (std::size_t i = 50; i < 200; ++i) broken.curves[0].y[i] = i % 2 ? NAN : INFINITY;
  CHECK(finite(broken.curves[0]).x.size() == 50);
  CHECK(svg(broken));
  for (double& y : broken.curves[0].y) y = NAN;
  CHECK(has(svg(broken).value(), "yours (no finite point)"));
  broken.curves.pop_back();
  CHECK_FALSE(svg(broken));
}

TEST_CASE("a run that explodes does not hide the right one") {
  const std::vector<Curve> curves{curve("yours", 10, 200), curve("right", 0, 200)};
  const std::optional<Box> box = view(curves);
  REQUIRE(box);
  CHECK(width(*box) < 4 * 2);  // the circle's diameter and as much on either side
  CHECK(leaves(curves[0], *box));
  CHECK_FALSE(leaves(curves[1], *box));
  Plot exploded = plot();
  exploded.curves = curves;
  exploded.curves[0].x.back() = 1e308;
  CHECK(has(svg(exploded).value(), "yours (leaves the picture)"));
}

TEST_CASE("a curve keeps its extremes when it is thinned") {
  Curve long_curve = curve("yours", 0, 10'000);
  long_curve.y[4321] = 7;
  const Curve thin = thinned(long_curve, 100);
  CHECK(thin.x.size() <= 102);
  CHECK(std::ranges::find(thin.y, 7.0) != thin.y.end());
  CHECK(thin.x.front() == long_curve.x.front());
  CHECK(thin.x.back() == long_curve.x.back());
}

TEST_CASE("a logarithmic plot leaves out what has no logarithm") {
  Plot errors{"Error and step",
              "step [s]",
              "error [m]",
              {{"yours", {0, 1e-3, 1e-2, 1e-1}, {1, 1e-6, 1e-4, -1}},
               {"order 2", {1e-3, 1e-1}, {1e-6, 1e-2}}}};
  errors.logarithmic = true;
  CHECK(logarithm(errors.curves[0]).x.size() == 2);
  CHECK(has(svg(errors).value(), "1e"));
}

TEST_CASE("a plot's words cannot run commands of gnuplot") {
  Plot forged = plot();
  forged.title = "'; system 'touch forged'; `touch forged` \\\n print 1";
  CHECK(has(svg(forged).value(), "touch forged"));
  CHECK_FALSE(std::filesystem::exists("forged"));
}

TEST_CASE("without gnuplot there is no plot") {
  const std::string path = std::getenv("PATH");
  setenv("PATH", "/nonexistent", 1);
  CHECK_FALSE(svg(plot()));
  setenv("PATH", path.c_str(), 1);
  CHECK(svg(plot()));
}
