// SPDX-License-Identifier: MIT-0
// What the first lines over each method promise is what is measured.
#include "measure/card.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

#include "measure/methods.h"
#include "measure/run.h"
#include "scenes/projectile.h"

using measure::Card;
using measure::Cell;

namespace {

struct Promise {
  std::string method;
  std::string words;  // the comment over the function as one line
};

// The functions of a header that move on their first argument, with their comments.
void read_promises(const std::filesystem::path& header, std::vector<Promise>& found) {
  std::ifstream file(header);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::regex function(
      R"(((?:///.*\n)+)template <.*\n(?:.*[ \]])?(\w+)\((?:Position|Vec)& x,)");
  for (std::sregex_iterator at(text.begin(), text.end(), function), end; at != end; ++at) {
    const std::string words = std::regex_replace((*at)[1].str(), std::regex("\\s*///\\s*"), " ");
    found.push_back({(*at)[2], words});
  }
}

std::vector<Promise> every_promise() {
  std::vector<Promise> found;
  for (const auto& entry : std::filesystem::directory_iterator(INTEGRATE_FOLDER)) {
    read_promises(entry.path(), found);
  }
  return found;
}

const std::vector<Card>& cards() {
  static const std::vector<Card> measured = measure::every_card();
  return measured;
}

const Card& card_of(const std::string& method) {
  const auto found = std::find_if(cards().begin(), cards().end(),
                                  [&](const Card& card) { return card.method == method; });
  INFO("looking for a card of " << method);
  REQUIRE(found != cards().end());
  return *found;
}

std::smatch match(const std::string& words, const std::string& pattern) {
  std::smatch found;
  INFO("looking for \"" << pattern << "\"");
  REQUIRE(std::regex_search(words, found, std::regex(pattern)));
  return found;
}

void check_order(const Cell& measured, const std::string& promised) {
  CAPTURE(measured.words, measured.value, promised);
  if (promised.empty()) {
    CHECK(measured.words == "exact");
  } else {
    CHECK(measured.words.empty());
    CHECK(std::abs(measured.value - std::stod(promised)) < 0.1);
  }
}

// "Order 2", "Order 4, 2 under drag", "Order 2 in position, 1 in velocity and under drag"; "Exact
// for any h,", where nothing is promised beside.
void check_orders(const std::string& words, const Card& card) {
  const auto found = match(words,
                           "Exact for any h, |Order (\\d)(?: otherwise)?(?: in position, (\\d) in "
                           "velocity and under drag|, (\\d) under drag)?, ");
  const std::string order = found[1], velocity = found[2].matched ? found[2] : found[1];
  const std::string drag = found[3].matched ? found[3].str() : velocity;
  check_order(card.at("order"), order);
  check_order(card.at("order-velocity"), velocity);
  check_order(card.at("drag-order"), drag);
  check_order(card.at("drag-order-velocity"), drag);
}

std::string written(const Cell& cell) {
  return cell.words.empty() ? std::to_string(std::lround(cell.value)) : cell.words;
}

bool solves_systems(const Card& card) {
  return std::any_of(card.rows.begin(), card.rows.end(),
                     [](const measure::CardRow& row) { return row.name == "solves"; });
}

// "two evaluations of the acceleration and one solve"; with an iteration, as many as it takes.
void check_cost(const std::string& words, const Card& card) {
  const auto found = match(words,
                           "(no|one|two|three|four|six) evaluations? of the acceleration(,? and "
                           "one (more with a )?solve( for each iteration)?)?");
  const std::vector<std::string> counts{"no", "one", "two", "three", "four", "five", "six"};
  const long promised = std::find(counts.begin(), counts.end(), found[1]) - counts.begin();
  const std::string evaluations = written(card.at("evaluations"));
  if (!found[4].matched) {
    CHECK(evaluations == std::to_string(promised));
    CHECK(found[2].matched == solves_systems(card));
    if (found[2].matched) CHECK(written(card.at("solves")) == "1");
    return;
  }
  const std::string solves = written(card.at("solves"));
  const long more = found[3].matched ? 1 : 0;
  CHECK(std::stol(solves) >= 1);
  CHECK(std::stol(evaluations) == std::stol(solves) + more);
  CHECK(std::stol(evaluations.substr(evaluations.rfind(' ') + 1)) ==
        std::stol(solves.substr(solves.rfind(' ') + 1)) + more);
}

// A limit is given as it is, or with its first digits; never more than there is.
void check_limit(const Cell& measured, const std::string& promised) {
  CAPTURE(measured.words, measured.value, promised);
  const auto point = promised.find('.');
  const double limit = std::stod(promised), rounding = 1e-6;
  const double unit =
      point == promised.npos ? rounding : std::pow(0.1, double(promised.size() - point - 1));
  CHECK(measured.words.empty());
  CHECK(limit < measured.value + rounding);
  CHECK(limit > measured.value - unit);
}

void check_stability(const std::string& words, const std::string& scene, const Cell& measured) {
  const auto found = match(words, scene +
                                      " (?:while [a-z]*\\*[a-z]* < ([0-9.]*[0-9])|(for every h))"
                                      "|(never) " +
                                      scene);
  CAPTURE(scene, measured.words);
  if (found[1].matched) {
    check_limit(measured, found[1]);
  } else {
    CHECK(measured.words == (found[2].matched ? "any step" : "never"));
  }
}

}  // namespace

