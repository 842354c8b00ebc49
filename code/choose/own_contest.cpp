// SPDX-License-Identifier: MIT-0
// What `choose --scene my_scene.h` compiles, with -DSCENE: the contest on that scene.
//   own_contest HZ SECONDS ERROR METRES FORMAT CHART WINNER
// METRES is not zero where the error is one in metres; CHART is empty if there shall be none; the
// name of the chosen function goes into the file WINNER. Prints the answer. Exit code 0 or 1 as
// choose, 2 after one line on stderr.
#include SCENE

#include "choose/own_scene.h"
// The scene comes first, since these know it.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string>

#include "choose/answer.h"
#include "choose/chart.h"

int main(int argc, char** argv) {
  if (argc != 8) return 2;
  try {
    const OwnScene scene;
    Bounds bounds{
        .hz = std::stod(argv[1]), .seconds = std::stod(argv[2]), .error = std::stod(argv[3])};
    if (std::stod(argv[4]) != 0) {
      bounds.reach = size_of(scene, bounds);
      bounds.error = std::stod(argv[4]) / bounds.reach;
    }
    const Contest found = full_contest(scene, bounds);
    const std::string name = std::filesystem::path(SCENE).filename().string();
    if (*argv[6]) draw_chart(found, bounds, name, argv[6]);
    print(found, bounds, format_of(argv[5]));
    std::fflush(stdout);
    std::ofstream(argv[7]) << found.methods.front().method->function;
    return is_met(found) ? 0 : 1;
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "choose: %s\n", problem.what());
    return 2;
  }
}
