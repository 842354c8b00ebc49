// SPDX-License-Identifier: MIT-0
#include "class/progress.h"

#include <cmath>
#include <cstdio>

#include "printable.h"
#include "report/words.h"

namespace grade {
namespace {

std::string bar(std::size_t done, std::size_t all) {
  constexpr std::size_t width = 30;
  const std::size_t full = done * width / all;
  return std::string(full, '#') + std::string(width - full, '.');
}

std::string minutes(double seconds) {
  char text[32];
  const long whole = std::lround(seconds);
  std::snprintf(text, sizeof text, "%ld:%02ld", whole / 60, whole % 60);
  return text;
}

}  // namespace

Progress::Progress(std::size_t all, bool on_terminal)
    : all_(all), on_terminal_(on_terminal), start_(std::chrono::steady_clock::now()) {}

void Progress::done(const Job& job, const Report& report) {
  ++done_;
  const std::string count = std::to_string(done_) + "/" + std::to_string(all_);
  if (!on_terminal_) {
    std::printf("[%s] %s %s: %s\n", count.c_str(), printable_name(job.student.name).c_str(),
                job.exercise.name.c_str(), headline(report).c_str());
    std::fflush(stdout);
    return;
  }
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
  const double left = spent.count() / double(done_) * double(all_ - done_);
  std::printf("\r[%s] %s, %s left ", bar(done_, all_).c_str(), count.c_str(),
              minutes(left).c_str());
  if (done_ == all_) std::printf("\n");
  std::fflush(stdout);
}

}  // namespace grade
