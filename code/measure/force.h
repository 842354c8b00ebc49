// SPDX-License-Identifier: MIT-0
/// @file
/// Any scene behind one type, so that a method on it need be compiled only once.
#pragma once
#include <Eigen/Core>
#include <cmath>
#include <stdexcept>
#include <type_traits>

namespace measure {

/// All that a method may ask of a scene; refers to the scene, and does not own it.
/// @tparam Vec  `double`, or an Eigen vector of doubles
template <class Vec>
class Force {
 public:
  double omega = NAN;  ///< of a spring [rad/s]; not a number if the scene has none
  double zeta = NAN;   ///< of a spring [1]; not a number if the scene has none

  /// Refers to a scene, which must outlive this.
  template <class Scene>
  explicit Force(const Scene& scene)
      : scene_(&scene), acceleration_([](const void* of, const Vec& x, const Vec& v, double t) {
          return Vec((*static_cast<const Scene*>(of))(x, v, t));
        }) {
    if constexpr (requires { scene.damping(); }) damping_ = scene.damping();
    if constexpr (requires { scene.omega, scene.zeta; }) {
      omega = scene.omega;
      zeta = scene.zeta;
    }
    if constexpr (requires(const Add& add) { scene.jacobian(Vec(), Vec(), 0.0, add); }) {
      jacobian_ = [](const void* of, const Vec& x, const Vec& v, double t, const Add& add) {
        static_cast<const Scene*>(of)->jacobian(x, v, t, add);
      };
    }
  }

  /// The acceleration.
  Vec operator()(const Vec& x, const Vec& v, double t) const {
    return acceleration_(scene_, x, v, t);
  }

  /// Hands the derivatives of the acceleration on.
  /// @param x  position
  /// @param v  velocity
  /// @param t  time [s]
  /// @param add  called as `add(i, j, dadx, dadv)`
  /// @throws std::logic_error  the scene has no `jacobian`
  template <class To>
  void jacobian(const Vec& x, const Vec& v, double t, To&& add) const {
    if (!jacobian_) throw std::logic_error("an implicit method needs the scene's jacobian()");
    jacobian_(scene_, x, v, t,
              {&add, [](const void* to, Index i, Index j, double dadx, double dadv) {
                 (*static_cast<const std::remove_reference_t<To>*>(to))(int(i), int(j), dadx, dadv);
               }});
  }

  /// The linear damping per mass [1/s].
  /// @throws std::logic_error  the scene has none
  double damping() const {
    if (std::isnan(damping_)) throw std::logic_error("the method needs the scene's damping()");
    return damping_;
  }

 private:
  using Index = Eigen::Index;

  /// Where an entry of the Jacobian goes.
  struct Add {
    const void* to;
    void (*add)(const void*, Index, Index, double, double);
    void operator()(Index i, Index j, double dadx, double dadv) const { add(to, i, j, dadx, dadv); }
  };

  const void* scene_;
  Vec (*acceleration_)(const void*, const Vec&, const Vec&, double);
  void (*jacobian_)(const void*, const Vec&, const Vec&, double, const Add&) = nullptr;
  double damping_ = NAN;
};

}  // namespace measure
