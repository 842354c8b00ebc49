// SPDX-License-Identifier: MIT-0
/// @file
/// Every method of the book: the lists that tests, cards, times and programs go over.
//
// What goes over one of these lists goes over all of its methods. A new method stands in the list
// of its kin, at the end of one of the headers in methods/, and nowhere else.
#pragma once
#include <tuple>
#include <type_traits>

#include "measure/methods/damping.h"
#include "measure/methods/euler.h"
#include "measure/methods/implicit.h"
#include "measure/methods/runge_kutta.h"
#include "measure/methods/spring.h"
#include "measure/methods/traits.h"
#include "measure/methods/verlet.h"

/// Measurements of a method on a scene: errors, orders, energies, limits and costs.
namespace measure {}

/// The methods of the book, as lists of their types.
namespace list {

/// Lists one after the other.
template <class... Lists>
using Joined = decltype(std::tuple_cat(Lists()...));

/// Those of a list of which something holds.
template <class List, auto holds>
struct Filtered;

/// Those of a list of which something holds.
template <class... Methods, auto holds>
struct Filtered<std::tuple<Methods...>, holds> {
  /// As one list.
  using List = Joined<std::conditional_t<holds(Methods()), std::tuple<Methods>, std::tuple<>>...>;
};

/// Those of a list of which something holds: a function object that is called with an object of
/// each type.
template <class List, auto holds>
using Among = typename Filtered<List, holds>::List;

/// True of a method that stands in a list.
template <class Method, class... Methods>
constexpr bool is_in(std::tuple<Methods...>) {
  return (std::is_same_v<Method, Methods> || ...);
}

/// Calls something with an object of each type of a list.
template <class... Methods, class Go>
void for_each(std::tuple<Methods...>, [[maybe_unused]] Go go) {
  (go(Methods()), ...);
}

// A method that says too little is refused below, in a sentence, and is left out of the lists, so
// that the sentence is all that the compiler says.
/// Refuses methods that say too little.
template <class... Methods>
constexpr bool require_all_traits(std::tuple<Methods...>) {
  return (measure::require_all_traits<Methods>() && ...);
}
/// Refuses methods without names.
template <class... Methods>
constexpr bool require_names(std::tuple<Methods...>) {
  return (measure::require_names<Methods>() && ...);
}
static_assert(require_all_traits(Joined<EulerFamily, VerletFamily, RungeKuttaKin, ImplicitKin>()));
static_assert(require_names(Joined<SpringKin, DampingKin>()));
/// True of a method that says all that is asked of it.
inline constexpr auto is_whole = [](auto method) {
  return measure::HasAllTraits<decltype(method)>;
};
/// True of a method that says what it is called.
inline constexpr auto is_named = [](auto method) { return measure::IsNamed<decltype(method)>; };

/// The explicit methods that take any acceleration.
using EveryExplicit = Among<Joined<EulerFamily, VerletFamily, RungeKuttaKin>, is_whole>;

/// The methods that take any acceleration, and its Jacobian.
using EveryImplicit = Among<ImplicitKin, is_whole>;

/// The methods that take any acceleration; the implicit ones want its Jacobian as well.
using EveryGeneral = Joined<EveryExplicit, EveryImplicit>;

/// The methods for one damped spring alone.
using EveryOnSprings = Among<SpringKin, is_named>;

/// The methods that take linear damping apart from the other forces.
using EveryDamping = Among<DampingKin, is_named>;

/// True of a method that the chapters run against the others.
inline constexpr auto is_contender = [](auto method) { return method.contender; };

/// The methods that the chapters run against each other.
using Contenders = Among<EveryGeneral, is_contender>;

// Compiled with -DONLY=Rk4, the lists hold that method alone. A list without it stays whole, since
// Catch2 takes no empty ones.
#ifdef ONLY
/// True of the chosen method.
inline constexpr auto is_chosen = [](auto method) {
  return std::is_same_v<decltype(method), measure::ONLY>;
};
template <class List, class Those = Among<List, is_chosen>>
using Chosen = std::conditional_t<std::is_same_v<Those, std::tuple<>>, List, Those>;
#else
/// All methods of a list, or the chosen one.
template <class List>
using Chosen = List;
#endif

using Explicit = Chosen<EveryExplicit>;    ///< the methods under test
using OnSprings = Chosen<EveryOnSprings>;  ///< the methods under test
using Damping = Chosen<EveryDamping>;      ///< the methods under test
using General = Chosen<EveryGeneral>;      ///< the methods under test

/// Those for any acceleration of which something holds, such as
/// `[](auto method) { return method.symplectic; }`.
template <auto holds>
using Where = Chosen<Among<EveryGeneral, holds>>;

}  // namespace list
