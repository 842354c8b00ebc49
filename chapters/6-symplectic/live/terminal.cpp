// SPDX-License-Identifier: MIT-0
// The leaf of chapter 6 under six ways to brake, beside the true one.
#include <string>

#include "cast.h"
#include "live/figure.h"
#include "live/run.h"
#include "measure/methods/damping.h"

namespace live {
namespace {

constexpr std::tuple methods{
    Method{"explicit last", measure::linear_damping_explicit_last},
    Method{"explicit first", measure::linear_damping_explicit_first},
    Method{"implicit last", measure::linear_damping_implicit_last},
    Method{"implicit first", measure::linear_damping_implicit_first},
    Method{"exponential last", measure::linear_damping_exponential_last},
    Method{"exponential first", measure::linear_damping_exponential_first}};

class Terminal final : public Figure {
  double c_ = leaf.c, rate_ = 20;
  scenes::LinearDrag<> leaf_ = leaf;
  std::vector<std::unique_ptr<Run<double>>> runs_;
  std::vector<std::string> speeds_;  // what they are called

 public:
  Terminal() {
    for (const std::string name : names(methods)) speeds_.push_back(name + " speed");
  }

 private:
  std::vector<Setting> settings() override { return {{"c", &c_}, {"rate", &rate_}}; }

  void start() override {
    leaf_.c = c_;
    runs_.clear();
    for (std::size_t i = 0; i < speeds_.size(); ++i)
      runs_.push_back(start_run(methods, double(i), leaf_, leaf_.start(), 1 / rate_));
    show("end", leaf_.terminal_speed());
    show_state();
  }

  void step() override {
    for (const auto& run : runs_) run->step();
  }

  // The first four are made of nothing that the C library computes.
  void show_state() override {
    const double t = runs_.front()->t();
    show("t", t);
    show("h", 1 / rate_);
    const auto all = names(methods);
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      const auto& [x, v] = runs_[i]->now;
      const double part = -v / leaf_.terminal_speed();
      i < 4 ? show(all[i], x) : show_reference(all[i], x);
      i < 4 ? show(speeds_[i].c_str(), part) : show_reference(speeds_[i].c_str(), part);
    }
    const auto truth = leaf_.exact(t);
    show_reference("true", truth.x);
    show_reference("true speed", -truth.v / leaf_.terminal_speed());
  }
};

}  // namespace

std::unique_ptr<Figure> make_terminal() {
  return std::make_unique<Terminal>();
}

}  // namespace live
