// SPDX-License-Identifier: MIT-0
/// @file
/// A function that the exercise asks for, as the harness calls it.
#ifndef WANTED_H
#define WANTED_H
#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>

#include "bounds.h"
#ifdef WATCHED
#include "watch.h"  // of the proofs, see tests/exercises
#else
namespace harness {

/// A stand-in that watches nothing: only the proofs look at what is asked.
template <class... Arguments>
struct Watches {
  template <std::size_t count>
  static void of(const Bounds (&)[count], int) {}
  template <class... Passed>
  static void hear(const Passed&...) {}
};

}  // namespace harness
#endif

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
    watches_.hear(arguments...);
    return call_(std::forward<Arguments>(arguments)...);
  }

  /// Says what may be asked of each argument, as the line of harness.h says it.
  template <std::size_t count>
  void within(const Bounds (&bounds)[count], int line) const {
    static_assert(count == sizeof...(Arguments), "bounds for each argument, or harness::any");
    watches_.of(bounds, line);
  }

 private:
  std::function<Result(Arguments...)> call_;
  Watches<Arguments...> watches_;
};

/// Stands behind `wanted = longest_step;` and says what may be asked of each argument:
/// `const harness::Within within{wanted, {harness_bounds::k, harness_bounds::m}};`. In a line of
/// their own the bounds stay out of what a student with another signature is told.
struct Within {
  template <class Signature, std::size_t count>
  Within(const Wanted<Signature>& wanted, const Bounds (&bounds)[count],
         int line = __builtin_LINE()) {
    wanted.within(bounds, line);
  }
};

}  // namespace harness
#endif
