// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>

#include "format_values.h"
#include "harness.h"
#include "judge/random.h"
#include "judge/session.h"
#include "judge/tests.h"
#include "machine.h"

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

// A rest that differs by a whole step is the same place of the picture, and rounding may choose.
double rest_apart(double a, double b, double h) {
  return std::abs(std::remainder(a - b, h));
}

Tolerance rest_tolerance(double length, double h) {
  const double sums = length / h + 4;
  return {sums * length * std::numeric_limits<double>::epsilon(),
          "rounding: one sum for each step that the frame covers"};
}

// What was made of a frame by mistake: the first that fits, as the others may follow from it.
std::vector<std::string> recognise(const Frame& got, const Machine& machine, double saved,
                                   double rest) {
  const double h = machine.h, all = saved + got.length, most = machine.most * h;
  const double due = std::floor(all / h), steps = std::min<double>(due, machine.most);
  const double within = rest_tolerance(all, h).value, cut = saved + std::min(got.length, most);
  const double in_steps = saved + got.length / h;
  if (got.steps == std::floor(cut / h) && rest_apart(got.saved, cut, h) <= within)
    return {"the time is cut before it is counted, and so the part of a step is another"};
  if (due >= machine.most && std::abs(got.steps * h + got.saved - most) <= within)
    return {
        "what is owed is cut to `most` steps: beyond them the part of a step is dropped, too, and "
        "only whole ones may be"};
  if (got.steps == std::min<double>(std::floor(in_steps), machine.most) &&
      rest_apart(got.saved, in_steps, 1) <= within / h)
    return {"what is saved is in steps here; it is asked for in seconds"};
  if (got.steps > machine.most)
    return {"more steps than a frame may take: is there a limit at all, and is it `most`?"};
  if (got.steps == steps - 1 && got.saved == h)
    return {"a step is due as soon as its time is there, and nothing is left over then"};
  if (got.steps < steps) return {"fewer steps than are due, though it may take them"};
  if (got.saved > h && rest_apart(got.saved, rest, h) <= within)
    return {"the debt is kept, and the next frames have to pay it"};
  if (got.saved == 0) return {"the part of a step is dropped, too"};
  return {};
}

void spends(Student& student, const Machine& machine, double saved, double length,
            const std::string& hint) {
  const Frame got = spend(student, machine, saved, length);
  const double due = std::floor((saved + length) / machine.h);
  const double steps = std::min<double>(due, machine.most), rest = saved + length - due * machine.h;
  const Tolerance tolerance = rest_tolerance(saved + length, machine.h);

  grade::Finding finding;
  finding.held = got.steps == steps && std::abs(got.saved - rest) <= tolerance.value;
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
    finding.diagnoses = recognise(got, machine, saved, rest);
  }
  check(finding);
}

std::string hint_for(const Machine& machine) {
  return machine.cost < machine.h
             ? "A frame F asks for F/h steps, if so many are allowed. When is F the same again?"
             : "A step costs as much as it covers, or more: every frame takes all the steps it "
               "may.";
}

// With all that may be asked, each beside what is drawn, and one whose steps cost just what they
// cover. None needs many frames to settle.
std::vector<Machine> special_machines(Random& random) {
  std::vector<Machine> machines;
  const double share = random.between(0.3, 0.7);
  const auto drawn = [&] { return draw_machine(random, share); };
  for (const double draw : harness_bounds::draw.asked()) {
    machines.push_back(drawn());
    machines.back().draw = draw;
  }
  for (const double cost : harness_bounds::cost.asked()) {
    machines.push_back(drawn());
    machines.back().cost = cost;
    if (cost == harness_bounds::sixty_fourth) machines.back().h = cost;
  }
  for (const double h : harness_bounds::h.asked())
    machines.push_back({random.between(0.3, 1.2) * h, share * h, h, 5});
  for (const double most : harness_bounds::most.asked()) {
    machines.push_back(drawn());
    machines.back().most = static_cast<int>(most);
  }
  return machines;
}

// The next frame is as long as this one.
void settles(Student& student, const Machine& machine, const std::string& hint) {
  const double got = student.call(
      1, {machine.draw, machine.cost, machine.h, static_cast<double>(machine.most)}, 1)[0];
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
    finding.diagnoses = recognise(got, machine);
  }
  check(finding);
}

// A frame of so many steps and a part of one.
void spends(Student& student, const Machine& machine, double saved, double steps) {
  spends(student, machine, saved, steps * machine.h - saved,
         "Count what fits, take what is allowed, and leave in saved what is less than a step.");
}

// All that may be asked, each beside what is drawn.
void spends_all(Student& student, Random& random) {
  const auto steps = [&](int low, int high) {
    const int whole = random.whole(low, high);
    return whole + random.between(0.55, 0.95);
  };
  for (const double h : harness_bounds::h.asked()) spends(student, {0, 0, h, 7}, 0, steps(11, 20));
  for (const double most : harness_bounds::most.asked()) {
    const double h = 1 / random.between(100, 200);
    spends(student, {0, 0, h, static_cast<int>(most)}, 0, most + steps(2, 9));
  }
  const double most_saved = harness_bounds::saved.largest(),
               h = most_saved / random.between(0.82, 0.95);
  spends(student, {0, 0, h, 5}, most_saved, steps(2, 5));
}

// Frames without a length, of the longest, and of just one step or so many: powers of two add up
// without rounding.
void spends_special(Student& student, Random& random) {
  const std::string hint = "A step is due when all of its time is there, and not before.";
  Machine machine = draw_machine(random, 1);
  const double part = random.between(0.55, 0.95) * machine.h;
  spends(student, machine, part, harness_bounds::length.smallest(), hint);
  const double longest = harness_bounds::length.largest();
  machine.h = longest / (200 + random.between(0.55, 0.95));
  spends(student, machine, 0, longest, hint);
  machine.h = harness_bounds::sixty_fourth;
  for (const int steps : {1, machine.most, machine.most + 1})
    spends(student, machine, 0, steps * machine.h, hint);
}

}  // namespace

TEST_CASE("no frame takes more steps than it may, and a hitch is forgotten",
          "[1-test-case/too-long-a-frame][3 points]") {
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
  spends_all(student, random);
  spends_special(student, random);
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
  for (const Machine& machine : special_machines(random))
    settles(student, machine, hint_for(machine));
}
