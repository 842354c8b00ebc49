// SPDX-License-Identifier: MIT-0
// Everyone's version of each method, in the order of the report.
#pragma once
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "orbit/by_hand.h"
#include "orbit/with_gsl.h"
#include "orbit/with_headers.h"
#include "orbit/with_odeint.h"
#include "orbit/with_sundials.h"
#include "rows.h"

namespace orbit {

struct Variant {
  peers::Row row;
  std::function<State(State, long, double)> run;
  int steps_for_one = 1;  ///< how many steps to count as one
};

using AnyAcceleration =
    std::function<Eigen::Vector2d(const Eigen::Vector2d&, const Eigen::Vector2d&, double)>;

inline const std::string any_note = "trap: what hides behind a pointer is not inlined";
inline const std::string dynamic_note = "trap: each temporary is fetched from the heap";

inline std::vector<Variant> euler_variants() {
  using namespace boost::numeric;
  using Eigen::Vector2d, Eigen::Vector4d;
  using Four = std::array<double, 4>;
  return {
      {{"euler", "by hand", ""}, by_hand::euler},
      {{"euler", "header, struct", ""}, with_headers::euler<Pair>()},
      {{"euler", "header, Vector2d", ""}, with_headers::euler<Vector2d>()},
      {{"euler", "odeint, array", ""}, with_odeint::first_order<odeint::euler<Four>>},
      {{"euler", "odeint, Eigen", "packed in a Vector4d, see rk4"},
       with_odeint::first_order<odeint::euler<Vector4d>>},
  };
}

inline std::vector<Variant> symplectic_euler_variants() {
  using Eigen::Vector2d, Eigen::VectorXd;
  using Two = std::array<double, 2>;
  const AnyAcceleration any = Gravity();
  const std::string g = "symplectic_euler";
  return {
      {{g, "by hand", ""}, by_hand::symplectic_euler},
      {{g, "header, struct", ""}, with_headers::symplectic_euler<Pair>()},
      {{g, "header, Vector2d", ""}, with_headers::symplectic_euler<Vector2d>()},
      {{g, "header, std::function", any_note}, with_headers::symplectic_euler<Vector2d>(any)},
      {{g, "header, VectorXd", dynamic_note}, with_headers::symplectic_euler<VectorXd>()},
      {{g, "odeint, array", "told that x is v and v is x, so that v moves first"},
       with_odeint::symplectic_euler<Two>},
      {{g, "odeint, Eigen", "likewise, Vector2d"}, with_odeint::symplectic_euler<Vector2d>},
  };
}

inline std::vector<Variant> velocity_verlet_variants() {
  using Eigen::Vector2d;
  using Two = std::array<double, 2>;
  const std::string g = "velocity_verlet";
  return {
      {{g, "by hand", ""}, by_hand::velocity_verlet},
      {{g, "header, struct", ""}, with_headers::velocity_verlet<Pair>()},
      {{g, "header, Vector2d", ""}, with_headers::velocity_verlet<Vector2d>()},
      {{g, "odeint, array", ""}, with_odeint::velocity_verlet<Two>},
      {{g, "odeint, Eigen", "Vector2d"}, with_odeint::velocity_verlet<Vector2d>},
  };
}

inline std::vector<Variant> rk4_variants() {
  using namespace boost::numeric;
  using Eigen::Vector2d, Eigen::Vector4d, Eigen::VectorXd;
  using Four = std::array<double, 4>;
  const AnyAcceleration any = Gravity();
  const std::string packed = "trap: stored as one vector of four, read again number by number";
  const std::string gsl =
      "a call of 2h: a whole step, two halves, 11 evaluations; what the halves gave is returned";
  return {
      {{"rk4", "by hand", ""}, by_hand::rk4},
      {{"rk4", "header, struct", ""}, with_headers::rk4<Pair>()},
      {{"rk4", "header, Vector2d", ""}, with_headers::rk4<Vector2d>()},
      {{"rk4", "header, std::function", any_note}, with_headers::rk4<Vector2d>(any)},
      {{"rk4", "header, VectorXd", dynamic_note}, with_headers::rk4<VectorXd>()},
      {{"rk4", "by hand, packed in a Vector4d", packed}, by_hand::rk4_packed<Vector4d>},
      {{"rk4", "odeint, array", ""}, with_odeint::first_order<odeint::runge_kutta4<Four>>},
      {{"rk4", "odeint classic, array", "the same method, its second implementation"},
       with_odeint::first_order<odeint::runge_kutta4_classic<Four>>},
      {{"rk4", "odeint, Eigen", "packed in a Vector4d"},
       with_odeint::first_order<odeint::runge_kutta4<Vector4d>>},
      {{"rk4", "GSL", gsl + ", so it counts as two steps of h"}, WithGsl()},
      {{"rk4", "GSL, for each call", "the same, counted as one step"}, WithGsl(), 2},
      {{"rk4", "SUNDIALS ERKStep", ""}, with_sundials(WithSundials::rk4())},
  };
}

/// The rows of SUNDIALS' symplectic stepper, or word that it is missing.
inline std::vector<Variant> sprk_variants() {
  const peers::Row euler{"symplectic_euler", "SUNDIALS SPRKStep", ""};
  const peers::Row verlet{"velocity_verlet", "SUNDIALS SPRKStep", ""};
#if SUNDIALS_IS_NEW
  return {{euler, with_sundials(WithSundials::symplectic("ARKODE_SPRK_EULER_1_1"))},
          {verlet, with_sundials(WithSundials::symplectic("ARKODE_SPRK_PSEUDO_LEAPFROG_2_2"))}};
#else
  for (peers::Row row : {euler, verlet}) {
    row.note = "SUNDIALS " SUNDIALS_VERSION
               " is too old: SPRKStep came with 6.6, the functions called here with 7.1";
    peers::lacks_row(row);
  }
  return {};
#endif
}

}  // namespace orbit
