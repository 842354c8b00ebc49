// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>
#include <utility>

#include "format_values.h"
#include "harness.h"
#include "judge/random.h"
#include "judge/session.h"
#include "judge/tests.h"
#include "scene.h"

using namespace judge;
using namespace machine;

namespace {

using grade::number;

struct Frame {
  double length, steps, saved;
};

Frame spend(Student& student, const Machine& machine, double saved, double length) {
  const std::vector<double> answer =
      student.call(0, {saved, length, machine.h, static_cast<double>(machine.most)}, 2);
  return {length, answer[0], answer[1]};
}

// Each frame lasts as long as the one before made it; number 20 has a hitch. Ends early when frames
// are hopelessly long.
std::vector<Frame> live(Student& student, const Machine& machine, int count, double hitch) {
  std::vector<Frame> frames;
  double saved = 0, length = machine.draw;
  for (int n = 0; n < count && length < 10; ++n) {
    frames.push_back(spend(student, machine, saved, length));
    saved = frames.back().saved;
    length = machine.draw + frames.back().steps * machine.cost + (n == 20 ? hitch : 0);
  }
  return frames;
}

grade::Plot plot(const std::vector<Frame>& frames, const Machine& machine) {
  grade::Curve yours{"yours", {}, {}}, settled{"where it settles", {}, {}};
  for (std::size_t n = 0; n < frames.size(); ++n) {
    const double at = static_cast<double>(n + 1);
    yours.x.push_back(at);
    yours.y.push_back(frames[n].length);
    settled.x.push_back(at);
    settled.y.push_back(machine.settled());
  }
  return {"How long frames are", "frame", "length [s]", {yours, settled}};
}

Tolerance rest_tolerance(double length, double h) {
  const double sums = length / h + 4;
  return {sums * length * std::numeric_limits<double>::epsilon(),
          "rounding: one sum for each step that the frame covers"};
}

std::vector<std::string> what_is_wrong(const Frame& got, double steps, int most) {
  if (got.steps > most)
    return {"more steps than a frame may take: is there a limit at all, and is it `most`?"};
  if (got.steps < steps) return {"fewer steps than are due, though it may take them"};
  return {};
}

void spends(Student& student, const Machine& machine, double saved, double length,
            const std::string& hint) {
  const Frame got = spend(student, machine, saved, length);
  const double due = std::floor((saved + length) / machine.h);
  const double steps = std::min<double>(due, machine.most), rest = saved + length - due * machine.h;
  const Tolerance tolerance = rest_tolerance(saved + length, machine.h);

  grade::Finding finding;
  const auto is_right = [&](const Frame& frame) {
    return frame.steps == steps && std::abs(frame.saved - rest) <= tolerance.value;
  };
  finding.held = is_right(got);
  finding.asked = "the steps that are due in a frame in which " + number(due) + " fit";
  finding.input = "saved = " + number(saved, 17) + " s, length = " + number(length, 17) +
                  " s, h = " + number(machine.h, 17) + " s, most = " + std::to_string(machine.most);
  finding.expected = number(steps) + " steps, and " + number(rest, 12) + " s saved";
  finding.got = number(got.steps) + " steps, and " + number(got.saved, 12) + " s saved";
  finding.error = number(std::abs(got.steps - steps)) + " steps, " +
                  number(std::abs(got.saved - rest), 3) + " s of what is saved";
  finding.tolerance = "no step, and " + number(tolerance.value, 2) + " s";
  finding.tolerance_from = tolerance.from;
  if (!finding.held) {
    finding.hint = hint;
    finding.diagnoses = what_is_wrong(got, steps, machine.most);
  }
  check(finding);
}

std::string hint_for(const Machine& machine) {
  return machine.cost < machine.h
             ? "A frame F asks for F/h steps, if so many are allowed. When is F the same again?"
             : "A step costs as much as it covers, or more: every frame takes all the steps it "
               "may.";
}

// The next frame is as long as this one.
void settles(Student& student, const Machine& machine, const std::string& hint) {
  const auto ask = [&](Student& who) {
    return who.call(1, {machine.draw, machine.cost, machine.h, static_cast<double>(machine.most)},
                    1)[0];
  };
  const double got = ask(student);
  const double next = machine.next(got);
  grade::Finding finding = off_by(std::abs(next - got), rounding(std::abs(next)), " s");
  finding.held = finding.held && got > 0;
  if (got <= 0) finding.error = "no frame is as short as that";
  finding.asked = "how long frames are in the end";
  finding.input = describe(machine);
  finding.expected = "a frame behind which the next one is as long, above 0 s";
  finding.got = number(got, 12) + " s, and the next one would take " + number(next, 12) + " s";
  if (!finding.held) {
    finding.hint = hint;
  }
  check(finding);
}

// A frame of so many steps and a part of one.
void spends(Student& student, const Machine& machine, double saved, double steps) {
  spends(student, machine, saved, steps * machine.h - saved,
         "Count what fits, take what is allowed, and leave in saved what is less than a step.");
}

// Frames of just one step or so many: powers of two add up without rounding.
void spends_whole(Student& student, Random& random) {
  const std::string hint = "A step is due when all of its time is there, and not before.";
  Machine machine = draw_machine(random, 1);
  machine.h = harness_bounds::sixty_fourth;
  for (const int steps : {1, machine.most, machine.most + 1})
    spends(student, machine, 0, steps * machine.h, hint);
}

struct Owed {
  double saved, length;
};

// Rounding chooses whether the last step is due.
bool is_nearly_whole(const Owed& owed, double h) {
  const double all = owed.saved + owed.length, whole = std::round(all / h);
  return whole > 0 && std::abs(all - whole * h) <= rest_tolerance(all, h).value;
}

// A frame of any length, or of about as many steps as it may take, with anything saved that is less
// than a step.
Owed any_frame(Random& random, const Machine& machine) {
  const double h = machine.h;
  Owed owed;
  do {
    owed = {random.anywhere(harness_bounds::saved), random.anywhere(harness_bounds::length)};
    if (random.whole(0, 1) == 0) owed.saved = h - owed.saved;
    owed.saved = std::clamp(owed.saved, 0.0, (1 - 5e-13) * h);
    if (random.whole(0, 2) == 0) owed.length = (machine.most + random.between(-1, 2)) * h;
    owed.length = std::min(owed.length, harness_bounds::length.largest());
  } while (is_nearly_whole(owed, h));
  return owed;
}

}  // namespace

