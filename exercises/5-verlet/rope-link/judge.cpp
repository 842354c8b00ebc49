// SPDX-License-Identifier: MIT-0
#include <catch2/catch_test_macros.hpp>

#include "link.h"

using namespace judge;
using namespace judge::verlet;

namespace {

void check_link(Student& student, const Link& link, const std::string& what,
                const std::string& hint) {
  const std::vector<Vec> ends = link.by(student);
  const double size = length(link.a) + length(link.b) + link.rest;
  Asked asked{what, link.in_words(), rounding(size), hint, {}, {"end a", "end b"}};
  asked.remarks = {"your link is now " + grade::number(length(ends[1] - ends[0])) +
                   " m long; it was " + grade::number(length(link.b - link.a)) +
                   " m and should be " + grade::number(link.rest) + " m"};
  are_places(asked, ends, {"the link at its length", link.pulled()}, link.mistakes());
}

// Four links with a lantern at the lower end, from some shape at rest.
struct Chain {
  std::vector<Vec> x;
  std::vector<double> inverse;
  double rest = 0.3, h = 1.0 / 60;
  int steps = 12;

  static Chain draw(Random& random) {
    Chain chain{{random.vector(-1, 1)}, {0}};
    for (int i = 0; i < 4; ++i) {
      chain.x.push_back(chain.x.back() + random.vector(0.12, 0.2));
      chain.inverse.push_back(i < 3 ? random.between(5, 20) : random.between(0.3, 0.6));
    }
    return chain;
  }

  std::vector<Vec> by(Student& student) const {
    std::vector<double> request;
    for (const Vec& point : x) request.insert(request.end(), {point.x, point.y, point.z});
    request.insert(request.end(), inverse.begin(), inverse.end());
    request.insert(request.end(), {rest, h, static_cast<double>(steps)});
    return as_places(student.call(1, request, static_cast<std::size_t>(3 * steps)));
  }

  /// @param share  of the way, `(inverse_a, inverse_b) -> share of a`
  template <class Share>
  std::vector<Vec> by(Share share) const {
    std::vector<Vec> now = x, before = x, lowest;
    for (int n = 0; n < steps; ++n) {
      for (std::size_t i = 1; i < now.size(); ++i) {
        const Vec next = 2 * now[i] - before[i] - Vec{0, 9.81 * h * h, 0};
        before[i] = std::exchange(now[i], next);
      }
      for (std::size_t i = 1; i < now.size(); ++i) {
        const double of_a = i == 1 ? 0 : share(inverse[i - 1], inverse[i]);
        const std::vector<Vec> ends = Link{now[i - 1], now[i], rest, 0, 0}.moved(of_a, 1 - of_a);
        now[i - 1] = ends[0];
        now[i] = ends[1];
      }
      lowest.push_back(now.back());
    }
    return lowest;
  }

  std::string in_words() const {
    std::string text = "points";
    for (const Vec& point : x) text += " " + describe(point, 17);
    text += ", inverse masses";
    for (const double one : inverse) text += " " + grade::number(one, 17);
    return text + ", links of 0.3 m, 60 steps a second with one iteration each";
  }
};

}  // namespace

TEST_CASE("a link that is too long is drawn together by the masses of its ends",
          "[5-verlet/rope-link][3 points]") {
  Random random;
  Student student;
  check_link(student, Link::draw(random, true), "a link that is too long",
             "The two ways add up to what is too much, and the end with twice the inverse mass "
             "goes twice as far.");
}

TEST_CASE("a link that is too short is pushed apart by the masses of its ends",
          "[5-verlet/rope-link][2 points]") {
  Random random;
  Student student;
  check_link(student, Link::draw(random, false), "a link that is too short",
             "What is too much is now less than nothing. Does the same formula not do?");
}

TEST_CASE("a pinned end stays, and the other goes the whole way",
          "[5-verlet/rope-link][3 points]") {
  Random random;
  Student student;
  const std::string hint =
      "An inverse mass of zero is a mass without end. Its share is zero by the same formula; only "
      "where both are zero there is nothing to divide by.";
  for (const bool too_long : {true, false}) {
    Link link = Link::draw(random, too_long);
    link.inverse_a = 0;
    check_link(student, link, "a link whose end a is pinned", hint);
    link = Link::draw(random, too_long);
    link.inverse_b = 0;
    check_link(student, link, "a link whose end b is pinned", hint);
  }
  Link link = Link::draw(random, true);
  link.inverse_a = link.inverse_b = 0;
  are_places({"a link with both ends pinned",
              link.in_words(),
              {0, "nothing may move"},
              hint,
              {},
              {"end a", "end b"}},
             link.by(student), {"where they are", {link.a, link.b}}, {});
}

TEST_CASE("a lantern falls on its chain as it should", "[5-verlet/rope-link][2 points]") {
  Random random;
  const Chain chain = Chain::draw(random);
  Asked asked{"twelve frames of a chain of four links that is let go, with a lantern at its end",
              chain.in_words(),
              {},
              "Each of its links is pulled once in a frame. If the other tests hold, look for "
              "something that your function remembers from one link to the next.",
              {}};
  const Places expected{"the lantern", chain.by([](double a, double b) { return a / (a + b); })};
  asked.tolerance = rounding(chain.steps, 1 + length(expected.x.back()));
  for (int n = 1; n <= chain.steps; ++n) asked.times.push_back(n * chain.h);
  Student student;
  are_places(
      asked, chain.by(student), expected,
      {{"a chain whose ends all weigh the same", chain.by([](double, double) { return 0.5; })},
       {"a chain whose heavier ends move further",
        chain.by([](double a, double b) { return b / (a + b); })}});
}
