// SPDX-License-Identifier: MIT-0
/// @file
/// A method behind one type: compiled once, for forces on a line, in a plane and on many numbers.
#pragma once
#include <Eigen/Core>
#include <stdexcept>
#include <string_view>
#include <type_traits>
#include <vector>

#include "measure/force.h"
#include "scenes/state.h"

namespace measure {

/// The functions of a method for one kind of vector.
template <class Vec>
struct Stepper {
  /// All that the method keeps from one step to the next: position and velocity, or its memory.
  using Memory = std::vector<Vec>;
  Memory (*start)(const scenes::State<Vec>& s, double h, const Force<Vec>& force) = nullptr;
  void (*step)(Memory& memory, double t, double h, const Force<Vec>& force) = nullptr;
  scenes::State<Vec> (*to_state)(const Memory& memory, double t, double h,
                                 const Force<Vec>& force) = nullptr;
};

/// Any method of the book, as an object that run() and the other measurements take. Its steps have
/// the same bits as those of the header; only they are not inlined, so they are not to be timed.
class Method {
 public:
  std::string_view name;      ///< as in the book: "symplectic Euler"
  std::string_view function;  ///< in integrate: "symplectic_euler"
  std::string_view header;    ///< that has it: "symplectic_euler.h"
  Stepper<double> on_a_line;
  Stepper<Eigen::Vector2d> in_a_plane;
  Stepper<Eigen::VectorXd> of_many;

  /// Returns the memory at the start.
  /// @throws std::logic_error  it doesn't move such vectors
  template <class Vec, class Scene>
  auto start(const scenes::State<Vec>& s, double h, const Scene& scene) const {
    if (!on<Vec>().start) throw std::logic_error("the method doesn't move such vectors");
    return on<Vec>().start(s, h, Force<Vec>(scene));
  }

  /// One step.
  template <class Vec, class Scene>
  void step(std::vector<Vec>& memory, double t, double h, const Scene& scene) const {
    on<Vec>().step(memory, t, h, Force<Vec>(scene));
  }

  /// The state that it stands for.
  template <class Vec, class Scene>
  scenes::State<Vec> to_state(const std::vector<Vec>& memory, double t, double h,
                              const Scene& scene) const {
    return on<Vec>().to_state(memory, t, h, Force<Vec>(scene));
  }

 private:
  template <class Vec>
  const Stepper<Vec>& on() const {
    if constexpr (std::is_same_v<Vec, double>) {
      return on_a_line;
    } else if constexpr (std::is_same_v<Vec, Eigen::Vector2d>) {
      return in_a_plane;
    } else {
      static_assert(std::is_same_v<Vec, Eigen::VectorXd>,
                    "a Method moves double, Eigen::Vector2d and Eigen::VectorXd; for others take "
                    "the object of the same name in measure");
      return of_many;
    }
  }
};

}  // namespace measure
