// SPDX-License-Identifier: MIT-0
#include "signature.h"

#include <cstddef>
#include <optional>
#include <string_view>

#include "replace_all.h"

namespace grade {

namespace {

/// The text in quotes behind these words.
std::optional<std::string> quoted(const std::string& text, std::string_view before) {
  const std::size_t start = text.find(before);
  if (start == text.npos) return std::nullopt;
  const std::size_t from = start + before.size(), to = text.find('\'', from);
  return to == text.npos ? std::nullopt : std::optional(text.substr(from, to - from));
}

/// The function's name: the last word of the excerpt's first line, `wanted = step;`.
std::string function(const Diagnostic& error) {
  if (error.excerpt.empty()) return {};
  const std::string& line = error.excerpt.front();
  const std::size_t end = line.find(';'), before = line.find_last_of(" =", end);
  return end == line.npos || before == line.npos ? "" : line.substr(before + 1, end - before - 1);
}

/// `void(Vec&)` as one would write it: `void step(Vec&)`.
std::string declaration(std::string type, const std::string& name) {
  for (const char* left_out : {"struct ", "class "}) type = replace_all(type, left_out, "");
  type = replace_all(type, "std::function<Vec(const Vec&, const Vec&, double)>", "Acceleration");
  const std::size_t parameters = type.find('(');
  return parameters == type.npos ? type : type.insert(parameters, " " + name);
}

/// The signature in `const harness::Wanted<void(Vec&)>`.
std::string signature(const std::string& type) {
  constexpr std::string_view before = "harness::Wanted<";
  const std::size_t start = type.find(before), end = type.rfind('>');
  return start == type.npos || end == type.npos
             ? type
             : type.substr(start + before.size(), end - start - before.size());
}

}  // namespace

std::string wanted_and_found(const Diagnostic& error) {
  const std::string name = function(error);
  const auto found = quoted(error.text, "conversion from '");
  auto wanted = quoted(error.text, "to non-scalar type '");
  if (!wanted) wanted = quoted(error.text, " to '");
  if (name.empty() || !found || !wanted) return {};
  const std::string said = "wanted is " + declaration(signature(*wanted), name);
  return found->starts_with('<') ? said : said + ", but found is " + declaration(*found, name);
}

std::string another_form(const Diagnostic& warning) {
  const std::string name = function(warning);
  if (warning.text.find("is deprecated: another form") == std::string::npos || name.empty())
    return {};
  return name +
         " is declared in another way than in the starter, and was called all the same. What it "
         "takes by value does not change outside.\n";
}

}  // namespace grade
