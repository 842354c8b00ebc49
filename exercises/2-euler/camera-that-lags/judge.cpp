// SPDX-License-Identifier: MIT-0
#include <array>
#include <catch2/catch_test_macros.hpp>

#include "format_values.h"
#include "harness.h"
#include "judge/describe.h"
#include "judge/numbers.h"
#include "judge/random.h"
#include "judge/session.h"
#include "judge/tests.h"
#include "scene.h"

using namespace judge;

namespace {

using grade::number;

Vec ask(Student& student, const Vec& camera, const Vec& target, const Lag& lag, double frame) {
  const auto numbers = as_numbers(camera, target, lag.part, lag.fastest, frame);
  const std::vector<double> got = student.call(0, numbers, 3);
  return {got[0], got[1], got[2]};
}

struct Shot {
  Vec camera, target;
  Lag lag;
  std::vector<double> frames;
  double jump = 0;  // of the target, to either side after every frame [m]
};

struct Film {
  std::vector<double> time;
  std::vector<Vec> camera, target;
};

// The path of a camera that moves so in a frame.
template <class Follow>
Film film(const Shot& shot, Follow follow) {
  Film film{{0}, {shot.camera}, {shot.target}};
  Vec camera = shot.camera, target = shot.target;
  double time = 0, side = 1;
  for (const double frame : shot.frames) {
    camera = follow(camera, target, frame);
    time += frame;
    film.time.push_back(time);
    film.camera.push_back(camera);
    film.target.push_back(target);
    target = target + side * shot.jump * Vec{1, 0, -1};
    side = -side;
  }
  return film;
}

grade::Curve curve(const std::string& name, const Film& film) {
  grade::Curve curve{name, film.time, {}};
  for (std::size_t n = 0; n < film.camera.size(); ++n) {
    curve.y.push_back(film.camera[n].x - film.target[n].x);
  }
  return curve;
}

// A distance so large that ten frames leave it flat out, whatever it takes for its rate: the tests
// of the lag say which is right.
constexpr double far_in_seconds = 2;

void follows(Student& student, const Shot& shot, const std::string& which,
             const std::string& hint) {
  const Film yours = film(shot, [&](const Vec& camera, const Vec& target, double frame) {
    return ask(student, camera, target, shot.lag, frame);
  });
  const Film right = film(shot, [&](const Vec& camera, const Vec& target, double frame) {
    return shot.lag.follow(camera, target, frame);
  });
  const int frames = static_cast<int>(shot.frames.size());
  const double size = length(shot.camera) + length(shot.target) + frames * shot.jump;
  const Tolerance each = rounding(size), tolerance{frames * each.value, each.from + ", a frame"};
  std::size_t n = 1;
  while (n + 1 < yours.camera.size() &&
         length(yours.camera[n] - right.camera[n]) <= tolerance.value) {
    ++n;
  }

  grade::Finding finding = off_by(length(yours.camera[n] - right.camera[n]), tolerance);
  finding.asked = "where the camera is after " + which;
  finding.input = "camera " + describe(yours.camera[n - 1], 17) + ", target " +
                  describe(right.target[n], 17) + ", " + described(shot.lag) + ", frame " +
                  number(shot.frames[n - 1], 17) + " s";
  finding.expected = describe(right.camera[n], 12);
  finding.got = describe(yours.camera[n], 12);
  finding.error += " m, after frame " + std::to_string(n);
  if (!finding.held) {
    finding.hint = hint;
    finding.diagnoses =
        what_is_wrong(shot.lag, yours.camera[n - 1], right.target[n], yours.camera[n]);
    finding.plot = {"How far the camera is from its target",
                    "time [s]",
                    "along x [m]",
                    {curve("yours", yours), curve("even frames, as many as you like", right)}};
  }
  check(finding);
}

Shot draw(Random& random, double part, const std::vector<double>& frames) {
  return {random.vector(-2, 2), random.vector(4, 9), {part}, frames};
}

// A shot from so far away that the camera slows down in the frame of that number, after a part of
// it.
Shot limited(Random& random, const std::vector<double>& frames, std::size_t slows_in) {
  Shot shot = draw(random, random.between(0.05, 0.2), frames);
  double flat_out = frames[slows_in] * random.between(0.2, 0.8);
  for (std::size_t n = 0; n < slows_in; ++n) flat_out += frames[n];
  const double distance = length(shot.target - shot.camera);
  // distance = fastest / rate + fastest * flat_out
  shot.lag.fastest = distance / (1 / shot.lag.rate() + flat_out);
  return shot;
}

// A camera of any part and any limit, one in four such that it counts within two kilometres.
Lag any_lag(Random& random) {
  Lag lag{random.anywhere(harness_bounds::part), random.anywhere(harness_bounds::fastest)};
  const auto& fastest = harness_bounds::fastest;
  if (random.whole(0, 9) == 0) {
    lag.part = harness_bounds::part.largest();
    lag.fastest = lag.rate() * random.between(1000, 2000);
  } else if (random.whole(0, 3) == 0)
    lag.fastest =
        std::clamp(lag.rate() * random.octaves(1, 2000), fastest.smallest(), fastest.largest());
  return lag;
}

// Near, far, as far as may be, or so far away that it slows down in the frame if it does at all.
Shot any_shot(Random& random, const Lag& lag, double frame) {
  const auto& place = harness_bounds::camera;
  Shot shot{{}, {}, lag, {frame}};
  do {
    shot.target = random.vector_anywhere(harness_bounds::target);
    shot.camera = random.vector_anywhere(place);
    const int kind = random.whole(0, 3);
    if (kind == 1) shot.camera = shot.target + shot.camera;
    if (kind == 2) {
      double flat_out = random.octaves(1e-5, 2);  // of the frame
      if (random.whole(0, 1) == 0) flat_out = std::max(0.0, 1 - flat_out);
      const double distance = lag.fastest * (1 / lag.rate() + flat_out * frame);
      shot.camera = shot.target + random.vector_anywhere({"distance", distance, distance});
    }
    if (kind == 3) {
      shot.camera = random.vector_anywhere({"camera", place.largest(), place.largest()});
      shot.target = -shot.camera;
    }
  } while (length(shot.camera) > (1 + 1e-12) * place.largest());
  return shot;
}

std::vector<double> uneven(Random& random, int count) {
  std::vector<double> frames;
  for (int n = 0; n < count; ++n) frames.push_back(random.between(0.004, 0.05));
  return frames;
}

// Moves a camera in one frame and in many that are as long together: whatever its rate is, it ends
// in one place.
void ends_where_one_frame_does(Student& student, const Shot& shot) {
  const Film cut = film(shot, [&](const Vec& camera, const Vec& target, double frame) {
    return ask(student, camera, target, shot.lag, frame);
  });
  const double whole = cut.time.back();
  const Vec expected = ask(student, shot.camera, shot.target, shot.lag, whole);
  const Tolerance each = rounding(length(shot.camera) + length(shot.target));
  const double frames = static_cast<double>(shot.frames.size());
  grade::Finding finding = off_by(length(cut.camera.back() - expected),
                                  {frames * each.value, each.from + ", a frame"}, " m");
  finding.asked = "one frame of " + number(whole, 17) + " s, and " + number(frames) +
                  " uneven ones that are as long together";
  finding.input = "camera " + describe(shot.camera, 17) + ", target " + describe(shot.target, 17) +
                  ", " + described(shot.lag);
  finding.expected = "one end; your one frame leads to " + describe(expected, 12);
  finding.got = "your many lead to " + describe(cut.camera.back(), 12);
  if (!finding.held) {
    finding.hint =
        "At which moment within a frame does the camera begin to slow down, and what is left of "
        "the frame then?";
    finding.plot = {"How far the camera is from its target",
                    "time [s]",
                    "along x [m]",
                    {curve("yours, in many frames", cut)}};
  }
  check(finding);
}

}  // namespace

