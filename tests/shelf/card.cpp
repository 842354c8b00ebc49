// SPDX-License-Identifier: MIT-0
// What each header of the shelf promises is what its card measured.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include "measure/shelf_card.h"

namespace {

// The sentences of the list in a header's first comment, each as one line.
std::vector<std::string> promises_of(const std::filesystem::path& header) {
  std::ifstream file(header);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  std::vector<std::string> found;
  std::smatch list;
  if (!std::regex_search(text, list,
                         std::regex(R"(/// Promises:\n((?:/// - .*\n(?:///   .*\n)*)+))")))
    return found;
  const std::string lines = list[1];
  const std::regex one(R"(/// - (.*\n(?:///   .*\n)*))");
  for (std::sregex_iterator at(lines.begin(), lines.end(), one), end; at != end; ++at) {
    const std::string folded = std::regex_replace((*at)[1].str(), std::regex("\n(///   )?"), " ");
    found.push_back(folded.substr(0, folded.find_last_not_of(' ') + 1));
  }
  return found;
}

std::vector<std::string> words_of(const measure::ShelfCard& card) {
  std::vector<std::string> words;
  for (const measure::Promise& promise : card.promises) words.push_back(promise.words);
  return words;
}

}  // namespace

TEST_CASE("Every header of the shelf promises something, and just that is measured") {
  const auto cards = measure::every_shelf_card();
  std::size_t headers = 0;
  for (const auto& entry : std::filesystem::directory_iterator(SHELF)) {
    ++headers;
    const std::string name = entry.path().stem();
    INFO("code/shelf/" << name << ".h; its card is made in code/measure/shelf/" << name << ".cpp");
    const auto card = std::find_if(cards.begin(), cards.end(),
                                   [&](const auto& one) { return one.header == name; });
    REQUIRE(card != cards.end());
    const auto promises = promises_of(entry.path());
    CHECK_FALSE(promises.empty());
    CHECK(words_of(*card) == promises);
  }
  CHECK(cards.size() == headers);
}

TEST_CASE("What the headers of the shelf promise is kept") {
  for (const measure::ShelfCard& card : measure::every_shelf_card()) {
    for (const auto& [words, kept, measured, digits, unit] : card.promises) {
      INFO(card.header << ".h: " << words << "; measured: " << measured.words << measured.value);
      CHECK(kept);
    }
  }
}
