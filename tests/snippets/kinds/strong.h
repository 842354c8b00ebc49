// SPDX-License-Identifier: MIT-0
// A number type of its own, which no bare number turns into by itself.
#pragma once

namespace kinds {

class Strong {
 public:
  explicit constexpr Strong(double number) : number_(number) {}
  constexpr double number() const { return number_; }

 private:
  double number_;
};
struct Strongs {
  Strong x, y, z;
};
constexpr Strongs operator+(Strongs p, Strongs q) {
  return {Strong(p.x.number() + q.x.number()), Strong(p.y.number() + q.y.number()),
          Strong(p.z.number() + q.z.number())};
}
constexpr Strongs operator*(double s, Strongs p) {
  return {Strong(s * p.x.number()), Strong(s * p.y.number()), Strong(s * p.z.number())};
}

struct strong {
  using Vec = Strongs;
  using Real = double;
  using Time = double;
  static constexpr int size = 3;
  static constexpr const char* name = "a strong type";
  static Vec make(const Real* from) { return {Strong(from[0]), Strong(from[1]), Strong(from[2])}; }
  static Real read(const Vec& x, int i) { return (i == 0 ? x.x : i == 1 ? x.y : x.z).number(); }
};

}  // namespace kinds