TEST_CASE("a frame of any length takes the camera as far as frames of a sixtieth would",
          "[2-euler/camera-that-lags][2 points]") {
  Student student;
  Random random;
  const std::string hint =
      "In each sixtieth of a second the distance is multiplied by the same number. How often is "
      "that in a frame?";
  for (const double rate : {60.0, random.between(100, 240), random.between(20, 50)}) {
    const Shot shot = draw(random, random.between(0.05, 0.3), {1 / rate});
    follows(student, shot, "one frame, at " + number(rate, 4) + " frames a second", hint);
  }
  for (const double part : {random.between(0.05, 0.3), random.between(0.3, 0.9)})
    follows(student, draw(random, part, {1.0 / 60}),
            "one frame of one of two cameras, with a part of " + number(part), hint);
  const double brief = 1 / random.between(100, 240);
  Shot close = draw(random, random.between(0.05, 0.3), {brief});
  close.camera = close.target + random.vector(0.001, 0.01);
  follows(student, close, "one frame that begins within two centimetres of the target", hint);
  close.camera = close.target;
  follows(student, close, "one frame that begins at the target",
          "Where nothing is left of the way there is nothing to divide by.");
}

TEST_CASE("uneven frames leave the camera where even ones do",
          "[2-euler/camera-that-lags][1 point]") {
  Student student;
  Random random;
  const auto frames = uneven(random, 60);
  const Shot shot = draw(random, random.between(0.03, 0.1), frames);
  follows(student, shot, "sixty uneven frames",
          "Two frames after each other must leave what one frame of both lengths leaves.");
}

