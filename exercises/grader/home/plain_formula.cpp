// SPDX-License-Identifier: MIT-0
#include "home/plain_formula.h"

#include <regex>
#include <utility>

#include "replace_all.h"

namespace grade {
namespace {

constexpr std::pair<const char*, const char*> letters[] = {
    {"\\omega", "ω"}, {"\\lambda", "λ"}, {"\\zeta", "ζ"}, {"\\alpha", "α"}, {"\\theta", "θ"},
    {"\\cdot", "·"},  {"\\det", "det"},  {"\\le", "≤"},   {"\\,", " "},
};

}  // namespace

std::string plain_formulas(std::string text) {
  text = std::regex_replace(text, std::regex(R"(\\f\$ ?(.*?) ?\\f\$)"), "$1");
  text = std::regex_replace(text, std::regex(R"(\\eqref\{[^}]*\})"), "the chapter's formula");
  text = std::regex_replace(text, std::regex(R"(\\(mathrm|text)\{([^}]*)\})"), "$2");
  text = std::regex_replace(text, std::regex(R"(\\mathbf +)"), "");
  text = std::regex_replace(text, std::regex(R"(\\tfrac(\d)(\d))"), "$1/$2");
  text = std::regex_replace(text, std::regex(R"(\{([^{}])\})"), "$1");
  text = std::regex_replace(text, std::regex(R"(\{([^{}]*)\})"), "($1)");
  for (const auto& [command, letter] : letters) text = replace_all(text, command, letter);
  return text;
}

}  // namespace grade
