// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>

#include "scene.h"

using namespace judge;
using namespace judge::verlet;
using namespace judge::verlet::rope_link;

namespace {

// Checks a pull, and returns the link after it.
Link check_link(Student& student, const Link& link, const std::string& what,
                const std::string& hint, Look look = Look::all) {
  const Link after = link.after(student);
  grade::Finding finding = pulled(link, after, what, look);
  if (!finding.held) {
    finding.hint = hint;
  }
  check(finding);
  return after;
}

// Four links with a lantern at the end, held up above the hook and let go: they fall together
// first, and then hang in each other.
struct Chain {
  std::vector<Vec> x, x_previous;
  std::vector<double> inverse;

  static Chain draw(Random& random) {
    Chain chain{{random.vector(-1, 1)}, {}, {0}};
    for (int i = 0; i < 4; ++i) {
      chain.x.push_back(chain.x.back() + random.vector(0.13, 0.16));
      chain.inverse.push_back(i < 3 ? random.between(5, 20) : random.between(0.3, 0.6));
    }
    chain.x_previous = chain.x;
    return chain;
  }

  void fall(double h) {
    for (std::size_t i = 1; i < x.size(); ++i) {
      const Vec distance = x[i] - x_previous[i];
      x_previous[i] = x[i];
      x[i] += distance - Vec{0, 9.81 * h * h, 0};
    }
  }

  Link link(std::size_t i) const { return {x[i - 1], x[i], 0.2, 0.3, inverse[i - 1], inverse[i]}; }
};

}  // namespace

TEST_CASE("a link that is too long is drawn together to its longest, by the masses of its ends",
          "[5-verlet/rope-link][1 point]") {
  Random random;
  Student student;
  const std::string hint =
      "The two ways add up to what is too much, and the end with twice the inverse mass goes twice "
      "as far.";
  check_link(student, Link::too_long(random), "a link that is too long", hint);
  for (const double inverse : harness_bounds::inverse.asked()) {
    Link link = Link::too_long(random);
    link.inverse_a = inverse;
    check_link(student, link, "a link with inverse_a = " + grade::number(inverse), hint);
    std::swap(link.inverse_a, link.inverse_b);
    check_link(student, link, "a link with inverse_b = " + grade::number(inverse), hint);
  }
  Link alike = Link::too_long(random);
  alike.inverse_a = alike.inverse_b;
  check_link(student, alike, "a link whose ends weigh the same", hint);
}

TEST_CASE("a link that is too short is pushed apart to its shortest, by the masses of its ends",
          "[5-verlet/rope-link][1 point]") {
  Random random;
  Student student;
  check_link(student, Link::too_short(random), "a link that is too short",
             "What is too much is now less than nothing. Does the same formula not do?");
}

TEST_CASE("a link moves when it has no play left, and not before",
          "[5-verlet/rope-link][3 points]") {
  Random random;
  Student student;
  const auto check = [&](const Link& link, const std::string& what) {
    check_link(student, link, what,
               "Two bounds, and between them nothing to do. Which length should the link have?",
               Look::length);
  };
  const double some = random.between(0.1, 0.4);
  check(Link::too_long(random), "a link that is too long");
  check(Link::too_short(random), "a link that is too short");
  check(Link::draw(random, 1 - some, 1 + some), "a link within its play");
  for (const double more : {1e-3, -1e-3, 1e-6, -1e-6}) {
    const std::string side = more > 0 ? "inside" : "outside";
    check(Link::draw(random, 1 - some, 1 + more), "a link just " + side + " longest");
    check(Link::draw(random, 1 - more, 1 + some), "a link just " + side + " shortest");
  }
  for (const Link& link : Link::at_the_bounds(random))
    check(link, "a link of " + grade::number(link.length_now()) + " m");
}

TEST_CASE("a pinned end stays, and the other goes the whole way",
          "[5-verlet/rope-link][3 points]") {
  Random random;
  Student student;
  const std::string hint =
      "An inverse mass of zero is a mass without end. Its share is zero by the same formula; only "
      "where both are zero there is nothing to divide by.";
  for (const bool too_long : {true, false}) {
    const Link link = too_long ? Link::too_long(random) : Link::too_short(random);
    Link pinned = link;
    pinned.inverse_a = 0;
    check_link(student, pinned, "a link whose end a is pinned", hint);
    pinned.inverse_b = 0;
    check_link(student, pinned, "a link with both ends pinned", hint);
    pinned.inverse_a = link.inverse_a;
    check_link(student, pinned, "a link whose end b is pinned", hint);
  }
}

TEST_CASE("any link is pulled right, wherever it hangs, however long, whatever its ends weigh",
          "[5-verlet/rope-link][1 point]") {
  Random random;
  Student student;
  constexpr int links = 1000;
  for (int n = 0; n < links; ++n)
    check_link(student, Link::anywhere(random), "one of many links of all kinds",
               "Which of these numbers is so large, so small or so equal to another that a line of "
               "yours does something of its own?");
}

TEST_CASE("every pull is right while a lantern falls on its chain",
          "[5-verlet/rope-link][1 point]") {
  Random random;
  Student student;
  Chain chain = Chain::draw(random);
  for (int frame = 1; frame <= 24; ++frame) {
    chain.fall(1.0 / 60);
    for (std::size_t i = 1; i < chain.x.size(); ++i) {
      const Link after =
          check_link(student, chain.link(i),
                     "link " + std::to_string(i) + " in frame " + std::to_string(frame) +
                         " of a chain of four links that is let go, with a lantern at its end",
                     "Each link is pulled once in a frame. Put this one into your function.");
      chain.x[i - 1] = after.a;
      chain.x[i] = after.b;
    }
  }
}
