// SPDX-License-Identifier: MIT-0
/// @file
/// Pictures, one after the other, and a page that plays them.
#pragma once
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <string>

#include "play/player.h"

/// What the programs called play.cpp draw with; nothing else in the book needs it.
namespace play {

// [vec]
/// A place, or a velocity, in the picture: x to the right, y up [m].
struct Vec {
  double x = 0, y = 0;
};
constexpr Vec operator+(Vec a, Vec b) {
  return {a.x + b.x, a.y + b.y};
}
constexpr Vec operator-(Vec a, Vec b) {
  return {a.x - b.x, a.y - b.y};
}
constexpr Vec operator*(double s, Vec a) {
  return {s * a.x, s * a.y};
}
inline double length(Vec a) {
  return std::sqrt(a.x * a.x + a.y * a.y);
}
// [vec]

// [film]
/// Collects pictures, and writes them as one page.
///
/// A shape has the colour of the method that moves it, by its name: "Euler", "RK4". "true" is the
/// colour of what should happen, and "scenery" that of everything else.
class Film {
  Vec low, high;
  double speed;
  std::ostringstream pictures, names;
  std::map<std::string, std::size_t> numbers;  // of the colours, which are written once

  std::ostream& shape(const char* kind, Vec at, const std::string& colour) {
    const auto [known, is_new] = numbers.try_emplace(colour, numbers.size());
    if (is_new) names << '\'' << colour << "',";
    return pictures << ",['" << kind << "'," << known->second << ',' << at.x << ',' << at.y;
  }

 public:
  /// @param from, to  opposite corners of what the pictures show, the lower left one first [m]
  /// @param pace  how many seconds of the game are played in one
  Film(Vec from, Vec to, double pace = 1) : low(from), high(to), speed(pace) {
    pictures.precision(4);
  }

  /// Begins a picture, which stands for so many seconds of the game.
  void picture(double seconds) { pictures << "],\n[" << seconds; }

  void circle(Vec centre, double radius, const std::string& colour) {
    shape("circle", centre, colour) << ',' << radius << ']';
  }
  void line(Vec from, Vec to, const std::string& colour) {
    shape("line", from, colour) << ',' << to.x << ',' << to.y << ']';
  }
  /// Draws on, from where the same trail was in the picture before.
  void trail(Vec to, const std::string& colour) { shape("trail", to, colour) << ']'; }
  /// Writes words below each other if there are others beside them and too little room.
  void label(Vec centre, const std::string& words) {
    shape("label", centre, "scenery") << ",'" << words << "']";
  }

  /// The page, as text.
  std::string page() const {
    std::ostringstream text;
    text << player_head << "const view = [" << low.x << ", " << low.y << ", " << high.x << ", "
         << high.y << "], speed = " << speed << ", names = [" << names.str() << "], pictures = [[0"
         << pictures.str() << "]];" << player_tail;
    return text.str();
  }

  /// Writes the page, and says where it is.
  /// @returns what main returns: 0, or 1 if the file can't be written
  int write(const std::string& file) const {
    std::ofstream out(file);
    out << page();
    if (out.close(); !out)
      return std::cerr << "can't write " << file << "; is its folder there?\n", 1;
    return std::cout << "Open " << file << " in a browser.\n", 0;
  }
};
// [film]

}  // namespace play
