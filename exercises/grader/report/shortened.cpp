// SPDX-License-Identifier: MIT-0
#include "report/shortened.h"

#include <algorithm>
#include <cstdlib>
#include <regex>
#include <vector>

#include "format_values.h"

namespace grade {

namespace {

std::ptrdiff_t significant_digits(const std::string& text) {
  const std::string mantissa = text.substr(0, text.find('e'));
  const auto first = mantissa.find_first_of("123456789");
  return first == mantissa.npos ? 0
                                : std::count_if(mantissa.begin() + std::ptrdiff_t(first),
                                                mantissa.end(), [](char c) { return c != '.'; });
}

// A number with more digits does not look round, such as a little more than one, or less than a
// half.
std::string in_short(double value, int digits) {
  constexpr int all = 17;
  const auto looks_round = [&](const std::string& text) {
    return std::strtod(text.c_str(), nullptr) != value && significant_digits(text) < digits;
  };
  std::string text = number(value, digits);
  while (digits < all && looks_round(text)) text = number(value, ++digits);
  return text;
}

}  // namespace

std::string shortened(const std::string& text, int digits) {
  static const std::regex longer(R"(-?\d+\.\d{5,}(e[-+]?\d+)?)");
  std::string result;
  auto from = text.begin();
  for (std::sregex_iterator found(text.begin(), text.end(), longer), end; found != end; ++found) {
    result.append(from, (*found)[0].first);
    result += in_short(std::strtod(found->str().c_str(), nullptr), digits);
    from = (*found)[0].second;
  }
  return result.append(from, text.end());
}

namespace {

std::vector<std::string> numbers_in(const std::string& text, int digits) {
  static const std::regex any(R"(-?\d+(\.\d+)?(e[-+]?\d+)?)");
  std::vector<std::string> all;
  for (std::sregex_iterator found(text.begin(), text.end(), any), end; found != end; ++found)
    all.push_back(number(std::strtod(found->str().c_str(), nullptr), digits));
  return all;
}

/// Returns whether all numbers of the one text are among those of the other.
bool alike(const std::string& expected, const std::string& got, int digits) {
  const auto came = numbers_in(got, digits);
  return std::ranges::all_of(numbers_in(expected, digits), [&](const std::string& wanted) {
    return std::ranges::find(came, wanted) != came.end();
  });
}

}  // namespace

std::pair<std::string, std::string> told_apart(const std::string& expected,
                                               const std::string& got) {
  constexpr int few = 6, all = 17;
  int digits = few;
  while (digits < all && alike(expected, got, digits) && !alike(expected, got, all)) ++digits;
  return {shortened(expected, digits), shortened(got, digits)};
}

}  // namespace grade
