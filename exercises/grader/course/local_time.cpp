// SPDX-License-Identifier: MIT-0
#include "course/local_time.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <regex>
#include <system_error>

#include "command_line.h"
#include "nearest.h"
#include "printable.h"

namespace grade {
namespace {

namespace chrono = std::chrono;

std::filesystem::path zones() {
  return "/usr/share/zoneinfo";
}

/// The C library has one time zone. It is another for as long as this lives.
class Clocks {
 public:
  explicit Clocks(const std::string& variable) {
    if (const char* before = std::getenv("TZ")) before_ = before;
    setenv("TZ", variable.c_str(), 1);
    tzset();
  }
  ~Clocks() {
    if (before_)
      setenv("TZ", before_->c_str(), 1);
    else
      unsetenv("TZ");
    tzset();
  }
  Clocks(const Clocks&) = delete;
  Clocks& operator=(const Clocks&) = delete;

 private:
  std::optional<std::string> before_;
};

bool is_zone(const std::string& name) {
  const auto plain = [](unsigned char c) {
    return std::isalnum(c) != 0 || std::string_view("_+-/").find(char(c)) != std::string_view::npos;
  };
  if (name.empty() || name[0] == '/' || !std::ranges::all_of(name, plain)) return false;
  std::error_code none;
  if (!std::filesystem::is_regular_file(zones() / name, none)) return false;
  char magic[4] = {};
  std::ifstream(zones() / name).read(magic, sizeof magic);
  return std::string_view(magic, sizeof magic) == "TZif";
}

std::string nearest_zone(const std::string& name) {
  std::vector<std::string> names;
  std::error_code none;
  for (const auto& found : std::filesystem::recursive_directory_iterator(zones(), none)) {
    const std::string zone = found.path().lexically_relative(zones()).string();
    const bool copy = zone.starts_with("posix/") || zone.starts_with("right/");
    if (!copy && zone.find('.') == zone.npos && found.is_regular_file(none)) names.push_back(zone);
  }
  return nearest(name, names);
}

[[noreturn]] void refuse_zone(const std::string& name) {
  if (!std::filesystem::exists(zones() / "Europe"))
    throw Usage("this machine knows no time zone but UTC; install tzdata");
  const std::string near = nearest_zone(name);
  throw Usage(
      "there is no time zone '" + printable_name(name) + "'; " +
      (near.empty() ? "write one such as 'Europe/Berlin'" : "did you mean '" + near + "'?"));
}

/// The number that a part of the text is; 0 if that is empty.
int part(const std::smatch& parts, std::size_t i) {
  return parts[i].length() == 0 ? 0 : std::atoi(parts[i].str().c_str());
}

std::optional<chrono::minutes> offset_from(const std::string& text) {
  if (text.empty()) return std::nullopt;
  if (text == "Z") return chrono::minutes(0);
  const int far =
      60 * std::atoi(text.substr(1, 2).c_str()) + std::atoi(text.substr(text.size() - 2).c_str());
  return chrono::minutes(text[0] == '-' ? -far : far);
}

}  // namespace

Instant now() {
  return chrono::floor<chrono::seconds>(chrono::system_clock::now());
}

TimeZone::TimeZone(const std::string& name) : name_(name) {
  if (name == "UTC") {
    variable_ = "UTC0";
    return;
  }
  if (!is_zone(name)) refuse_zone(name);
  variable_ = ":" + (zones() / name).string();
}

chrono::seconds TimeZone::offset(Instant at) const {
  const Clocks here(variable_);
  const std::time_t time = at.time_since_epoch().count();
  std::tm shown{};
  localtime_r(&time, &shown);
  return chrono::seconds(shown.tm_gmtoff);
}

LocalTime TimeZone::local(Instant at) const {
  return LocalTime(at.time_since_epoch() + offset(at));
}

std::vector<Instant> TimeZone::instants(LocalTime shown) const {
  const Instant as_if_utc(shown.time_since_epoch());
  std::vector<Instant> found;
  // No place is further from UTC than a day, and no clock is changed twice within two.
  for (const Instant around : {as_if_utc - chrono::days(1), as_if_utc + chrono::days(1)}) {
    const Instant at = as_if_utc - offset(around);
    if (local(at) == shown && (found.empty() || found.back() != at)) found.push_back(at);
  }
  if (found.size() == 2 && found[0] > found[1]) std::swap(found[0], found[1]);
  return found;
}

Instant TimeZone::latest(LocalTime shown) const {
  const std::vector<Instant> found = instants(shown);
  if (!found.empty()) return found.back();
  const Instant as_if_utc(shown.time_since_epoch());
  return as_if_utc - offset(as_if_utc - chrono::days(1));
}

std::string shown(LocalTime time) {
  const auto day = chrono::floor<chrono::days>(time);
  const chrono::year_month_day date(day);
  const chrono::hh_mm_ss clock(time - day);
  char text[64], rest[8] = "";
  if (clock.seconds().count() != 0)
    std::snprintf(rest, sizeof rest, ":%02d", int(clock.seconds().count()));
  std::snprintf(text, sizeof text, "%04d-%02u-%02u %02d:%02d%s", int(date.year()),
                unsigned(date.month()), unsigned(date.day()), int(clock.hours().count()),
                int(clock.minutes().count()), rest);
  return text;
}

std::optional<WrittenTime> time_from(const std::string& text) {
  static const std::regex form(
      R"((\d{4})-(\d\d)-(\d\d)[T ](\d\d):(\d\d)(?::(\d\d)(?:\.\d+)?)?(Z|[+-]\d\d:?\d\d)?)");
  std::smatch parts;
  if (!std::regex_match(text, parts, form)) return std::nullopt;
  const chrono::year_month_day date(chrono::year(part(parts, 1)),
                                    chrono::month(unsigned(part(parts, 2))),
                                    chrono::day(unsigned(part(parts, 3))));
  if (!date.ok() || part(parts, 4) > 23 || part(parts, 5) > 59 || part(parts, 6) > 59) return {};
  const LocalTime local = chrono::local_days(date) + chrono::hours(part(parts, 4)) +
                          chrono::minutes(part(parts, 5)) + chrono::seconds(part(parts, 6));
  return WrittenTime{local, offset_from(parts[7].str())};
}

std::string duration(chrono::seconds time) {
  const auto whole = time.count();
  constexpr long minute = 60, hour = 60 * minute, day = 24 * hour;
  if (whole < minute) return std::to_string(whole) + " s";
  std::string text;
  const auto add = [&](long count, const std::string& unit) {
    if (count > 0) text += (text.empty() ? "" : " ") + std::to_string(count) + unit;
  };
  add(whole / day, whole < 2 * day ? " day" : " days");
  add(whole % day / hour, " h");
  add(whole % hour / minute, " min");
  if (whole < hour) add(whole % minute, " s");
  return text;
}

}  // namespace grade
