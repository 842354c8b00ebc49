// SPDX-License-Identifier: MIT-0
// Prints the cheapest method and step for a scene, from measurement.
#include <CLI/CLI.hpp>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>

#include "choose/answer.h"
#include "choose/chart.h"
#include "choose/contests.h"
#include "choose/help.h"
#include "choose/own.h"
#include "frames/log.h"

namespace {

/// The scene's parameters.
struct Parameters {
  double omega = 10, zeta = 0, eccentricity = 0.5, angle = 1, drag = 1;
};

scenes::Spring<> damped_spring_of(const Parameters& p) {
  return {.omega = p.omega, .zeta = p.zeta};
}

scenes::Orbit<> orbit_of(const Parameters& p) {
  return {.eccentricity = p.eccentricity, .semi_major = 1, .mu = p.omega * p.omega};
}

scenes::Pendulum<> pendulum_of(const Parameters& p) {
  return {.g = p.omega * p.omega, .length = 1, .angle = p.angle};
}

scenes::LinearDrag<> drag_of(const Parameters& p) {
  return {.c = p.drag};
}

scenes::Toss ball_of(const Parameters&) {
  return thrown_ball;
}

/// One scene that can be asked for.
struct Choice {
  const char* name;
  std::array<const char*, 2> takes;
  bool (*keeps)(const Parameters&);
  Contest (*run)(const Parameters&, const Bounds&, const Tell&);
};

template <auto Make>
constexpr Choice choice(const char* name, std::array<const char*, 2> takes) {
  return {name, takes, [](const Parameters& p) { return keeps_energy(Make(p)); },
          [](const Parameters& p, const Bounds& bounds, const Tell& tell) {
            return full_contest(Make(p), bounds, tell);
          }};
}

// [scenes]
constexpr std::array choices{
    choice<damped_spring_of>("spring", {"--omega", "--zeta"}),
    choice<orbit_of>("orbit", {"--omega", "--eccentricity"}),
    choice<pendulum_of>("pendulum", {"--omega", "--angle"}),
    choice<drag_of>("drag", {"--drag", ""}),
    choice<ball_of>("ball", {"", ""}),
};
// [scenes]

const Choice& choice_of(const std::string& name) {
  std::string known;
  for (const Choice& choice : choices) {
    if (choice.name == name) return choice;
    known += (known.empty() ? "" : ", ") + std::string(choice.name);
  }
  throw std::invalid_argument("there is no scene '" + name + "'; there are " + known);
}

/// An option with a number, and the limits of the number.
struct Number {
  const char* option;
  double* value;
  double least, most;
  const char* meaning;
  bool is_time = false;  ///< may have a unit
};

/// What may stand behind a time [s].
const std::map<std::string, double> units_of_time{
    {"ms", 1e-3}, {"s", 1},        {"min", 60},      {"h", 3600},
    {"d", 86400}, {"days", 86400}, {"y", 3.15576e7}, {"years", 3.15576e7}};

std::string meaning_and_default(const Number& number) {
  const bool any = std::isinf(*number.value);
  return std::string(number.meaning) + " (default " + (any ? "any" : format_number(*number.value)) +
         ")";
}

void require_known(const CLI::App& app) {
  if (app.remaining_size() == 0) return;
  const std::string first = app.remaining().front();
  const bool option = first.starts_with("-");
  throw std::invalid_argument((option ? "there is no option " : "an option must come before ") +
                              first);
}

void require_in_range(const Number& number) {
  if (*number.value >= number.least && *number.value <= number.most) return;
  throw std::invalid_argument(std::string(number.option) + " must lie between " +
                              format_number(number.least, 6) + " and " +
                              format_number(number.most, 6));
}

void require_frames(const Bounds& bounds) {
  if (bounds.frames() < 1) throw std::invalid_argument("--seconds is less than one frame");
  if (bounds.frames() > most_steps / 8) {
    throw std::invalid_argument("--seconds times --hz must stay below " +
                                std::to_string(most_steps / 8) + ": at these --hz, --seconds " +
                                format_number(std::floor(double(most_steps) / 8 / bounds.hz), 6));
  }
}

void require_fits(const CLI::App& app, const Choice& choice, const Parameters& parameters,
                  const Bounds& bounds) {
  for (const char* option : {"--omega", "--zeta", "--eccentricity", "--angle", "--drag"}) {
    const bool takes =
        option == std::string(choice.takes[0]) || option == std::string(choice.takes[1]);
    if (app.count(option) > 0 && !takes) {
      throw std::invalid_argument("the scene " + std::string(choice.name) + " takes no " + option);
    }
  }
  if (app.count("--energy") > 0 && !choice.keeps(parameters)) {
    throw std::invalid_argument("drag takes energy from this scene, so --energy means nothing");
  }
  require_frames(bounds);
}

void refuse_both(const CLI::App& app, const char* one, const char* other) {
  if (app.count(one) > 0 && app.count(other) > 0) {
    throw std::invalid_argument(std::string(one) + " and " + other + " say the same; leave one");
  }
}

/// Numbers that can be given in place of others: a stiffness and a mass for a frequency, metres for
/// a share.
struct AlternativeUnits {
  double k = 0, m = 1, error_metres = 0, reach = 1, frame = 1 / 60.0;
};

/// Takes the length of a frame from where it is given, if it is.
/// @param log  the file of a log of frames; empty if there is none
void set_frames(const CLI::App& app, const AlternativeUnits& alternative, const std::string& log,
                Bounds& bounds) {
  refuse_both(app, "--frame", "--hz");
  if (app.count("--frame") > 0) bounds.hz = 1 / alternative.frame;
  if (log.empty()) return;
  bounds.log = {std::filesystem::path(log).filename().string(), frames::read_log(log)};
  if (app.count("--frame") == 0 && app.count("--hz") == 0)
    bounds.hz = double(bounds.log.lengths.size()) / sum_of(bounds.log.lengths);
}

/// Puts them in.
void use(const AlternativeUnits& alternative, const CLI::App& app, const Choice& choice,
         Parameters& parameters, Bounds& bounds) {
  const auto require = [&](const char* one, const char* other) {
    if (app.count(one) > 0 && app.count(other) == 0) {
      throw std::invalid_argument(std::string(one) + " means nothing without " + other);
    }
  };
  refuse_both(app, "--k", "--omega");
  refuse_both(app, "--error-metres", "--error");
  require("--m", "--k");
  require("--reach", "--error-metres");
  if (app.count("--k") > 0) {
    if (std::string(choice.name) != "spring") {
      throw std::invalid_argument("the scene " + std::string(choice.name) + " takes no --k");
    }
    parameters.omega = std::sqrt(alternative.k / alternative.m);
  }
  if (app.count("--error-metres") > 0) {
    bounds.error = alternative.error_metres / alternative.reach;
    bounds.reach = alternative.reach;
  }
}

/// Refuses what means nothing for a scene of the reader's own.
void require_fits_own(const CLI::App& app, const Bounds& bounds) {
  for (const char* option : {"--omega", "--zeta", "--eccentricity", "--angle", "--drag", "--k",
                             "--m", "--energy", "--reach"}) {
    if (app.count(option) > 0)
      throw std::invalid_argument("a scene of your own takes no " + std::string(option));
  }
  refuse_both(app, "--error-metres", "--error");
  require_frames(bounds);
}

int choose(int argc, char** argv) {
  CLI::App app{about, "choose"};
  app.footer(scenes_about);
  std::string scene;
  Parameters parameters;
  Bounds bounds;
  AlternativeUnits alternative;
  std::string format = "text", chart, log;
  OwnAsked asked;
  bool quiet = false;
  app.allow_extras();  // so that what is wrong is told before what is missing
  app.add_option("--scene", scene, "What moves; required");
  const std::array numbers{
      Number{"--omega", &parameters.omega, 1e-3, 1e3, "Frequency [rad/s]"},
      Number{"--zeta", &parameters.zeta, 0, 100, "Damping ratio"},
      Number{"--eccentricity", &parameters.eccentricity, 0, 0.99, "Of the orbit"},
      Number{"--angle", &parameters.angle, 1e-3, 3.1, "At which the pendulum starts [rad]"},
      Number{"--drag", &parameters.drag, 1e-3, 1e3, "Drag per mass [1/s]"},
      Number{"--hz", &bounds.hz, 1e-9, 1e5, "Frames a second"},
      Number{"--frame", &alternative.frame, 1e-5, 1e9,
             "How long a frame is, for --hz [s, or 1min, 1h, 1d]", true},
      Number{"--seconds", &bounds.seconds, 1e-3, 1e12,
             "How long it is watched [s, or 5min, 2h, 3d, 1y]", true},
      Number{"--error", &bounds.error, 1e-15, 1, "Largest error, as a share of the motion"},
      Number{"--energy", &bounds.energy, 1e-15, 1, "Largest relative change of the energy"},
      Number{"--k", &alternative.k, 1e-9, 1e12, "Stiffness of the spring, for --omega [N/m]"},
      Number{"--m", &alternative.m, 1e-9, 1e9, "Mass that hangs on it [kg]"},
      Number{"--error-metres", &alternative.error_metres, 1e-15, 1e9,
             "Largest error, for --error [m]"},
      Number{"--reach", &alternative.reach, 1e-9, 1e12,
             "How far the motion gets from its middle [m]"}};
  for (const Number& number : numbers) {
    CLI::Option* const option =
        app.add_option(number.option, *number.value, meaning_and_default(number));
    if (number.is_time) option->transform(CLI::AsNumberWithUnit(units_of_time));
  }
  app.add_option(
      "--frames", log,
      "A log of frames, by PresentMon, CapFrameX or MangoHud, or a column of seconds: the "
      "uneven ones, and without --hz their mean");
  app.add_flag(
      "--phase", asked.phases,
      "Lets the frames begin at sixteen moments, of which the worst counts: for forces that "
      "switch");
  app.add_flag("--quiet", quiet, "Says nothing of how far it has got");
  app.add_option("--format", format, "text or json (default text)");
  app.add_option("--chart", chart, "Draws error against both prices into this file, as SVG");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  }
  require_known(app);
  if (scene.empty()) throw std::invalid_argument("--scene is required");
  for (const Number& number : numbers) {
    if (app.count(number.option) > 0) require_in_range(number);
  }
  if (!chart.empty()) require_folder(chart);
  set_frames(app, alternative, log, bounds);
  const Format written = format_of(format);
  if (scene.ends_with(".h")) {
    require_fits_own(app, bounds);
    asked.metres = alternative.error_metres;
    return choose_for_own(scene, bounds, asked, written, chart, quiet);
  }
  if (asked.phases)
    throw std::invalid_argument("--phase is for scenes of your own; no force of " + scene +
                                " switches");
  const Choice& chosen = choice_of(scene);
  use(alternative, app, chosen, parameters, bounds);
  require_fits(app, chosen, parameters, bounds);
  const Contest found =
      with_progress(quiet, [&](const Tell& tell) { return chosen.run(parameters, bounds, tell); });
  if (!chart.empty()) draw_chart(found, bounds, scene, chart);
  print(found, bounds, written);
  return is_met(found) ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return choose(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "choose: %s\n", error.what());
    return 2;
  }
}
