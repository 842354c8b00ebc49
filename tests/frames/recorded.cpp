// SPDX-License-Identifier: MIT-0
#include "frames/recorded.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numeric>

using frames::recorded;

namespace {

/// The share of the frames for which `fits` holds.
template <class Fits>
double share(Fits fits) {
  return double(std::count_if(recorded.begin(), recorded.end(), fits)) / double(recorded.size());
}

}  // namespace

TEST_CASE("The recorded frames last ten seconds, and none of them takes no time") {
  CHECK(recorded.size() >= 500);
  CHECK(*std::min_element(recorded.begin(), recorded.end()) > 0);
  CHECK(std::accumulate(recorded.begin(), recorded.end(), 0.0) > 10);
}

TEST_CASE("The recorded frames are on average between 17 and 25 ms long") {
  const double mean =
      std::accumulate(recorded.begin(), recorded.end(), 0.0) / double(recorded.size());
  CHECK(mean > 0.017);
  CHECK(mean < 0.025);
}

TEST_CASE("Most recorded frames are near a sixtieth of a second, and one in fifty is a hitch") {
  CHECK(share([](double length) { return std::abs(length - 1.0 / 60) < 0.002; }) > 0.5);
  CHECK(share([](double length) { return length > 1.0 / 30; }) > 0.02);
  CHECK(share([](double length) { return length > 1.0 / 30; }) < 0.2);
}

TEST_CASE("The recorded frames are in seconds and in tenths of a millisecond") {
  for (const double length : recorded) {
    REQUIRE(length < 1);
    REQUIRE(std::abs(length * 1e4 - std::round(length * 1e4)) < 1e-9);
  }
}

TEST_CASE("A playback begins where it is told, and after the last frame comes the first") {
  frames::Playback frame{.at = recorded.size() - 2};
  CHECK(frame.next() == recorded[recorded.size() - 2]);
  CHECK(frame.next() == recorded.back());
  CHECK(frame.next() == recorded.front());
  CHECK(frame.next() == recorded[1]);
}
