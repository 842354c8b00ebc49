// SPDX-License-Identifier: MIT-0
#include "judge/known.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <utility>

#include "judge/answering.h"
#include "judge/attempt.h"
#include "judge/diagnose.h"
#include "judge/in_a_process.h"

namespace judge {
namespace {

using Answer = void (*)(harness::Call& call);

struct Ways {
  Answer right = nullptr;
  std::vector<Known::Way> wrong;
};

std::map<std::string, Ways>& all() {
  static std::map<std::string, Ways> all;
  return all;
}

constexpr double rounding_aside = 1e-10;  // ten digits

// The distance of two numbers as a share of their size; NaN is alike too, in the same place.
double apart(double one, double other, double size) {
  if (one == other || (std::isnan(one) && std::isnan(other))) return 0;
  const double share = std::abs(one - other) / size;
  return std::isnan(share) ? INFINITY : share;
}

double size_of(const Evaluation& asked) {
  return length(asked.x) + length(asked.v) + std::abs(asked.t);
}

// NaN is alike in a question: its answer will tell.
bool alike(const Evaluation& one, const Evaluation& other) {
  const double most = rounding_aside * size_of(one);
  return !(length(one.x - other.x) > most) && !(length(one.v - other.v) > most) &&
         !(std::abs(one.t - other.t) > most);
}

// Thrown where a way no longer does as the student did.
struct Differs {};

double apart(const Exchange& exchange, const std::vector<double>& answer) {
  if (answer.size() != exchange.answer.size()) return INFINITY;
  double size = 0, largest = 0;
  for (const double number : exchange.answer)
    if (std::isfinite(number)) size = std::max(size, std::abs(number));
  for (std::size_t n = 0; n < answer.size(); ++n)
    largest = std::max(largest, apart(answer[n], exchange.answer[n], size));
  return largest;
}

// The answer of a way that is told what the student was told; nothing if it asks elsewhere or less,
// or throws where the student's answer came.
std::vector<double> answer_of(Answer way, const Exchange& exchange) {
  auto next = exchange.evaluations.begin();
  const Answering answering([&](const Vec& x, const Vec& v, double t) {
    if (next == exchange.evaluations.end() || !alike(*next, {x, v, t})) throw Differs();
    return next++->a;
  });
  harness::Call call(exchange.function, exchange.arguments);
  if (!attempt([&] { way(call); })) return {};
  if (next != exchange.evaluations.end()) return {};
  return call.answer();
}

// The distance of a way's answer from the student's; infinite if it has none.
double apart(Answer way, const Exchange& exchange) {
  const std::vector<double> answer = answer_of(way, exchange);
  return apart(exchange, answer);
}

// The largest distance from one of the exchanges on, in their order: a harness may keep what one
// call gives it for the next. No further than to what is too far.
double apart(Answer way, std::span<const Exchange> exchanges, double too_far) {
  double largest = 0;
  for (const Exchange& exchange : exchanges) {
    largest = std::max(largest, apart(way, exchange));
    if (largest > too_far) return INFINITY;
  }
  return largest;
}

double apart_alone(Answer way, std::span<const Exchange> exchanges, double too_far = INFINITY) {
  return in_a_process([&] { return apart(way, exchanges, too_far); });
}

// The largest distances of all these ways, each program anew.
std::vector<double> apart_alone(const std::vector<Answer>& ways, const Programs& programs,
                                double too_far) {
  std::vector<double> largest(ways.size(), 0.0);
  for (const auto& exchanges : programs) {
    const std::vector<double> now = in_a_process(ways.size(), [&](std::size_t n) {
      return largest[n] > too_far ? INFINITY : apart(ways[n], exchanges, too_far);
    });
    for (std::size_t n = 0; n < ways.size(); ++n) largest[n] = std::max(largest[n], now[n]);
  }
  return largest;
}

// Returns whether the student's numbers are those of a way, but for what a float loses of each.
bool is_of_floats(Answer way, const Programs& programs) {
  const auto compare = [&] {
    bool some = false;
    for (const auto& exchanges : programs) {
      for (const Exchange& exchange : exchanges) {
        const std::vector<double> answer = answer_of(way, exchange);
        if (answer.size() != exchange.answer.size()) return 0.0;
        for (std::size_t n = 0; n < answer.size(); ++n) {
          const double off = std::abs(exchange.answer[n] - answer[n]) / std::abs(answer[n]);
          if (off > 2e-6) return 0.0;
          some = some || like_a_float(off);
        }
      }
    }
    return some ? 1.0 : 0.0;
  };
  return in_a_process(compare) == 1;
}

// The number of exchanges before the first that is wrong.
std::size_t count_right(Answer right, std::span<const Exchange> exchanges) {
  const double count = in_a_process([&] {
    double before = 0;
    for (const Exchange& exchange : exchanges) {
      if (!(apart(right, exchange) <= rounding_aside)) break;
      ++before;
    }
    return before;
  });
  return std::isfinite(count) ? static_cast<std::size_t>(count) : exchanges.size();
}

// The sentences of the ways that are as near as any, but for rounding; each once.
std::vector<std::string> nearest_of(const std::vector<std::pair<double, const char*>>& ways) {
  constexpr double rounding = 1e-13;
  std::vector<std::string> says;
  if (ways.empty()) return says;
  const double most = std::max(rounding, 10 * std::ranges::min(ways).first);
  for (const auto& [apart, sentence] : ways)
    if (apart <= most && std::ranges::find(says, sentence) == says.end())
      says.emplace_back(sentence);
  return says;
}

// Where three or more answer alike, nobody knows.
std::vector<std::string> together(const std::vector<std::string>& says) {
  if (says.size() < 2) return says;
  if (says.size() > 2) return {};
  return {"either " + says[0] + ", or " + says[1]};
}

}  // namespace

Known::Known(const char* exercise, void (*right)(harness::Call& call), std::vector<Way> wrong) {
  all()[exercise] = {right, std::move(wrong)};
}

void (*Known::solution(const std::string& exercise))(harness::Call& call) {
  const auto known = all().find(exercise);
  return known == all().end() ? nullptr : known->second.right;
}

std::vector<std::string> Known::recognised(const std::string& exercise, const Programs& programs) {
  const auto found = all().find(exercise);
  if (found == all().end()) return {};
  const auto& [right, wrong] = found->second;
  const double off = apart_alone({right}, programs, INFINITY)[0];
  if (off == 0) return {};
  // Answers as near to the right ones as to those of a wrong way are not recognised.
  const double near = std::min(rounding_aside, off / 10);
  std::vector<Answer> ways;
  for (const Known::Way& way : wrong) ways.push_back(way.answer);
  const std::vector<double> all_apart = apart_alone(ways, programs, near);
  std::vector<std::pair<double, const char*>> found_near;
  for (std::size_t n = 0; n < wrong.size(); ++n)
    if (all_apart[n] <= near) found_near.emplace_back(all_apart[n], wrong[n].says);
  const std::vector<std::string> says = nearest_of(found_near);
  if (says.empty() && is_of_floats(right, programs))
    return {"right to seven digits and no further: a float, or a constant with an f?"};
  return together(says);
}

const Exchange* Known::first_wrong(const std::string& exercise, const Programs& programs) {
  const auto found = all().find(exercise);
  if (found == all().end()) return nullptr;
  const Answer right = found->second.right;
  for (const auto& exchanges : programs) {
    const std::size_t n = count_right(right, exchanges);
    if (n == exchanges.size()) continue;
    const std::span all_of_them(exchanges);
    const double off = apart_alone(right, all_of_them.subspan(n, 1));
    return off == apart_alone(right, all_of_them.first(n + 1)) ? &exchanges[n] : nullptr;
  }
  return nullptr;
}

bool Known::is_right(const std::string& exercise, const Exchange& exchange) {
  return apart_alone(all().at(exercise).right, std::span(&exchange, 1)) <= rounding_aside;
}

}  // namespace judge
