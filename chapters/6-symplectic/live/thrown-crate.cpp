// SPDX-License-Identifier: MIT-0
// The crate of chapter 6, thrown by the reader and turned in three ways.
#include <array>

#include "live/figure.h"
#include "measure/tumbling.h"
#include "shelf/orientation.h"

namespace live {
namespace {

using Vec3 = shelf::Vec3<double>;

/// All that a way to turn it needs, and where its corners are, seen as in the film.
struct Body {
  const char *x, *y, *energy;  // what is shown of it
  shelf::Quaternion<double> q{};
  Vec3 L{}, inertia{};

  double energy_now() const { return 0.5 * dot(shelf::angular_velocity(q, L, inertia), L); }

  std::pair<std::vector<double>, std::vector<double>> corners(const Vec3& size) const {
    std::vector<double> xs, ys;
    for (int i = 0; i < 8; ++i) {
      const auto way = [i](int bit) { return i & bit ? 0.5 : -0.5; };
      const Vec3 to = shelf::rotate(q, {way(1) * size.x, way(2) * size.y, way(4) * size.z});
      xs.push_back(to.x + 0.3 * to.z);
      ys.push_back(to.y + 0.2 * to.z);
    }
    return {xs, ys};
  }
};

class ThrownCrate final : public Figure {
  double rate_ = 60, thick_ = 0.3;
  double aside_ = 12, up_ = -0.2;  // the flick: spin about the upright and the level axis [rad/s]
  long steps_ = 0;
  double thrown_ = 1;  // energy [J]
  Vec3 size_{};
  std::array<Body, 3> bodies_{{{"naive x", "naive y", "naive energy"},
                               {"bullet x", "bullet y", "bullet energy"},
                               {"rotations x", "rotations y", "rotations energy"}}};

  std::vector<Setting> settings() override {
    return {{"rate", &rate_}, {"thickness", &thick_}, {"aside", &aside_}, {"up", &up_}};
  }

  void start() override {
    steps_ = 0;
    size_ = {2, 1.4, thick_};  // as in play/crate.h, which draws by streams that a page has not
    for (Body& body : bodies_) {
      body.q = {};
      body.inertia = shelf::inertia_of_box(1.0, size_);
      body.L = shelf::angular_momentum(body.q, {-up_, aside_, 0.2}, body.inertia);
    }
    thrown_ = bodies_.front().energy_now();
    show_state();
  }

  void step() override {
    const double h = 1 / rate_;
    measure::by_its_spin(bodies_[0], h);
    measure::by_bullet(bodies_[1], h);
    measure::by_rotations(bodies_[2], h);
    ++steps_;
  }

  void show_state() override {
    show("t", double(steps_) / rate_);
    show("h", 1 / rate_);
    for (const Body& body : bodies_) {
      const auto [xs, ys] = body.corners(size_);
      show_reference(body.x, xs);
      show_reference(body.y, ys);
      show_reference(body.energy, body.energy_now() / thrown_);
    }
  }
};

}  // namespace

std::unique_ptr<Figure> make_thrown_crate() {
  return std::make_unique<ThrownCrate>();
}

}  // namespace live
