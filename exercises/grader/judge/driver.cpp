// SPDX-License-Identifier: MIT-0
#include "judge/driver.h"

#include <algorithm>
#include <span>

#include "harness/call.h"
#include "judge/driver_ending.h"
#include "judge/ending.h"
#include "judge/numbers.h"
#include "judge/session.h"

namespace judge {
namespace {

cage::Process begun(const Caged& caged) {
  cage::Limits limits = caged.limits;
  limits.wall = std::clamp(caged.longest - session().wall, 0.0, limits.wall);
  return cage::run(caged.sandbox, caged.kit, caged.driver, limits, caged.build, caged.arguments);
}

class Driver : public Program {
 public:
  explicit Driver(const Caged& caged)
      : limits_(caged.limits), process_(new cage::Process(begun(caged))) {}

  ~Driver() override {
    if (process_) note_ending(process_->finish(), after_last_answer, limits_);
  }

  std::vector<double> answer(int function, const std::vector<double>& arguments, std::size_t wanted,
                             const Acceleration& acceleration) override {
    const std::vector<double> request = as_numbers(function, arguments.size(), arguments);
    if (!process_->send(std::as_bytes(std::span(request)))) stop();
    for (;;) {
      const std::vector<double> head = receive(2);
      if (head[0] == harness::result && head[1] == static_cast<double>(wanted)) break;
      if (head[0] != harness::question || head[1] != 7 || !acceleration) {
        process_.reset();
        head[0] == harness::result ? note_other_count(head[1], wanted) : note_protocol_error();
        throw Stopped();
      }
      answer_question(acceleration);
    }
    return receive(wanted);
  }

 private:
  [[noreturn]] void stop() {
    const cage::Ended ended = process_->finish();
    process_.reset();
    note_ending(ended, within_answer, limits_);
    throw Stopped();
  }

  std::vector<double> receive(std::size_t count) {
    std::vector<double> numbers(count);
    if (!process_->receive(std::as_writable_bytes(std::span(numbers)))) stop();
    return numbers;
  }

  void answer_question(const Acceleration& acceleration) {
    const std::vector<double> asked = receive(7);
    const Vec a =
        acceleration({asked[0], asked[1], asked[2]}, {asked[3], asked[4], asked[5]}, asked[6]);
    if (!process_->send(std::as_bytes(std::span(&a, 1)))) stop();
  }

  cage::Limits limits_;
  std::unique_ptr<cage::Process> process_;
};

}  // namespace

std::unique_ptr<Program> begin_driver(const Caged& caged) {
  return std::make_unique<Driver>(caged);
}

}  // namespace judge
