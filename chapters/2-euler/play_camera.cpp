// SPDX-License-Identifier: MIT-0
// Chapter 2: cameras that follow the drone, on a fast machine and on a slow one.
// [cameras]
#include "../play/drone.h"
using play::Vec;

struct Camera {
  std::string name, colour;
  int rate;      // frames a second
  double share;  // of the way to its target, in each frame
  Vec at, x{10, 0};

  void draw(play::Film& film) const {
    const Vec corners[] = {{-4, -2.5}, {4, -2.5}, {4, 2.5}, {-4, 2.5}};
    for (int i = 0; i < 4; ++i)
      film.line(at + x + corners[i], at + x + corners[(i + 1) % 4], colour);
    film.label(at + Vec{0, -15}, name);
  }
};
// [cameras]

// [follow]
int main() {
  const double c = -60 * std::log(0.9);  // a tenth of the way, sixty times a second
  Camera cameras[] = {{"lerp at 60 Hz", "Euler", 60, 0.1, {-17, 16}},
                      {"lerp at 20 Hz", "Euler", 20, 0.1, {17, 16}},
                      {"exact at 60 Hz", "true", 60, 1 - std::exp(-c / 60), {-17, -17}},
                      {"exact at 20 Hz", "true", 20, 1 - std::exp(-c / 20), {17, -17}}};
  play::Hand drone;
  play::Film film({-33, -36}, {33, 30});
  for (int tick = 1; tick <= 8 * 60; ++tick) {
    drone.turn(1);
    if (tick % 3 == 0) film.picture(1 / 20.0);
    for (Camera& camera : cameras) {
      if (tick % (60 / camera.rate) == 0)
        camera.x = camera.x + camera.share * (10 * drone.tip - camera.x);
      if (tick % 3 != 0) continue;
      film.circle(camera.at + 10 * drone.tip, 0.7, "scenery");
      camera.draw(film);
    }
  }
  for (const Camera& camera : cameras)
    std::cout << camera.name << ": " << play::length(10 * drone.tip - camera.x) << " m behind\n";
  return film.write("play_camera.html");
}
// [follow]
