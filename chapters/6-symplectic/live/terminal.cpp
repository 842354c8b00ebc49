// SPDX-License-Identifier: MIT-0
// The leaf of chapter 6 under six ways to brake, beside the true one.
#include <string>
#include <string_view>

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
  const std::vector<std::string> speeds_ = names(methods, "speed");

  std::vector<Setting> settings() override { return {{"c", &c_}, {"rate", &rate_}}; }

  void start() override {
    leaf_.c = c_;
    runs_ = start_runs(methods, leaf_, leaf_.start(), 1 / rate_);
    show("end", leaf_.terminal_speed());
    show_state();
  }

  void step() override {
    for (const auto& run : runs_) run->step();
  }

  void show_state() override {
    const double t = runs_.front()->t();
    show("t", t);
    show("h", 1 / rate_);
    const auto all = names(methods);
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      const auto& [x, v] = runs_[i]->now;
      const auto show_one = [&](const char* name, double value) {
        const bool by_the_library = std::string_view(all[i]).starts_with("exponential");
        by_the_library ? show_reference(name, value) : show(name, value);
      };
      show_one(all[i], x);
      show_one(speeds_[i].c_str(), -v / leaf_.terminal_speed());
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
