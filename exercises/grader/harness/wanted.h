// SPDX-License-Identifier: MIT-0
/// @file
/// A function that the exercise asks for, as the harness calls it.
#ifndef WANTED_H
#define WANTED_H
#include <functional>
#include <type_traits>
#include <utility>

namespace harness {

template <class Signature>
class Wanted;

/// `const harness::Wanted<double(double k, double m)> wanted = longest_step;` takes a function of
/// just this signature, and with a warning anything else that can be called so: one that takes by
/// value what the starter takes by reference, a lambda, a std::function.
template <class Result, class... Arguments>
class Wanted<Result(Arguments...)> {
 public:
  Wanted(Result (*function)(Arguments...)) : call_(function) {}

  template <class Other>
    requires std::is_invocable_r_v<Result, Other&, Arguments...>
  [[deprecated("another form")]] Wanted(Other other) : call_(std::move(other)) {}

  Result operator()(Arguments... arguments) const {
    return call_(std::forward<Arguments>(arguments)...);
  }

 private:
  std::function<Result(Arguments...)> call_;
};

}  // namespace harness
#endif
