// SPDX-License-Identifier: MIT-0
#include "measure/times.h"

#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "measure/machine.h"

namespace measure {
namespace {

/// Time that all processors have worked for anybody [s].
double everybody() {
  std::ifstream stat("/proc/stat");
  std::string name;
  double user = 0, nice = 0, system = 0, idle = 0, waiting = 0, interrupts = 0, soft = 0;
  stat >> name >> user >> nice >> system >> idle >> waiting >> interrupts >> soft;
  return (user + nice + system + interrupts + soft) / double(sysconf(_SC_CLK_TCK));
}

/// Time that they have worked for this program [s].
double this_program() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  const auto seconds = [](const timeval& time) {
    return double(time.tv_sec) + 1e-6 * double(time.tv_usec);
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  char text[16];
  std::strftime(text, sizeof text, "%Y-%m-%d", std::gmtime(&now));
  return text;
}

constexpr const char* columns = "name,lower,median,upper";

}  // namespace

Quartiles quartiles(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto below = [&](double share) {
    const double place = share * double(values.size() - 1);
    const auto left = static_cast<std::size_t>(place);
    const std::size_t right = std::min(left + 1, values.size() - 1);
    return std::lerp(values[left], values[right], place - double(left));
  };
  return {below(0.25), below(0.5), below(0.75)};
}

bool Times::alone() const {
  return others < 0.05;
}

const Quartiles& Times::at(const std::string& name) const {
  const auto found = of.find(name);
  if (found == of.end()) throw std::out_of_range("no time is called " + name);
  return found->second;
}

Times take_times(const std::vector<Timed>& all, const std::string& compiler, int turns) {
  Times times{machine(), clock_rate(), compiler, today(), turns, 0, {}};
  std::vector<std::vector<double>> taken(all.size());
  const auto begin = std::chrono::steady_clock::now();
  const double before = everybody() - this_program();
  for (int turn = 0; turn < turns; ++turn) {
    for (std::size_t i = 0; i < all.size(); ++i) taken[i].push_back(1e9 * all[i].run());
  }
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
  times.others = std::max(0.0, (everybody() - this_program() - before) / elapsed.count());
  for (std::size_t i = 0; i < all.size(); ++i) times.of[all[i].name] = quartiles(taken[i]);
  return times;
}

void write_times(const Times& times, const std::filesystem::path& file) {
  const std::filesystem::path part = file.string() + ".part";
  std::ofstream out(part, std::ios::binary);
  out << "# Times of a step [ns]: what a quarter, a half and three quarters of the runs stayed "
         "below.\n"
      << "# processor: " << times.processor << "\n# clock: " << times.clock
      << "\n# compiler: " << times.compiler << "\n# date: " << times.date
      << "\n# runs: " << times.runs << "\n# others: " << std::setprecision(2) << times.others
      << "\n"
      << columns << "\n";
  for (const auto& [name, time] : times.of) {
    if (name.find(',') != name.npos)
      throw std::runtime_error("a time has a comma in its name: " + name);
    char numbers[96];
    std::snprintf(numbers, sizeof numbers, "%.4g,%.4g,%.4g", time.lower, time.median, time.upper);
    out << name << "," << numbers << "\n";
  }
  out.close();
  std::error_code failed;
  if (out) std::filesystem::rename(part, file, failed);
  if (!out || failed) throw std::runtime_error("can't write " + file.string());
}

Times read_times(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("can't read " + file.string());
  Times times;
  const std::map<std::string, std::string*> words{{"# processor", &times.processor},
                                                  {"# clock", &times.clock},
                                                  {"# compiler", &times.compiler},
                                                  {"# date", &times.date}};
  for (std::string line; std::getline(in, line);) {
    const auto colon = line.find(": ");
    const std::string head = line.substr(0, colon);
    if (const auto word = words.find(head); word != words.end()) {
      *word->second = line.substr(colon + 2);
    } else if (head == "# runs") {
      times.runs = std::stoi(line.substr(colon + 2));
    } else if (head == "# others") {
      times.others = std::stod(line.substr(colon + 2));
    }
    if (line.starts_with("#") || line == columns) continue;
    Quartiles time;
    const auto comma = line.find(',');
    if (comma == line.npos || std::sscanf(line.c_str() + comma, ",%lf,%lf,%lf", &time.lower,
                                          &time.median, &time.upper) != 3) {
      throw std::runtime_error(file.string() + ": no time in the line: " + line);
    }
    times.of[line.substr(0, comma)] = time;
  }
  return times;
}

const Times& recorded_times(const char* file) {
  static std::map<std::string, Times> read;
  const auto found = read.find(file);
  if (found != read.end()) return found->second;
  return read[file] = read_times(std::filesystem::path(RECORDED) / file);
}

}  // namespace measure
