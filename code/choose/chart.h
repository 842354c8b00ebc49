// SPDX-License-Identifier: MIT-0
/// @file
/// The chart that `choose` draws: error against both prices, with the bound and the choice.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <system_error>

#include "choose/contest.h"

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

  /// Returns whether the program ended well.
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
inline std::string blocks_of(const Contest& found, const Bounds& bounds) {
  std::string data = "$tried << END\n";
  const auto row = [&](double evaluations, double microseconds, double error) {
    data += format_number(evaluations, 17) + " " + format_number(microseconds, 17) + " " +
            format_number(in_reported_units(error, bounds), 17) + "\n";
  };
  for (const Entry& entry : found.methods) {
    for (const Attempt& tried : entry.on_the_way) {
      const double part = double(tried.substeps) / double(entry.last.substeps);
      row(part * entry.evaluations, part * entry.microseconds, tried.error);
    }
    data += "\n\n";
  }
  for (const Entry& entry : found.undisturbed) {
    row(entry.evaluations, entry.microseconds, entry.last.error);
    data += "\n\n";
  }
  return data + "END\n";
}

/// The colours of those that are named, the best first; the others are grey.
inline constexpr std::array named{"#0b63b0", "#c8420a", "#00784f", "#8436b0"};

/// A line for each method, the best of them thick, and a point for adaptive steps.
/// @param found  all entries
/// @param column  of the price in blocks_of
inline std::string lines_of(const Contest& found, int column) {
  std::string plot = "plot bound with lines lc '#b0125b' dt 2 title 'bound'";
  const auto add = [&](std::size_t block, const std::string& look, const std::string& title) {
    plot += ", $tried index " + std::to_string(block) + " using " + std::to_string(column) +
            ":3 with " + look + (title.empty() ? " notitle" : " title " + quoted(title));
  };
  const std::size_t count = found.methods.size();
  for (std::size_t i = count; i-- > 0;) {
    const Entry& entry = found.methods[i];
    if (column == 2 && std::isnan(entry.microseconds)) continue;
    const bool is_named = i < named.size();
    const std::string colour = is_named ? named[i] : "#b8b2a8";
    add(i,
        "linespoints pt 7 ps " + std::string(is_named ? "0.8" : "0.25") + " lw " +
            (i == 0 ? "4" : "1.6") + " lc " + quoted(colour),
        is_named ? std::string(entry.method->function) : "");
  }
  for (std::size_t i = 0; i < found.undisturbed.size(); ++i) {
    const Entry& entry = found.undisturbed[i];
    if (column == 2 && std::isnan(entry.microseconds)) continue;
    add(count + i, "points pt 13 ps 1 lc '#3a3835'", std::string(entry.method->function));
  }
  return plot + "\n";
}

/// @throws std::invalid_argument  the folder of a file that is to be drawn is not there
inline void require_folder(const std::string& file) {
  const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
  if (!std::filesystem::is_directory(folder)) {
    throw std::invalid_argument("can't draw " + file + "; there is no folder " + folder.string());
  }
}

/// Gives a drawing the title that a browser shows, instead of gnuplot's own.
inline void entitle(const std::string& file, const std::string& title) {
  std::ifstream in(file);
  std::string text(std::istreambuf_iterator<char>(in), {});
  const std::string own = "<title>Gnuplot</title>";
  const auto found = text.find(own);
  if (found == text.npos) return;
  std::ofstream(file) << text.replace(found, own.size(), "<title>" + title + "</title>");
}

/// Draws what was tried on the way, against both prices.
/// @param found  all entries
/// @param bounds  what was asked for
/// @param scene  what it is called
/// @param file  that the drawing goes into, as SVG
/// @throws std::runtime_error  one line that says what is missing
inline void draw_chart(const Contest& found, const Bounds& bounds, const std::string& scene,
                       const std::string& file) {
  const std::string part = file + ".part";
  const std::string unit = bounds.reach > 0 ? " m" : " of the motion";
  const double bound = in_reported_units(bounds.error, bounds);
  const std::string title = scene + ", " + format_number(bounds.hz, 4) + " Hz, error at most " +
                            format_number(bound, 3) + unit;
  Pipe gnuplot("gnuplot >/dev/null 2>&1");
  gnuplot.write(
      "set terminal svg size 640,960 dynamic enhanced font 'sans-serif,17' background rgb "
      "'white'\nset output " +
      quoted(part) + "\n" + blocks_of(found, bounds) + "set datafile missing 'nan'\nbound = " +
      format_number(bound, 17) + "\nset logscale xy\nset format '10^{%T}'\nset yrange [*:" +
      format_number(in_reported_units(1, bounds), 17) +
      "]\nset border 3\nset tics nomirror\nset key outside top center horizontal maxcols 3 "
      "noenhanced samplen 1\n"
      "set ylabel " +
      quoted("error" + std::string(bounds.reach > 0 ? "  [m]" : ", as a share of the motion")) +
      "\nset multiplot layout 2,1 title " + quoted(title) +
      " noenhanced\nset xlabel 'evaluations a second'\n" + lines_of(found, 1) +
      "set xlabel 'microseconds a frame, for 1000'\nunset key\n" + lines_of(found, 2) +
      "unset multiplot\nset output\n");
  const bool drawn = gnuplot.close();
  std::error_code failed;
  if (drawn) entitle(part, title);
  if (drawn) std::filesystem::rename(part, file, failed);
  if (drawn && !failed) return;
  std::filesystem::remove(part, failed);
  throw std::runtime_error("can't draw " + file +
                           "; is gnuplot installed, and is the folder yours?");
}
