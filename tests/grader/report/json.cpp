// SPDX-License-Identifier: MIT-0
#include "report/json.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <regex>

#include "sample.h"

using namespace grade;

TEST_CASE("a report comes back from JSON as it was") {
  for (const Report& report : {sample(), Report()}) {
    const std::string json = to_json(report);
    const std::optional<Report> back = report_from(json);
    REQUIRE(back);
    CHECK(to_json(*back) == json);
    CHECK(back->seed == report.seed);
    CHECK(back->verdict == report.verdict);
    CHECK(back->tests.size() == report.tests.size());
  }
}

TEST_CASE("only the times of a report change") {
  Report slow = sample();
  slow.seconds = 99;
  slow.compile_seconds = 50;
  slow.run_seconds = 49;
  const auto constant = [](const std::string& json) {
    return json.substr(0, json.find("volatile"));
  };
  CHECK(to_json(slow) != to_json(sample()));
  CHECK(constant(to_json(slow)) == constant(to_json(sample())));
  CHECK(constant(to_json(slow)).size() > to_json(slow).size() - 120);
}

TEST_CASE("a time that is NaN is null in JSON") {
  Report report = sample();
  report.seconds = std::nan("");
  report.run_seconds = INFINITY;
  const std::string json = to_json(report);
  CHECK(json.find("\"seconds\": null") != std::string::npos);
  CHECK(json.find("\"run_seconds\": null") != std::string::npos);
  CHECK(report_from(json));
}

TEST_CASE("JSON is ASCII without a command, whatever a student wrote") {
  const std::string json = to_json(hostile_sample());
  for (const char c : json) CHECK((c == '\n' || (c >= ' ' && c < 0x7f)));
  CHECK(json.find("##") == std::string::npos);
  CHECK(json.find("\n::") == std::string::npos);
  REQUIRE(report_from(json));
  CHECK(report_from(json)->why.find("##[error]forged") != std::string::npos);
}

TEST_CASE("what is not a whole report cannot be read") {
  const std::string json = to_json(sample());
  for (std::size_t size = 0; size + 2 < json.size(); size += 7) {
    CHECK_FALSE(report_from(json.substr(0, size)));
  }
  for (const char* text : {"null", "[]", "{}", "nan", "{\"seed\": 1}"})
    CHECK_FALSE(report_from(text));
}

TEST_CASE("a report that lacks a member cannot be read") {
  const std::string json = to_json(sample());
  const std::regex member("\n( *)\"(\\w+)\": ");
  int lacking = 0;
  for (std::sregex_iterator found(json.begin(), json.end(), member), end; found != end; ++found) {
    // A picture may be missing, and a test's score follows from the rest.
    const bool of_report = found->length(1) == 2;
    if (found->str(2) == "plot" || (found->str(2) == "score" && !of_report)) continue;
    std::string without = json;
    without.replace(static_cast<std::size_t>(found->position(2)), found->str(2).size(), "other");
    CAPTURE(found->str(2));
    CHECK_FALSE(report_from(without));
    ++lacking;
  }
  CHECK(lacking > 40);
}
