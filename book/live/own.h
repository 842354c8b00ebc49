// SPDX-License-Identifier: MIT-0
/// @file
/// A method that stands in the place of one of a figure's: the book's with a mistake, or the
/// reader's.
#pragma once
#include <Eigen/Dense>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "measure/run.h"

namespace live {

/// What moves is in at most three dimensions; those that a scene has not are zero.
using Vec3 = Eigen::Vector3d;

/// The acceleration of whatever scene, so that a method is compiled once for all of them.
class Force {
 public:
  virtual ~Force() = default;
  /// @param x, v  place [m] and velocity [m/s]
  /// @param t  time [s]
  /// @return acceleration [m/s^2]
  virtual Vec3 operator()(const Vec3& x, const Vec3& v, double t) const = 0;
};

/// A method at work, and what it remembers from one step to the next.
class Own {
 public:
  virtual ~Own() = default;
  /// Begins at time zero.
  virtual void start(const scenes::State<Vec3>& start, double h, const Force& force) = 0;
  /// One step from the time t on [s].
  virtual void step(double t, double h, const Force& force) = 0;
  /// The state that it stands for at the time t [s].
  virtual scenes::State<Vec3> now(double t, double h, const Force& force) const = 0;
};

/// One of the methods of code/measure at work.
template <class Step>
class OwnOf final : public Own {
  Step step_{};
  std::optional<decltype(measure::start(std::declval<const Step&>(),
                                        std::declval<const scenes::State<Vec3>&>(), 0.0,
                                        std::declval<const Force&>()))>
      kept_;

  void start(const scenes::State<Vec3>& start, double h, const Force& force) override {
    kept_ = measure::start(step_, start, h, force);
  }
  void step(double t, double h, const Force& force) override {
    measure::advance(step_, *kept_, t, h, force);
  }
  scenes::State<Vec3> now(double t, double h, const Force& force) const override {
    return measure::to_state(step_, *kept_, t, h, force);
  }
};

/// A method that can stand in the place of another.
struct Stand {
  const char*
      name;  ///< "euler/position-with-new-velocity": its edit in tests/mutants; "yours/euler"
  const char* method;  ///< in whose place, by the name of its header
  std::unique_ptr<Own> (*make)();
};

/// The book's methods with the mistakes that a figure lets its reader make.
std::span<const Stand> mistakes();

/// What stands in the place of a method in the run that a figure begins; nullptr if nothing does.
const Stand* standing();

/// @param which  a place in names_of_stands()
void put_standing(double which);

/// Counts the methods that the reader has written: another one is there.
void count_reader();

/// What stood in the place of a method when something was computed.
struct Stood {
  const Stand* stand = nullptr;
  long written = 0;  ///< methods of the reader's until then
  bool operator==(const Stood&) const = default;
};
/// The same of now.
Stood stands_now();

/// "none", the names of mistakes(), and for each method that the reader may write "yours/" and its
/// name.
std::vector<const char*> names_of_stands();

/// The method that the reader has written, which the page has compiled: in another module, and
/// called through the page.
std::unique_ptr<Own> reader();

/// The acceleration that the step which the reader has written asks for.
/// @param asked  place, velocity and time; the acceleration takes the place of the first three
void answer_reader(double (&asked)[7]);

}  // namespace live