TEST_CASE("Every function that moves x on has a card, and every card such a function") {
  std::set<std::string> promised, measured;
  for (const Promise& promise : every_promise()) promised.insert(promise.method);
  for (const Card& card : cards()) measured.insert(card.method);
  CHECK(promised == measured);
  CHECK(promised.size() > 25);
}

TEST_CASE("What the first lines over every method promise is what is measured") {
  for (const auto& [method, words] : every_promise()) {
    if (method == "dopri5_adaptive") continue;  // takes steps of dopri5 and promises an error
    DYNAMIC_SECTION(method) {
      const Card card = card_of(method);
      check_orders(words, card);
      check_cost(words, card);
      check_stability(words, "on drag", card.at("drag-limit"));
      check_stability(words, "on an undamped spring", card.at("spring-limit"));
    }
  }
}

TEST_CASE("Euler's first lines are right about damped springs") {
  const Card card = card_of("euler");
  const auto words = every_promise();
  const auto euler = std::find_if(words.begin(), words.end(),
                                  [](const Promise& promise) { return promise.method == "euler"; });
  REQUIRE(euler != words.end());
  match(euler->words,
        "h\\*omega < 2\\*zeta \\(zeta <= 1\\) or 2\\*\\(zeta - sqrt\\(zeta\\^2 - 1\\)\\)");
  check_limit(card.at("spring-limit-0.1"), "0.2");
  check_limit(card.at("spring-limit-0.5"), "1");
  check_limit(card.at("spring-limit-1"), "2");
  CHECK(std::abs(card.at("spring-limit-2").value - 2 * (2 - std::sqrt(3))) < 1e-6);
}

TEST_CASE("Predicted Euler's first lines are right about more corrections") {
  const auto words = every_promise();
  const auto predicted = std::find_if(words.begin(), words.end(), [](const Promise& promise) {
    return promise.method == "predicted_euler";
  });
  REQUIRE(predicted != words.end());
  const auto found = match(predicted->words,
                           "with two the limits are ([0-9.]+) and ([0-9.]+), with three 1 again");
  const Card card = card_of("predicted_euler");
  check_limit(card.at("corrections-2-drag"), found[1]);
  check_limit(card.at("corrections-2-spring"), found[2]);
  check_limit(card.at("corrections-3-drag"), "1");
  check_limit(card.at("corrections-3-spring"), "1");
}

TEST_CASE("The step of a constant acceleration is exact for any h, as its first lines say") {
  const scenes::Projectile<> ball;
  for (const double h : {0.01, 7.0}) {
    const auto end = measure::after(measure::constant_acceleration, ball, ball.start(), h, 1);
    CHECK((end.x - ball.exact(h).x).norm() < 1e-13 * ball.exact(h).x.norm());
  }
}
