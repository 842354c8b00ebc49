// SPDX-License-Identifier: MIT-0
// The wrong ways to call a method: each names the types of the arguments, most of them right ones.
// Nothing of this runs, so that nothing needs a body. Every line has types of its own: a compiler
// speaks but once about what two calls share. The headers stand before this one.
#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

struct Label {
  const char* text;
};

template <int Line, class SomeVec, class SomeReal, class SomeOtherVec = SomeVec,
          class SomePosition = SomeVec>
struct Call {
  using Position = SomePosition;
  using Vec = SomeVec;
  using OtherVec = SomeOtherVec;
  using Real = SomeReal;
  using Time = double;
  using Path = integrate::Dopri5Path<Vec, Time, Real>;
  struct Acceleration {
    Vec operator()(const Position& x, const Vec& v, Time t) const;
  };
  struct Solve {
    bool operator()(const Vec& x, const Vec& v, Time t, Real p, Real q, Vec& change) const;
  };
  struct Norm {
    Real operator()(const Vec& x) const;
  };
};

template <int Line>
struct acceleration_of_position_only : Call<Line, double, double> {
  struct Acceleration {
    double operator()(double x) const;
  };
};

template <int Line>
struct acceleration_gives_a_label : Call<Line, double, double> {
  struct Acceleration {
    Label operator()(double x, double v, double t) const;
  };
};

template <int Line>
struct acceleration_gives_two_numbers_of_three : Call<Line, glm::vec3, float> {
  struct Acceleration {
    glm::vec2 operator()(const glm::vec3& x, const glm::vec3& v, double t) const;
  };
};

template <int Line>
struct numbers_are_double_and_vectors_float : Call<Line, glm::vec3, double> {};

template <int Line>
struct numbers_are_integers : Call<Line, double, int> {};

template <int Line>
struct clock_is_an_integer : Call<Line, double, double> {
  using Time = int;
};

template <int Line>
struct vectors_of_two_types : Call<Line, double, double, float> {};

template <int Line>
struct place_that_no_velocity_moves : Call<Line, glm::vec3, float, glm::vec3, Label> {};

template <int Line>
struct one_argument_missing : Call<Line, glm::vec3, float> {};

template <int Line>
struct two_arguments_too_many : Call<Line, double, double> {};

template <int Line>
struct step_after_acceleration : Call<Line, double, double> {};

template <int Line>
struct solve_of_one_argument : Call<Line, double, double> {
  struct Solve {
    bool operator()(double& change) const;
  };
};

template <int Line>
struct norm_gives_a_label : Call<Line, double, double> {
  struct Norm {
    Label operator()(double x) const;
  };
};