TEST_CASE("after a hitch the camera is near its target and not beyond it",
          "[2-euler/camera-that-lags][1 point]") {
  Student student;
  Random random;
  for (const double hitch : {random.between(0.15, 0.4), random.between(0.5, 2)}) {
    const Shot shot = draw(random, random.between(0.1, 0.3), {1.0 / 60, 1.0 / 60, hitch, 1.0 / 60});
    follows(student, shot, "a frame of " + number(hitch, 3) + " s",
            "What is left of the distance can become very small, but never less than nothing.");
  }
}

TEST_CASE("a target that jumps is followed from where the camera is",
          "[2-euler/camera-that-lags][1 point]") {
  Student student;
  Random random;
  const auto frames = uneven(random, 30);
  Shot shot = draw(random, random.between(0.05, 0.3), frames);
  shot.jump = random.between(1, 3);
  follows(student, shot, "thirty uneven frames, after each of which the target jumps",
          "All that counts is where the camera and the target are now.");
}

TEST_CASE("the camera is never faster than it may be, however a run is cut into frames",
          "[2-euler/camera-that-lags][2 points]") {
  Student student;
  Random random;
  const std::string hint =
      "At which distance does the lag move the camera at just its highest speed? How much of the "
      "frame is left when it is there?";
  follows(student, limited(random, {random.between(0.2, 0.6)}, 0),
          "one long frame, in which it is flat out first and then slows down", hint);
  const auto slows = static_cast<std::size_t>(random.whole(10, 30));
  follows(student, limited(random, uneven(random, 40), slows),
          "forty uneven frames, in one of which it slows down", hint);
  Shot far = limited(random, uneven(random, 30), 29);
  follows(student, far, "thirty uneven frames, in the last of which it slows down", hint);
  far.frames.resize(10);
  far.jump = 0.1 * length(far.target - far.camera);
  follows(student, far, "ten uneven frames after a target that jumps, too far away to slow down",
          hint);
}

TEST_CASE("far away the camera flies at its highest speed, and where it slows down no cut is seen",
          "[2-euler/camera-that-lags][2 points]") {
  Student student;
  Random random;
  const std::string hint =
      "As long as the lag would have it move faster, it moves straight at its target at `fastest`.";
  for (const double fastest :
       {random.between(0.1, 1), random.between(5, 30), random.between(100, 300)}) {
    const auto frames = uneven(random, 10);
    Shot far = draw(random, random.between(0.3, 0.6), frames);
    far.lag.fastest = fastest;
    far.target = far.camera + (far_in_seconds * fastest) * Vec{0.6, -0.64, 0.48};
    follows(student, far, "ten uneven frames, too far away to slow down", hint);
  }
  ends_where_one_frame_does(student, limited(random, uneven(random, 20), 12));
}

TEST_CASE("two cameras by turns are right, however far, fast or slow, in frames of any length",
          "[2-euler/camera-that-lags][1 point]") {
  Student student;
  Random random;
  constexpr int pairs = 200, rounds = 2;
  for (int n = 0; n < pairs; ++n) {
    double frame = random.anywhere(harness_bounds::frame);
    // Now and then nearly a sixtieth, as clocks measure it.
    if (n % 5 == 0) frame = (1 + random.octaves(1e-5, 0.1)) / 60;
    const Lag lag = any_lag(random);
    Lag other = any_lag(random);
    // Now and then only their limits differ, or only their parts.
    const int alike = random.whole(0, 3);
    if (alike == 0) other.part = lag.part;
    if (alike == 1) other.fastest = lag.fastest;
    std::array<Shot, 2> shots{any_shot(random, lag, frame), any_shot(random, other, frame)};
    for (int round = 0; round < rounds; ++round)
      for (Shot& shot : shots) {
        follows(student, shot, "a frame of one of two cameras that take turns",
                "One rule holds for all. Which of these numbers is so large or so small, or which "
                "is 0, that a line of yours does something of its own?");
        shot.camera = shot.lag.follow(shot.camera, shot.target, frame);
      }
  }
}
