// SPDX-License-Identifier: MIT-0
// The level of chapter 7: ten methods on each of its six things, and one of them at play.
#include <algorithm>
#include <string>

#include "7-which-to-use/live/trial.h"
#include "live/figure.h"

namespace live {
namespace {

/// How many of the methods are for every thing.
constexpr std::size_t for_all = 10;

/// How many frames lie between the trials of two things.
constexpr long apart = 8;

class Level final : public Figure {
  double thing_ = 5, method_ = 5, steps_in_a_frame_ = 1, tolerance_ = 0.01;
  std::vector<std::unique_ptr<Trial>> trials_;
  Stood tried_with_;
  long frames_ = 0;

  std::vector<Setting> settings() override {
    auto all = names(methods);
    all.resize(for_all);
    std::vector<const char*> things;
    for_each_thing([&](const char* name, const auto&, double) { things.push_back(name); });
    return {{"thing", &thing_, things},
            {"method", &method_, all},
            {"steps", &steps_in_a_frame_},
            {"tolerance", &tolerance_}};
  }

  // What the methods make of the things depends on nothing that the reader sets, but on what stands
  // in the place of one. All of them at once would keep the page waiting: the thing that is chosen
  // comes at the start, and the others one by one while the first run goes on.
  void start() override {
    frames_ = 0;
    if (tried_with_ != stands_now()) trials_.clear();
    tried_with_ = stands_now();
    try_out(std::size_t(thing_));
    show_table();
    show_run();
    show_state();
  }

  void step() override {
    if (++frames_ % apart != 0) return;
    const auto next = std::find(trials_.begin(), trials_.end(), nullptr);
    if (next == trials_.end()) return;
    try_out(std::size_t(next - trials_.begin()));
    show_table();
  }

  void try_out(std::size_t wanted) {
    std::size_t place = 0;
    for_each_thing([&](const char*, const auto& scene, double seconds) {
      using Scene = std::decay_t<decltype(scene)>;
      if (place == trials_.size()) trials_.emplace_back();
      auto& trial = trials_[place];
      if (place++ == wanted && !trial) trial = std::make_unique<TrialOf<Scene>>(scene, seconds);
    });
  }

  const Trial& trial() const { return *trials_[std::size_t(thing_)]; }
  const Outcome& outcome() const { return trial().outcomes[std::size_t(method_)]; }

  std::size_t place_of_steps() const {
    const auto& all = tried_in_a_frame;
    return std::size_t(std::find(all.begin(), all.end(), int(steps_in_a_frame_)) - all.begin());
  }

  // The largest errors, thing by thing and method by method, and what each thing costs at least.
  void show_table() {
    std::vector<double> errors, bills;
    for (const auto& trial : trials_) {
      double least = trial ? INFINITY : NAN;
      for (std::size_t i = 0; i < for_all; ++i) {
        if (!trial) {
          errors.push_back(NAN);
          continue;
        }
        const Outcome& outcome = trial->outcomes[i];
        errors.push_back(outcome.errors[place_of_steps()]);
        for (std::size_t k = 0; k < tried_in_a_frame.size(); ++k) {
          if (outcome.errors[k] > tolerance_) continue;
          least = std::min(least, outcome.asks() * tried_in_a_frame[k]);
        }
      }
      bills.push_back(least);
    }
    show("errors", errors);
    show("bills", bills);
    show("tolerance", tolerance_);
  }

  void show_run() {
    const auto& truth = trial().truth;
    const auto start = outcome().paths.begin() + std::ptrdiff_t(place_of_steps() * truth.size());
    path_.assign(start, start + std::ptrdiff_t(truth.size()));
    coordinates_ = truth.size() / std::size_t(std::lround(trial().seconds / frame) + 1);
    show("seconds", trial().seconds);
    show("truth", truth);
    show("path", path_);
    show("coordinates", double(coordinates_));
  }

  void show_state() override {
    show("t", double(frames_) * frame);
    show("h", frame);
    double squares = 0;
    for (std::size_t i = 0; i < coordinates_; ++i) {
      const std::size_t at = std::size_t(frames_) * coordinates_ + i;
      if (at >= path_.size()) break;
      squares += (path_[at] - trial().truth[at]) * (path_[at] - trial().truth[at]);
    }
    show("error", std::sqrt(squares));
    show("limit", tolerance_);
  }

  std::vector<double> path_;     // of the method that is chosen, frame by frame [m]
  std::size_t coordinates_ = 1;  // of a place
};

}  // namespace

std::unique_ptr<Figure> make_level() {
  return std::make_unique<Level>();
}

}  // namespace live