TEST_CASE("no frame takes more steps than it may, and a hitch is forgotten",
          "[1-test-case/too-long-a-frame][2 points]") {
  Student student;
  Random random;
  for (int n = 0; n < 12; ++n) {
    const Machine machine = draw_machine(random, 1);
    // Every third frame is within the limit.
    const int whole =
        n % 3 == 0 ? random.whole(2, machine.most) : random.whole(machine.most + 2, 60);
    const double part = random.between(0.55, 0.95), saved = random.between(0.05, 0.5) * machine.h;
    spends(student, machine, saved, whole + part);
  }
  spends_whole(student, random);
}

TEST_CASE("a machine too slow for its steps slows the game and not the screen",
          "[1-test-case/too-long-a-frame][2 points]") {
  Student student;
  Random random;
  const Machine machine = draw_machine(random, random.between(1.2, 3));
  const std::vector<Frame> frames = live(student, machine, 200, 0);
  const double got = frames.back().length, expected = machine.settled();

  grade::Finding finding = off_by(std::abs(got - expected), rounding(expected), " s");
  finding.held = finding.held && frames.size() == 200;
  finding.asked = "two hundred frames, each as long as its drawing and the steps of the one before";
  finding.input = describe(machine);
  finding.expected = "frames of " + number(expected) + " s in the end";
  finding.got = "frame " + std::to_string(frames.size()) + " takes " + number(got) + " s";
  if (!finding.held) {
    finding.hint = "A step costs more than it covers here. Which number keeps a frame short?";
    const double taken = frames.back().steps;
    if (taken != machine.most) {
      finding.diagnoses.push_back("frame " + std::to_string(frames.size()) + " took " +
                                  number(taken) + " steps, where " + std::to_string(machine.most) +
                                  " are due and allowed");
    }
    if (got > 2 * expected) {
      finding.diagnoses.push_back("each frame is up to " + number(machine.cost / machine.h, 3) +
                                  " times as long as the one before: the game hangs");
    }
    finding.plot = plot(frames, machine);
  }
  check(finding);
}

