// SPDX-License-Identifier: MIT-0
#include "report/words_as_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "report/words.h"

namespace grade {
namespace {

using Json = nlohmann::ordered_json;

Json numbers(const std::vector<double>& all) {
  Json list = Json::array();
  for (const double number : all) list.push_back(std::isfinite(number) ? Json(number) : Json());
  return list;
}

Json of(const Plot& plot) {
  Json curves = Json::array();
  for (const Curve& curve : plot.curves)
    curves.push_back({{"name", curve.name}, {"x", numbers(curve.x)}, {"y", numbers(curve.y)}});
  return {{"title", plot.title},
          {"x", plot.x_label},
          {"y", plot.y_label},
          {"sameScale", plot.same_scale},
          {"logarithmic", plot.logarithmic},
          {"curves", curves}};
}

Json of(const Finding& finding) {
  Json all{{"lines", Json::array()}};
  for (const auto& [label, text] : lines(finding))
    all["lines"].push_back({{"label", label}, {"text", text}});
  if (has_plot(finding)) all["plot"] = of(finding.plot);
  return all;
}

Json of(const Report& report, const TestResult& test) {
  Json failed;
  if (!test.findings.empty() && !test.findings.back().held) failed = of(test.findings.back());
  return {{"name", test.name},
          {"points", test.points},
          {"outcome", outcome(report, test)},
          {"failed", failed}};
}

}  // namespace

std::string words_as_json(const Report& report) {
  Json tests = Json::array();
  for (const TestResult& test : report.tests) tests.push_back(of(report, test));
  const Json all{{"exercise", report.exercise},
                 {"verdict", name(report.verdict)},
                 {"headline", headline(report)},
                 {"sentence", sentence(report.verdict)},
                 {"why", report.why},
                 {"score", report.score},
                 {"points", report.points},
                 {"tests", tests}};
  return all.dump(-1, ' ', true, Json::error_handler_t::replace);
}

}  // namespace grade
