// SPDX-License-Identifier: MIT-0
/// @file
/// The chart that `choose` draws: error against both prices, with the bound and the choice.
#pragma once
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>

#include "contest.h"

/// A program that reads from a pipe; ends with this.
class Pipe {
 public:
  /// @throws std::runtime_error  it can't be started
  explicit Pipe(const char* command) : pipe_(popen(command, "w")) {
    if (!pipe_) throw std::runtime_error(std::string("can't start ") + command);
  }
  ~Pipe() {
    if (pipe_) pclose(pipe_);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  /// Hands text on.
  void write(const std::string& text) { std::fputs(text.c_str(), pipe_); }

  /// Whether the program ended well.
  bool close() {
    const int status = pclose(pipe_);
    pipe_ = nullptr;
    return status == 0;
  }

 private:
  FILE* pipe_;
};

/// Text between single quotes, as gnuplot reads it.
inline std::string quoted(const std::string& text) {
  std::string inside;
  for (const char letter : text)
    inside += letter == '\'' ? std::string("''") : std::string(1, letter);
  return "'" + inside + "'";
}

/// One block for each method: evaluations a second, microseconds a frame, error.
inline std::string blocks_of(const Contest& found) {
  std::string data = "$tried << END\n";
  for (const Entry& entry : found.methods) {
    const double per_step = 1 / double(entry.last.substeps);
    for (const Attempt& tried : entry.on_the_way) {
      const double steps = per_step * double(tried.substeps);
      data += brief(steps * entry.evaluations, 17) + " " + brief(steps * entry.microseconds, 17) +
              " " + brief(tried.error, 17) + "\n";
    }
    data += "\n\n";
  }
  return data + "END\n";
}

/// A line for each method, the best of them thick.
/// @param column  of the price in blocks_of
inline std::string lines_of(const Contest& found, int column) {
  std::string plot = "plot bound with lines lc 'gray' dt 2 title 'bound'";
  for (std::size_t i = 0; i < found.methods.size(); ++i) {
    const Entry& entry = found.methods[i];
    if (column == 2 && std::isnan(entry.microseconds)) continue;
    plot += ", $tried index " + std::to_string(i) + " using " + std::to_string(column) +
            ":3 with linespoints lt " + std::to_string(i + 1) + (i == 0 ? " lw 4" : " lw 1.2") +
            " ps 0.5 title " + quoted(std::string(entry.method->function));
  }
  return plot + "\n";
}

/// Draws what was tried on the way, against both prices.
/// @throws std::runtime_error  one line that says what is missing
inline void draw_chart(const Contest& found, const Bounds& bounds, const std::string& file) {
  const std::string part = file + ".part";
  Pipe gnuplot("gnuplot >/dev/null 2>&1");
  gnuplot.write(
      "set terminal svg size 1000,460 dynamic enhanced font 'sans-serif,14' background rgb "
      "'white'\nset output " +
      quoted(part) + "\n" + blocks_of(found) +
      "set datafile missing 'nan'\nbound = " + brief(bounds.error, 17) +
      "\nset logscale xy\nset format y '10^{%T}'\nset yrange [*:1]\nset border 3\nset tics "
      "nomirror\nset key outside right top noenhanced samplen 2\nset multiplot\n"
      "set size 0.4,1\nset origin 0,0\nunset key\nset xlabel 'evaluations a second'\n"
      "set ylabel 'error, as a share of the motion'\n" +
      lines_of(found, 1) +
      "set size 0.6,1\nset origin 0.4,0\nset key\nset xlabel 'microseconds a frame, for 1000'\n"
      "unset ylabel\n" +
      lines_of(found, 2) + "unset multiplot\nset output\n");
  const bool drawn = gnuplot.close();
  std::error_code failed;
  if (drawn) std::filesystem::rename(part, file, failed);
  if (drawn && !failed) return;
  std::filesystem::remove(part, failed);
  throw std::runtime_error("can't draw " + file +
                           "; is gnuplot installed, and is the folder there and yours?");
}