TEST_CASE("a machine that keeps up makes good a hitch",
          "[1-test-case/too-long-a-frame][2 points]") {
  Student student;
  Random random;
  const Machine machine = draw_fast(random);
  const double hitch = (machine.most - 1) * machine.h - machine.settled() - machine.h;
  const std::vector<Frame> frames = live(student, machine, 300, hitch);
  double time = 0, steps = 0;
  for (const Frame& frame : frames) {
    time += frame.length;
    steps += frame.steps;
  }
  const double got = steps * machine.h + frames.back().saved;
  const double sums = static_cast<double>(frames.size()) * (machine.most + 4);
  const Tolerance tolerance{sums * time * std::numeric_limits<double>::epsilon(),
                            "rounding: one sum for each frame and each of its steps"};

  grade::Finding finding = off_by(std::abs(got - time), tolerance, " s");
  finding.asked = "three hundred frames, one of them longer by " + number(hitch) +
                  " s, which the limit still allows: no time may be lost";
  finding.input = describe(machine);
  finding.expected = "steps and rest for all of the " + number(time, 12) + " s";
  finding.got = number(got, 12) + " s";
  if (!finding.held) {
    finding.hint = "Only whole steps beyond the limit may be dropped, and here there are none.";
    finding.diagnoses = {"the game runs at " + number(got / time, 4) + " times its speed"};
    finding.plot = plot(frames, machine);
  }
  check(finding);
}

TEST_CASE("the length that frames settle at is foretold",
          "[1-test-case/too-long-a-frame][3 points]") {
  Student student;
  Random random;
  for (int n = 0; n < 6; ++n) {
    // Fast enough; too slow for its steps; fast enough for those, but not with its drawing.
    Machine machine = n % 3 == 0 ? draw_fast(random) : draw_machine(random, random.between(1.1, 4));
    if (n % 3 == 2) {
      machine.cost = random.between(0.5, 0.8) * machine.h;
      machine.draw = random.between(1.1, 2) * machine.most * (machine.h - machine.cost);
    }
    settles(student, machine, hint_for(machine));
  }
}

TEST_CASE("any frame is paid, and any machine is foretold, and two by turns",
          "[1-test-case/too-long-a-frame][1 point]") {
  Student student;
  Random random;
  const std::string exact = "What is left and the frame make just a step. Is it due?";
  for (int n = 1; n <= 8; ++n) {
    // Sixty-fourths and halves of them add up without rounding.
    const Machine machine{0.01, 0.01, 1.0 / 64, random.whole(1, 8)};
    spends(student, machine, 0.5 / 64, (n - 0.5) / 64, exact);
  }
  constexpr int pairs = 100, rounds = 2;
  for (int n = 0; n < pairs; ++n) {
    const double h = random.anywhere(harness_bounds::h);
    const Machine one = any_machine(random, h), other = any_machine(random, h);
    const Owed of_one = any_frame(random, one), of_other = any_frame(random, other);
    for (int round = 0; round < rounds; ++round)
      for (const auto& [machine, owed] : {std::pair{one, of_one}, std::pair{other, of_other}}) {
        spends(student, machine, owed.saved, owed.length,
               "All sizes go by the same sums. Which of these numbers is so small, or so large, "
               "that a line of yours does something of its own?");
        // Once is enough, as it may take long to let a machine settle.
        if (round == 0) settles(student, machine, hint_for(machine));
      }
  }
}
