// SPDX-License-Identifier: MIT-0
#include "judge/student.h"

#include <utility>

#include "judge/ending.h"
#include "judge/numbers.h"
#include "judge/session.h"

namespace judge {
namespace {

std::vector<double> request(const harness::Force& force, const Start& start, double h, int steps,
                            int every) {
  return as_numbers(force, start.x, start.v, start.t, h, steps, every);
}

Path as_path(const Start& start, double h, int every, const std::vector<double>& numbers) {
  Path path{start.t, h, every, as_states(numbers), {}};
  path.states.insert(path.states.begin(), State{start.x, start.v});
  return path;
}

// To be held beside the known wrong ways; what is as long as a film is not gone through again.
void keep(std::size_t program, const Exchange& exchange) {
  if (!session().remembers) return;
  constexpr std::size_t longest = 100'000;
  const bool brief = exchange.arguments.size() + exchange.answer.size() < longest;
  if (brief) session().programs.at(program).push_back(exchange);
}

}  // namespace

Student::Student() {
  if (session().stopped()) throw Stopped();
  program_ = session().begin();
  place_ = session().programs.size();
  session().programs.emplace_back();
}

std::vector<double> Student::call(int function, const std::vector<double>& arguments,
                                  std::size_t wanted) {
  if (session().stopped()) throw Stopped();
  evaluations_.clear();
  Acceleration watched;
  if (acceleration_)
    watched = [this](const Vec& x, const Vec& v, double t) {
      evaluations_.push_back({x, v, t});
      return evaluations_.back().a = acceleration_(x, v, t);
    };
  std::vector<double> answer = program_->answer(function, arguments, wanted, watched);
  if (answer.size() != wanted) {
    note_other_count(static_cast<double>(answer.size()), wanted);
    throw Stopped();
  }
  keep(place_, {function, arguments, evaluations_, answer});
  return answer;
}

Path Student::watch(const Start& start, double h, int steps, const Acceleration& acceleration,
                    int function) {
  acceleration_ = acceleration;
  const auto wanted = static_cast<std::size_t>(6 * steps);
  Path path = as_path(start, h, 1, call(function, request({}, start, h, steps, 1), wanted));
  path.evaluations = std::move(evaluations_);
  return path;
}

Path Student::run(const Start& start, double h, int steps, int every, const harness::Force& force,
                  int function) {
  const auto wanted = static_cast<std::size_t>(6 * (steps / every));
  return as_path(start, h, every, call(function, request(force, start, h, steps, every), wanted));
}

}  // namespace judge
