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
#include <array>
#include <memory>

#include "watch.h"  // of the proofs, see tests/exercises
#endif

namespace harness {

template <class Signature>
class Wanted;

/// `const harness::Wanted<double(double k, double m)> wanted{longest_step, {bounds::k,
/// bounds::m}};` takes a function of just this signature, and with a warning anything else that can
/// be called so: one that takes by value what the starter takes by reference, a lambda, a
/// std::function. Behind it stand the bounds of each argument.
template <class Result, class... Arguments>
class Wanted<Result(Arguments...)> {
 public:
  Wanted(Result (*function)(Arguments...)) : call_(function) {}
  template <class Other>
    requires std::is_invocable_r_v<Result, Other&, Arguments...>
  [[deprecated("another form")]] Wanted(Other other) : call_(std::move(other)) {}

  template <std::size_t count>
  Wanted(Result (*function)(Arguments...), const Bounds (&bounds)[count],
         int line = __builtin_LINE())
      : call_(function) {
    watch(bounds, line);
  }

  template <class Other, std::size_t count>
    requires std::is_invocable_r_v<Result, Other&, Arguments...>
  [[deprecated("another form")]] Wanted(Other other, const Bounds (&bounds)[count],
                                        int line = __builtin_LINE())
      : call_(std::move(other)) {
    watch(bounds, line);
  }

  Result operator()(Arguments... arguments) const {
    hear(std::index_sequence_for<Arguments...>(), arguments...);
    return call_(std::forward<Arguments>(arguments)...);
  }

#ifdef WATCHED
  template <std::size_t count>
  void watch(const Bounds (&bounds)[count], int line) const {
    static_assert(count == sizeof...(Arguments), "bounds for each argument, or harness::any");
    for (std::size_t i = 0; i < count; ++i) (*watches_)[i].of(bounds[i], line);
  }

 private:
  template <std::size_t... I, class... Passed>
  void hear(std::index_sequence<I...>, const Passed&... passed) const {
    ((*watches_)[I].hear(passed), ...);
  }
  using Watches = std::array<Watch, sizeof...(Arguments)>;
  std::shared_ptr<Watches> watches_ = std::make_shared<Watches>();  // of all copies
#else
  template <std::size_t count>
  static void watch(const Bounds (&)[count], int) {
    static_assert(count == sizeof...(Arguments), "bounds for each argument, or harness::any");
  }

 private:
  template <class Indices, class... Passed>
  static void hear(Indices, const Passed&...) {}
#endif

  std::function<Result(Arguments...)> call_;
};

/// Stands behind `wanted = longest_step;` and says what may be asked of each argument:
/// `const harness::Within within_wanted{wanted, {bounds::k, bounds::m}};`. In a line of their own
/// the bounds stay out of what a student with another signature is told.
struct Within {
  template <class Signature, std::size_t count>
  Within(const Wanted<Signature>& wanted, const Bounds (&bounds)[count],
         int line = __builtin_LINE()) {
    wanted.watch(bounds, line);
  }
};

}  // namespace harness
#endif
