// SPDX-License-Identifier: MIT-0
/// @file
/// One request of the judge, as an exercise's harness.h sees it.
#ifndef CALL_H
#define CALL_H
#include <initializer_list>
#include <vector>

#include "force.h"
#include "given.h"
#include "wanted.h"

namespace harness {

// Numbers on the pipe: a tag, how many follow, and these.
inline constexpr double question = 1, result = 2;

/// The acceleration there, as the judge says it.
Vec ask(const Vec& x, const Vec& v, double t);

class Call {
 public:
  Call(int function, std::vector<double> arguments)
      : function_(function), arguments_(std::move(arguments)) {}

  /// The number of the exercise's function that is meant, counted from 0.
  int function() const { return function_; }

  /// The next argument.
  double number() { return arguments_.at(next_++); }
  int whole_number() { return static_cast<int>(number()); }
  Vec vector() {
    Vec vector;
    vector.x = number();
    vector.y = number();
    vector.z = number();
    return vector;
  }
  std::vector<double> numbers(std::size_t count) {
    std::vector<double> numbers(count);
    for (double& next : numbers) next = number();
    return numbers;
  }
  Force force() {
    Force force;
    force.kind = static_cast<Force::Kind>(whole_number());
    for (double& constant : force.a) constant = number();
    return force;
  }

  /// The next arguments as the scene's acceleration.
  Acceleration acceleration() {
    const Force asked = force();
    if (asked.kind == Force::watched) return ask;
    return asked;
  }

  /// Adds to the answer.
  void answer(double number) { answer_.push_back(number); }
  void answer(const Vec& vector) { answer_.insert(answer_.end(), {vector.x, vector.y, vector.z}); }
  void answer(const std::vector<double>& numbers) {
    answer_.insert(answer_.end(), numbers.begin(), numbers.end());
  }

  const std::vector<double>& answer() const { return answer_; }

 private:
  int function_;
  std::vector<double> arguments_, answer_;
  std::size_t next_ = 0;
};

}  // namespace harness

/// Calls the student's code and answers; an exercise's harness.h defines it.
void answer(harness::Call& call);
#endif
