// SPDX-License-Identifier: MIT-0
/// @file
/// What a live figure computes: settings in, a run of steps, values out.
#pragma once
#include <memory>
#include <span>
#include <string_view>
#include <vector>

/// The figures that run in the page: the book's own methods and scenes, compiled for the browser.
namespace live {

/// Something that the reader sets.
struct Setting {
  const char* name;
  double* value;                       ///< where it is kept; of a choice, its place in the list
  std::vector<const char*> choices{};  ///< none for a number
};

/// Something that the page draws or tells: a number, or many.
struct Shown {
  const char* name;
  std::vector<double> values;
  bool reproducible;  ///< whether every machine computes the same bits
  long changes = 0;   ///< how often they were shown
};

/// A live figure. The page sets its settings, calls begin() once and advance() many times, and
/// draws what is shown. It must show "t", the time [s], and "h", the length of the next step [s].
class Figure {
 public:
  virtual ~Figure() = default;

  /// What the reader sets, and "own": what stands in the place of a method, by the names of own.h.
  std::vector<Setting> all_settings();
  /// Begins a run with the settings as they are, and shows its start.
  void begin();
  /// Takes steps and shows where they lead.
  /// @param steps  how many
  void advance(int steps);
  /// Work whose time the page takes: rounds of a loop over many bodies, each of them a step.
  /// @param which  method
  /// @param rounds  steps of each body
  /// @return something that depends on all of it
  virtual double work(int which, int rounds);
  /// Bodies in that loop; none where nothing is timed.
  virtual int bodies() const { return 0; }
  /// What stands there to be drawn, always under the same names in the same order.
  const std::vector<Shown>& shown() const { return shown_; }

 protected:
  Figure() = default;
  Figure(const Figure&) = default;
  Figure& operator=(const Figure&) = default;

  /// The settings of this figure.
  virtual std::vector<Setting> settings() = 0;
  /// Begins a run.
  virtual void start() = 0;
  /// One step of the method.
  virtual void step() = 0;
  /// Calls show() for all that changes with a step.
  virtual void show_state() = 0;

  /// Shows values that are computed by + - * / and square roots alone, and so to the same bits
  /// everywhere.
  void show(const char* name, std::span<const double> values) { put(name, values, true); }
  /// The same for one number.
  void show(const char* name, double value) { put(name, {&value, 1}, true); }
  /// Shows values in which the C library's sine, exponential or logarithm had a part.
  void show_reference(const char* name, std::span<const double> values) {
    put(name, values, false);
  }
  /// The same for one number.
  void show_reference(const char* name, double value) { put(name, {&value, 1}, false); }

 private:
  void put(const char* name, std::span<const double> values, bool reproducible);

  std::vector<Shown> shown_;
  double own_ = 0;  // place in names_of_stands()
};

/// A figure by its name: chapters/N/live/NAME.cpp defines make_NAME(), with _ for each -.
struct Entry {
  const char* name;
  std::unique_ptr<Figure> (*make)();
};

/// All live figures of the book; CMake lists the files that are there.
std::span<const Entry> figures();

}  // namespace live
