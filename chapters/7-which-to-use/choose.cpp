// SPDX-License-Identifier: MIT-0
// Prints the cheapest method and step for a scene, from measurement.
#include <CLI/CLI.hpp>
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "contest.h"

namespace {

constexpr const char* about =
    "Prints the cheapest method and step that keep a scene within bounds, and why the others fall "
    "out.\nEvery method is run with more and more steps in each frame and compared with the exact "
    "solution.\nThe steps are doubled until the bounds are met, then every smaller number is "
    "tried.\nWhere doubling never gets there, every number that would cost less than the best is. "
    "The search ends\nat 1024 steps in a frame, and at a million in the whole run.";

constexpr const char* scenes_about =
    "Scenes: spring (--omega, --zeta), orbit (--omega, --eccentricity), pendulum (--omega, "
    "--angle),\n  drag (--drag), ball (a constant force).\n"
    "Prices: evaluations of the acceleration in a second of play. The derivatives that an implicit "
    "method\n  asks for cost as much again; solving its equations is not counted.\n"
    "Exit code: 0 found, 1 nothing meets the bounds, 2 bad input.\n"
    "Example: choose --scene spring --omega 40 --zeta 0.1 --hz 60 --error 0.01";

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

Ball ball_of(const Parameters&) {
  return height_of_jump;
}

/// One scene that can be asked for.
struct Choice {
  const char* name;
  std::array<const char*, 2> takes;
  bool (*keeps)(const Parameters&);
  Contest (*run)(const Parameters&, const Bounds&);
};

template <auto Make>
constexpr Choice choice(const char* name, std::array<const char*, 2> takes) {
  return {name, takes, [](const Parameters& p) { return keeps_energy(Make(p)); },
          [](const Parameters& p, const Bounds& bounds) { return contest(Make(p), bounds); }};
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

/// An option with a number, and between which limits the number must lie.
struct Number {
  const char* option;
  double* value;
  double least, most;
  const char* meaning;
};

std::string meaning_and_default(const Number& number) {
  const bool any = std::isinf(*number.value);
  return std::string(number.meaning) + " (default " + (any ? "any" : brief(*number.value)) + ")";
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
                              brief(number.least, 6) + " and " + brief(number.most, 6));
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
  if (bounds.frames() < 1) throw std::invalid_argument("--seconds is less than one frame");
  if (bounds.frames() > most_steps / 8) {
    throw std::invalid_argument("--seconds times --hz must stay below " +
                                std::to_string(most_steps / 8));
  }
}

void print(const Entry& entry, const Bounds& bounds, bool keeps_energy) {
  const std::string function(entry.method->function);
  std::printf("%-30s %11ld %10.0f  %-8s %-8s %s\n", function.c_str(), entry.last.substeps,
              entry.evaluations, brief(entry.last.error).c_str(),
              keeps_energy ? brief(entry.last.energy).c_str() : "-", reason(entry, bounds).c_str());
}

void print_choice(const Entry& entry) {
  const std::string function(entry.method->function), header(entry.method->header);
  std::printf(
      "  %s, %ld step%s a frame: %.0f evaluations a second, error %s\n"
      "  #include \"integrate/%s\"\n\n",
      function.c_str(), entry.last.substeps, entry.last.substeps > 1 ? "s" : "", entry.evaluations,
      brief(entry.last.error).c_str(), header.c_str());
}

/// @returns the exit code
int print(const Contest& found, const Bounds& bounds) {
  const bool exact = !found.exact.empty() && found.exact[0].good;
  const Entry& best = found.methods[0];
  if (exact) {
    std::printf("This scene has an exact step. Take it:\n");
    print_choice(found.exact[0]);
    std::printf("If other forces act as well, ");
  }
  if (best.good) {
    std::printf("%s\n",
                exact ? "the cheapest within the bounds is" : "The cheapest within the bounds:");
    print_choice(best);
  } else {
    std::printf("%s\n", exact ? "nothing meets the bounds; the nearest is"
                              : "Nothing meets the bounds. The nearest:");
    print_choice(best);
  }
  std::printf("%-30s %11s %10s  %-8s %-8s %s\n", "", "steps/frame", "evals/s", "error", "energy",
              "with fewer steps");
  for (const Entry& entry : found.methods) print(entry, bounds, found.keeps_energy);
  return exact || best.good ? 0 : 1;
}

int choose(int argc, char** argv) {
  CLI::App app{about, "choose"};
  app.footer(scenes_about);
  std::string scene;
  Parameters parameters;
  Bounds bounds;
  app.allow_extras();  // so that what is wrong is told before what is missing
  app.add_option("--scene", scene, "What moves; required");
  const std::array numbers{
      Number{"--omega", &parameters.omega, 1e-3, 1e3, "Frequency [rad/s]"},
      Number{"--zeta", &parameters.zeta, 0, 100, "Damping ratio"},
      Number{"--eccentricity", &parameters.eccentricity, 0, 0.99, "Of the orbit"},
      Number{"--angle", &parameters.angle, 1e-3, 3.1, "At which the pendulum starts [rad]"},
      Number{"--drag", &parameters.drag, 1e-3, 1e3, "Drag per mass [1/s]"},
      Number{"--hz", &bounds.hz, 1, 1e4, "Frames a second"},
      Number{"--seconds", &bounds.seconds, 1e-3, 1e4, "How long it is watched [s]"},
      Number{"--error", &bounds.error, 1e-15, 1, "Largest error, as a share of the motion"},
      Number{"--energy", &bounds.energy, 1e-15, 1, "Largest relative change of the energy"}};
  for (const Number& number : numbers) {
    app.add_option(number.option, *number.value, meaning_and_default(number));
  }
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
  const Choice& chosen = choice_of(scene);
  require_fits(app, chosen, parameters, bounds);
  return print(chosen.run(parameters, bounds), bounds);
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
