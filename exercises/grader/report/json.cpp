// SPDX-License-Identifier: MIT-0
#include "report/json.h"

#include <charconv>
#include <concepts>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>
#include <type_traits>

#include "report/words.h"

namespace grade {
namespace {

using Json = nlohmann::ordered_json;

std::uint64_t number_of(const std::string& digits) {
  std::uint64_t number = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stopped, problem] = std::from_chars(digits.data(), end, number);
  if (problem != std::errc() || stopped != end) throw std::invalid_argument("not a number");
  return number;
}

cage::Sandbox sandbox_named(const std::string& word) {
  for (const auto sandbox : {cage::Sandbox::bubblewrap, cage::Sandbox::none}) {
    if (name(sandbox) == word) return sandbox;
  }
  throw std::invalid_argument("not a sandbox");
}

/// Writes what fields() shows it.
struct Write {
  Json& all;
  void operator()(const char* name, const auto& value) const { all[name] = value; }
  void operator()(const char* name, Verdict value) const { all[name] = grade::name(value); }
  void operator()(const char* name, cage::Sandbox value) const { all[name] = grade::name(value); }
  /// A number as text, since a program may read a number of JSON with fewer digits.
  void operator()(const char* name, std::uint64_t value) const {
    all[name] = std::to_string(value);
  }
  void always(const char* name, const auto& value) const { all[name] = value; }
  void derived(const char* name, const auto& value) const { all[name] = value; }
  void if_graded(bool graded, const char* name, int value) const {
    all[name] = graded ? Json(value) : Json(nullptr);
  }
  void block(const char* name, auto fill) const { fill(Write{all[name]}); }
  void block_if(bool there, const char* name, auto fill) const {
    if (there) block(name, fill);
  }
};

/// Reads it back. Throws where something is missing or of another kind.
struct Read {
  const Json& all;
  void operator()(const char* name, auto& value) const { all.at(name).get_to(value); }
  void operator()(const char* name, Verdict& value) const {
    value = verdict_named(all.at(name).get<std::string>()).value();
  }
  void operator()(const char* name, cage::Sandbox& value) const {
    value = sandbox_named(all.at(name));
  }
  void operator()(const char* name, std::uint64_t& value) const { value = number_of(all.at(name)); }
  /// One that is not finite stands in JSON as null.
  void operator()(const char* name, double& value) const {
    value = all.at(name).is_null() ? 0 : all.at(name).get<double>();
  }
  void always(const char* name, const auto& value) const {
    if (all.at(name) != value) throw std::invalid_argument(name);
  }
  void derived(const char*, const auto&) const {}
  void if_graded(bool, const char* name, int& value) const {
    value = all.at(name).is_null() ? 0 : all.at(name).get<int>();
  }
  void block(const char* name, auto fill) const { fill(Read{all.at(name)}); }
  void block_if(bool, const char* name, auto fill) const {
    if (all.contains(name)) block(name, fill);
  }
};

template <class T, class Of>
concept Is = std::same_as<std::remove_cvref_t<T>, Of>;

// Each field once, in the order in which they are written.
void fields(Is<Finding> auto& finding, auto field) {
  field("held", finding.held);
  field("asked", finding.asked);
  field("input", finding.input);
  field("expected", finding.expected);
  field("got", finding.got);
  field("error", finding.error);
  field("tolerance", finding.tolerance);
  field("tolerance_from", finding.tolerance_from);
  field("hint", finding.hint);
  field("diagnoses", finding.diagnoses);
  field.block_if(!finding.plot.file.empty(), "plot", [&](auto plot) {
    plot("file", finding.plot.file);
    plot("title", finding.plot.title);
  });
}

void fields(Is<TestResult> auto& test, auto field) {
  field("name", test.name);
  field("points", test.points);
  field.derived("score", earned(test));
  field("ran", test.ran);
  field("held", test.held);
  field("findings", test.findings);
}

void fields(Is<Report> auto& report, auto field) {
  field.always("schema", report_schema);
  field("exercise", report.exercise);
  field("grader", report.version);
  field("submission", report.submission);
  field("sha256", report.sha256);
  field("seed", report.seed);
  field("sandbox", report.sandbox);
  field("verdict", report.verdict);
  field.if_graded(is_graded(report), "score", report.score);
  field("points", report.points);
  field("why", report.why);
  field("warnings", report.warnings);
  field("memory", report.memory);
  field("ignored", report.ignored);
  field("unreadable", report.unreadable);
  field("try_again", report.try_again);
  field("tests", report.tests);
  field.block("volatile", [&](auto times) {
    times("seconds", report.seconds);
    times("compile_seconds", report.compile_seconds);
    times("run_seconds", report.run_seconds);
  });
}

/// GitHub takes `##[` for a command even in the middle of a line of JSON.
std::string without_commands(std::string text) {
  for (std::size_t at = 0; (at = text.find("##", at)) != std::string::npos;) {
    text.replace(at, 2, "#\\u0023");
  }
  return text;
}

}  // namespace

// By these names the library finds what a list consists of.
static void to_json(Json& all, const Finding& finding) {
  fields(finding, Write{all});
}
static void to_json(Json& all, const TestResult& test) {
  fields(test, Write{all});
}
static void from_json(const Json& all, Finding& finding) {
  fields(finding, Read{all});
}
static void from_json(const Json& all, TestResult& test) {
  fields(test, Read{all});
}

std::string to_json(const Report& report) {
  constexpr int indent = 2;
  constexpr bool ascii = true;
  Json all;
  fields(report, Write{all});
  return without_commands(all.dump(indent, ' ', ascii, Json::error_handler_t::replace)) + "\n";
}

std::optional<Report> report_from(std::string_view text) {
  try {
    const Json all = Json::parse(text);
    Report report;
    fields(report, Read{all});
    return report;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace grade
