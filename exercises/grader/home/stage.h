// SPDX-License-Identifier: MIT-0
/// @file
/// The film of a student's code.
#pragma once
#include <map>
#include <string>

#include "harness/given.h"
#include "play.h"

namespace grade {

/// What the pictures of a film show.
struct View {
  play::Vec from, to;  ///< opposite corners, the lower left one first [m]
  double pace = 1;     ///< how many seconds of the game are played in one
};

/// A film whose shapes stay somewhere, whatever the code that moves them answers: what is no number
/// stands where it was last, and what has left the picture stays near it.
///
/// Colours are the film's names: "yours", "true" and "scenery". Of a place, x and y are seen.
class Stage {
 public:
  explicit Stage(const View& view);

  /// Begins a picture, which stands for so many seconds of the game.
  void picture(double seconds);

  /// @param name  of the thing, by which it is found in the picture before
  void ball(const std::string& name, const Vec& at, double radius, const std::string& colour);
  void line(const Vec& from, const Vec& to, const std::string& colour);

  /// @param size  its width and its height [m]
  void box(const std::string& name, const Vec& centre, const Vec& size, const std::string& colour);

  /// Draws on, from where the same trail was in the picture before. All pictures have the same
  /// trails, in the same order.
  void trail(const std::string& name, const Vec& to, const std::string& colour);

  // A thing of the student's, and the same as it should be: as a ring around it, or hidden by it,
  // if it is right.
  void balls(const std::string& name, const Vec& yours, const Vec& right, double radius);
  void boxes(const std::string& name, const Vec& yours, const Vec& right, const Vec& size);
  void trails(const std::string& name, const Vec& yours, const Vec& right);
  void lines(const Vec& from, const Vec& yours, const Vec& right);

  void label(const Vec& centre, const std::string& words);

  /// The page of what was drawn.
  std::string page() const { return film_.page(); }

 private:
  play::Vec seen(const std::string& name, const Vec& at);

  View view_;
  play::Film film_;
  std::map<std::string, play::Vec> last_;
};

/// The nearest number between these two, and the lower one for what is none: a student's answer
/// that is counted by, or handed on to another of the student's functions.
double within(double value, double low, double high);

/// A number in a label; a dash if it is none.
std::string shown(double value, int digits = 3);

}  // namespace grade
