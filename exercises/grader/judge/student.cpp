// SPDX-License-Identifier: MIT-0
#include "judge/student.h"

#include <span>
#include <string>

#include "harness/call.h"
#include "judge/answering.h"
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
void note(std::size_t program, const Exchange& exchange) {
  constexpr std::size_t longest = 100'000;
  const bool brief = exchange.arguments.size() + exchange.answer.size() < longest;
  if (brief) session().programs.at(program).push_back(exchange);
}

}  // namespace

Student::Student() {
  if (session().stopped()) throw Stopped();
  if (!session().called) process_ = start_driver();
  program_ = session().programs.size();
  session().programs.emplace_back();
}

Student::~Student() {
  if (!process_) return;
  const cage::Ended ended = process_->finish();
  note_ending(ended, after_last_answer);
}

void Student::stop() {
  const cage::Ended ended = process_->finish();
  process_.reset();
  note_ending(ended, within_answer);
  throw Stopped();
}

std::vector<double> Student::receive(std::size_t count) {
  std::vector<double> numbers(count);
  if (!process_->receive(std::as_writable_bytes(std::span(numbers)))) stop();
  return numbers;
}

Vec Student::evaluate(const Vec& x, const Vec& v, double t) {
  evaluations_.push_back({x, v, t});
  const Vec a = acceleration_(x, v, t);
  evaluations_.back().a = a;
  return a;
}

void Student::answer_question() {
  const std::vector<double> asked = receive(7);
  const Vec a = evaluate({asked[0], asked[1], asked[2]}, {asked[3], asked[4], asked[5]}, asked[6]);
  if (!process_->send(std::as_bytes(std::span(&a, 1)))) stop();
}

// What it throws ends this process, as it would end a driver.
std::vector<double> Student::call_here(int function,
                                       const std::vector<double>& arguments) noexcept {
  const Answering answering(
      [this](const Vec& x, const Vec& v, double t) { return evaluate(x, v, t); });
  harness::Call call(function, arguments);
  session().called(call);
  return call.answer();
}

std::vector<double> Student::ask_driver(int function, const std::vector<double>& arguments,
                                        std::size_t wanted) {
  const std::vector<double> request = as_numbers(function, arguments.size(), arguments);
  if (!process_->send(std::as_bytes(std::span(request)))) stop();
  for (;;) {
    const std::vector<double> head = receive(2);
    if (head[0] == harness::result && head[1] == static_cast<double>(wanted)) break;
    if (head[0] != harness::question || head[1] != 7 || !acceleration_) {
      process_.reset();
      head[0] == harness::result ? note_other_count(head[1], wanted) : note_protocol_error();
      throw Stopped();
    }
    answer_question();
  }
  return receive(wanted);
}

std::vector<double> Student::call(int function, const std::vector<double>& arguments,
                                  std::size_t wanted) {
  if (session().stopped()) throw Stopped();
  evaluations_.clear();
  std::vector<double> answer =
      process_ ? ask_driver(function, arguments, wanted) : call_here(function, arguments);
  if (answer.size() != wanted) {
    note_other_count(static_cast<double>(answer.size()), wanted);
    throw Stopped();
  }
  note(program_, {function, arguments, evaluations_, answer});
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
