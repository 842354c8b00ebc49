// SPDX-License-Identifier: MIT-0
/// @file
/// A run of one method out of several, chosen while the page is open.
#pragma once
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "live/own.h"
#include "measure/run.h"

namespace live {

/// A method under the name that its header and the page have for it.
template <class Step>
struct Method {
  const char* name;
  Step step;
};

/// The names of some methods, for a setting to choose from.
template <class... Steps>
std::vector<const char*> names(const std::tuple<Method<Steps>...>& methods) {
  return std::apply([](const auto&... method) { return std::vector{method.name...}; }, methods);
}

/// The same, each with what of the method it names: "rk4 speed".
template <class... Steps>
std::vector<std::string> names(const std::tuple<Method<Steps>...>& methods, const std::string& of) {
  std::vector<std::string> all;
  for (const char* name : names(methods)) all.push_back(name + (" " + of));
  return all;
}

/// A run of some method on some scene, one step at a time.
template <class Vec>
class Run {
 public:
  virtual ~Run() = default;
  virtual void step() = 0;

  double h;                ///< step size [s]
  long steps = 0;          ///< taken so far
  scenes::State<Vec> now;  ///< the state after them

  /// The time of the state, with one rounding however long the run is [s].
  double t() const { return double(steps) * h; }

 protected:
  Run(double step_size, const scenes::State<Vec>& start) : h(step_size), now(start) {}
};

/// A run of one method on one scene.
template <class Vec, class Scene, class Step>
class RunOf final : public Run<Vec> {
 public:
  RunOf(Step step, const Scene& scene, const scenes::State<Vec>& start, double step_size)
      : Run<Vec>(step_size, start),
        step_(step),
        scene_(scene),
        kept_(measure::start(step, start, step_size, scene)) {}

  void step() override {
    measure::advance(step_, kept_, this->t(), this->h, scene_);
    ++this->steps;
    this->now = measure::to_state(step_, kept_, this->t(), this->h, scene_);
  }

 private:
  Step step_;
  Scene scene_;
  decltype(measure::start(std::declval<const Step&>(), std::declval<const scenes::State<Vec>&>(),
                          0.0, std::declval<const Scene&>())) kept_;
};

/// Zeros for the dimensions that a scene has not.
template <class Vec>
Vec3 widened(const Vec& narrow) {
  Vec3 wide = Vec3::Zero();
  if constexpr (std::is_same_v<Vec, double>) {
    wide[0] = narrow;
  } else {
    wide.head<Vec::SizeAtCompileTime>() = narrow;
  }
  return wide;
}

/// The dimensions that a scene has.
template <class Vec>
Vec narrowed(const Vec3& wide) {
  if constexpr (std::is_same_v<Vec, double>) {
    return wide[0];
  } else {
    return wide.head<Vec::SizeAtCompileTime>();
  }
}

/// Whether the vectors of a scene have at most three dimensions, known when it is compiled.
template <class Vec>
constexpr bool fits_three() {
  if constexpr (std::is_same_v<Vec, double>) {
    return true;
  } else {
    return Vec::SizeAtCompileTime >= 1 && Vec::SizeAtCompileTime <= 3;
  }
}

/// A scene as a force in three dimensions, for a call.
template <class Vec, class Scene>
class ForceOf final : public Force {
  const Scene& scene_;

 public:
  explicit ForceOf(const Scene& scene) : scene_(scene) {}
  Vec3 operator()(const Vec3& x, const Vec3& v, double t) const override {
    return widened<Vec>(scene_(narrowed<Vec>(x), narrowed<Vec>(v), t));
  }
};

/// What stands in the place of a method, as a method of code/measure.
struct StandIn {
  template <class Vec>
  struct Memory {
    using value_type = Vec;
    std::unique_ptr<Own> own;
  };

  /// Begins a run at time zero.
  template <class Vec, class Scene>
  static Memory<Vec> start(const scenes::State<Vec>& start, double h, const Scene& scene) {
    Memory<Vec> memory{standing()->make()};
    memory.own->start({widened<Vec>(start.x), widened<Vec>(start.v)}, h,
                      ForceOf<Vec, Scene>(scene));
    return memory;
  }
  /// One step.
  template <class Vec, class Scene>
  static void step(Memory<Vec>& memory, double t, double h, const Scene& scene) {
    memory.own->step(t, h, ForceOf<Vec, Scene>(scene));
  }
  /// The state that it stands for.
  template <class Vec, class Scene>
  static scenes::State<Vec> to_state(const Memory<Vec>& memory, double t, double h,
                                     const Scene& scene) {
    const auto [x, v] = memory.own->now(t, h, ForceOf<Vec, Scene>(scene));
    return {narrowed<Vec>(x), narrowed<Vec>(v)};
  }
};

/// Whether something stands in the place of a method where a scene has such vectors.
template <class Vec>
bool is_stood_in_for(std::string_view method) {
  return fits_three<Vec>() && standing() && standing()->method == method;
}

/// Calls a function with a method, or with what stands in its place.
template <class Vec, class Step, class Act>
auto with_what_stands(const Method<Step>& method, Act&& act) {
  if constexpr (fits_three<Vec>()) {
    if (is_stood_in_for<Vec>(method.name)) return act(StandIn());
  }
  return act(method.step);
}

/// Starts a run with one of several methods, or with what stands in its place.
/// @param methods  to choose from
/// @param which  the place of the chosen one in the list
/// @param scene  the acceleration; the run keeps a copy
/// @param start  where it begins, at time zero
/// @param h  step size [s]
template <class Vec, class Scene, class... Steps>
std::unique_ptr<Run<Vec>> start_run(const std::tuple<Method<Steps>...>& methods, double which,
                                    const Scene& scene, const scenes::State<Vec>& start, double h) {
  std::unique_ptr<Run<Vec>> run;
  std::size_t place = 0;
  const auto start_if_chosen = [&](const auto& method) {
    if (place++ != static_cast<std::size_t>(which)) return;
    with_what_stands<Vec>(method, [&]<class Taken>(const Taken& step) {
      run = std::make_unique<RunOf<Vec, Scene, Taken>>(step, scene, start, h);
    });
  };
  std::apply([&](const auto&... method) { (start_if_chosen(method), ...); }, methods);
  return run;
}

/// Starts a run with each of several methods, in their order.
/// @param methods  all of them
/// @param scene  the acceleration; each run keeps a copy
/// @param start  where they begin, at time zero
/// @param h  step size [s]
template <class Vec, class Scene, class... Steps>
std::vector<std::unique_ptr<Run<Vec>>> start_runs(const std::tuple<Method<Steps>...>& methods,
                                                  const Scene& scene,
                                                  const scenes::State<Vec>& start, double h) {
  std::vector<std::unique_ptr<Run<Vec>>> runs;
  for (std::size_t i = 0; i < sizeof...(Steps); ++i)
    runs.push_back(start_run(methods, double(i), scene, start, h));
  return runs;
}

/// Where a thing should be, at 301 equal times from the start on.
/// @param scene  has `exact()`; its places are numbers
/// @param seconds  until when [s]
template <class Scene>
std::vector<double> true_path(const Scene& scene, double seconds) {
  std::vector<double> path;
  for (int i = 0; i <= 300; ++i) path.push_back(scene.exact(seconds * i / 300).x);
  return path;
}

}  // namespace live
