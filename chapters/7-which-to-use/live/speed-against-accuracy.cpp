// SPDX-License-Identifier: MIT-0
// All methods of the level on a thing of the level, or on one of the reader's own: what each makes
// of it with 1, 2, 3 and more steps in a frame, and the loop in which the page times them.
#include <numbers>
#include <string>
#include <string_view>

#include "7-which-to-use/live/trial.h"
#include "live/figure.h"

namespace live {
namespace {

class SpeedAgainstAccuracy final : public Figure {
  double thing_ = 2, omega_ = 20, zeta_ = 0.1, eccentricity_ = 0.6, turn_ = 4, drag_ = 2;
  std::vector<double> tried_;
  Stood tried_with_;
  std::unique_ptr<Trial> trial_;
  const std::vector<std::string> paths_ = names(methods, "paths");
  const std::vector<std::string> errors_ = names(methods, "errors");
  const std::vector<std::string> evaluations_ = names(methods, "evaluations");
  const std::vector<std::string> book_evaluations_ = names(methods, "book evaluations");
  long steps_ = 0;

  std::vector<Setting> settings() override {
    return {{"thing", &thing_, things()},     {"omega", &omega_}, {"zeta", &zeta_},
            {"eccentricity", &eccentricity_}, {"turn", &turn_},   {"drag", &drag_}};
  }

  static std::vector<const char*> things() {
    std::vector<const char*> all;
    for_each_thing([&](const char* name, const auto&, double) { all.push_back(name); });
    all.insert(all.end(), {"spring", "orbit", "air"});
    return all;
  }

  // The same thing is not tried again.
  void start() override {
    steps_ = 0;
    const std::vector now{thing_, omega_, zeta_, eccentricity_, turn_, drag_};
    if (now != tried_ || tried_with_ != stands_now()) {
      tried_ = now;
      tried_with_ = stands_now();
      trial_ = try_thing();
      show_trial();
    }
    show_state();
  }

  void step() override { ++steps_; }

  void show_state() override {
    show("t", double(steps_) * frame);
    show("h", frame);
  }

  template <class Scene>
  static std::unique_ptr<Trial> try_scene(const Scene& scene, double seconds) {
    return std::make_unique<TrialOf<Scene>>(scene, seconds);
  }

  std::unique_ptr<Trial> try_thing() const {
    const std::string_view asked = things()[std::size_t(thing_)];
    std::unique_ptr<Trial> found;
    for_each_thing([&](const char* name, const auto& scene, double seconds) {
      if (name == asked) found = try_scene(scene, seconds);
    });
    if (found) return found;
    if (asked == "spring") {
      return try_scene(scenes::Spring<>{.omega = omega_, .zeta = zeta_, .x0 = suspension.x0}, 2);
    }
    if (asked == "air") return try_scene(scenes::LinearDrag<>{.c = drag_}, 2);
    const double rate = 2 * std::numbers::pi / turn_, half = shuttle.semi_major;
    return try_scene(scenes::Orbit<>{.eccentricity = eccentricity_,
                                     .semi_major = half,
                                     .mu = half * half * half * rate * rate},
                     turn_);
  }

  void show_trial() {
    show("seconds", trial_->seconds);
    show("omega", trial_->omega);
    show("zeta", trial_->zeta);
    show("angle", trial_->angle);
    show("eccentricity", trial_->eccentricity);
    show("drag", trial_->drag);
    show("tried", std::vector<double>(tried_in_a_frame.begin(), tried_in_a_frame.end()));
    show("truth", trial_->truth);
    for (std::size_t i = 0; i < paths_.size(); ++i) {
      const Outcome& outcome = trial_->outcomes[i];
      const auto show_list = [&](const std::string& called, const std::vector<double>& list) {
        outcome.reproducible ? show(called.c_str(), list) : show_reference(called.c_str(), list);
      };
      show_list(paths_[i], outcome.paths);
      show_list(errors_[i], outcome.errors);
      show(evaluations_[i].c_str(), outcome.asks());
      show(book_evaluations_[i].c_str(), outcome.evaluations);
    }
  }

  int bodies() const override { return int(in_a_loop); }
  double work(int which, int rounds) override { return trial_->work(which, rounds); }
};

}  // namespace

std::unique_ptr<Figure> make_speed_against_accuracy() {
  return std::make_unique<SpeedAgainstAccuracy>();
}

}  // namespace live
