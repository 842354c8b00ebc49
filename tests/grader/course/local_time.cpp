// SPDX-License-Identifier: MIT-0
#include "course/local_time.h"

#include <catch2/catch_test_macros.hpp>
#include <cstdlib>

#include "command_line.h"

using namespace grade;
using namespace std::chrono_literals;

namespace {

LocalTime local(const std::string& text) {
  return time_from(text).value().local;
}

Instant utc(const std::string& text) {
  return Instant(local(text).time_since_epoch());
}

std::string refusal(const std::string& zone) {
  try {
    const TimeZone none(zone);
  } catch (const Usage& problem) {
    return problem.what();
  }
  return "";
}

}  // namespace

TEST_CASE("clocks in Berlin are an hour before UTC in winter, and two in summer") {
  const TimeZone berlin("Europe/Berlin");
  CHECK(berlin.instants(local("2027-02-08T23:59:00")) == std::vector{utc("2027-02-08T22:59")});
  CHECK(berlin.instants(local("2027-07-08T23:59:00")) == std::vector{utc("2027-07-08T21:59")});
  CHECK(shown(berlin.local(utc("2027-12-31T23:30:05"))) == "2028-01-01 00:30:05");
}

TEST_CASE("a time that clocks leap over is none, and one that comes again is two") {
  const TimeZone berlin("Europe/Berlin");
  CHECK(berlin.instants(local("2027-03-28T02:30")).empty());
  CHECK(berlin.latest(local("2027-03-28T02:30")) == utc("2027-03-28T01:30"));
  const std::vector<Instant> twice{utc("2027-10-31T00:30"), utc("2027-10-31T01:30")};
  CHECK(berlin.instants(local("2027-10-31T02:30")) == twice);
  CHECK(berlin.latest(local("2027-10-31T02:30")) == twice[1]);
}

TEST_CASE("half an hour's change, a day's leap and places far from UTC are told as they are") {
  const TimeZone howe("Australia/Lord_Howe"), samoa("Pacific/Apia"), chatham("Pacific/Chatham");
  CHECK(howe.instants(local("2027-10-03T02:15")).empty());
  CHECK(howe.instants(local("2027-04-04T01:45")).size() == 2);
  CHECK(samoa.instants(local("2011-12-30T12:00")).empty());
  CHECK(chatham.instants(local("2027-01-15T12:00")) == std::vector{utc("2027-01-14T22:15")});
}

TEST_CASE("UTC is known without tzdata, and a time of another century is as good as any") {
  const TimeZone zone("UTC");
  CHECK(zone.instants(local("2999-02-08T23:59")) == std::vector{utc("2999-02-08T23:59")});
  CHECK(now() < utc("2999-02-08T23:59"));
}

TEST_CASE("the machine's own time zone is as it was, and does not matter") {
  setenv("TZ", "America/New_York", 1);
  CHECK(shown(TimeZone("Asia/Tokyo").local(utc("2027-01-01T00:00"))) == "2027-01-01 09:00");
  CHECK(std::string(std::getenv("TZ")) == "America/New_York");
  unsetenv("TZ");
  CHECK(shown(TimeZone("Asia/Tokyo").local(utc("2027-01-01T00:00"))) == "2027-01-01 09:00");
  CHECK(std::getenv("TZ") == nullptr);
}

TEST_CASE("a time zone that is none is refused, with the nearest") {
  CHECK(refusal("Europe/Berln") ==
        "there is no time zone 'Europe/Berln'; did you mean 'Europe/Berlin'?");
  CHECK(refusal("../../etc/passwd").starts_with("there is no time zone '../../etc/passwd'"));
  CHECK(refusal("/usr/share/zoneinfo/Europe/Berlin").starts_with("there is no time zone"));
  CHECK(refusal("tzdata.zi").starts_with("there is no time zone"));
  CHECK(refusal("Europe").starts_with("there is no time zone"));
  CHECK(refusal("").starts_with("there is no time zone"));
}

TEST_CASE("a time is read as ISO 8601 has it, and nothing else is") {
  CHECK(shown(local("2027-02-08 23:59")) == "2027-02-08 23:59");
  CHECK(shown(local("2027-02-08T23:59:07.25")) == "2027-02-08 23:59:07");
  CHECK(time_from("2027-02-08T23:59:00Z")->offset == 0min);
  CHECK(time_from("2027-02-08T23:59:00+05:30")->offset == 330min);
  CHECK(time_from("2027-02-08T23:59:00-0800")->offset == -480min);
  CHECK(!time_from("2027-02-08T23:59:00")->offset);
  for (const char* none :
       {"", "2027-02-08", "8.2.2027 23:59", "2027-02-30T12:00", "2027-02-08T24:00",
        "2027-02-08T23:60", "2027-02-08T23:59 CET", "x2027-02-08T23:59"})
    CHECK(!time_from(none));
}

TEST_CASE("a duration is said in days, hours and minutes, and in seconds below an hour") {
  CHECK(duration(40s) == "40 s");
  CHECK(duration(5min) == "5 min");
  CHECK(duration(2h + 5min + 59s) == "2 h 5 min");
  CHECK(duration(24h) == "1 day");
  CHECK(duration(24h + 59s) == "1 day");
  CHECK(duration(24h + 1min) == "1 day 1 min");
  CHECK(duration(5min + 20s) == "5 min 20 s");
  CHECK(duration(75h) == "3 days 3 h");
}
