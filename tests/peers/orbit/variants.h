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

/// From which planets, how many steps of what length: where they end.
using Run = std::function<std::vector<State>(const std::vector<State>&, long, double)>;

enum class For { one_and_many, one, many };

struct Variant {
  peers::Row row;
  Run run;
  For planets = For::one_and_many;
  int steps_for_one = 1;  ///< how many steps to count as one
};

inline const std::string any_note = "trap: what hides behind a pointer is not inlined";
inline const std::string dynamic_note = "trap: each temporary is fetched from the heap";
inline const std::string whole_note = "all planets as one state";
inline const std::string one_vec_note = "all positions as one Vec";

template <std::size_t count>
std::vector<Variant> symplectic_euler_variants() {
  using Eigen::Vector2d, Eigen::VectorXd;
  using Two = std::array<double, 2>;
  const std::string g = "symplectic_euler";
  return {
      {{g, "by hand", ""}, loop<count, by_hand::SymplecticEuler>},
      {{g, "header, struct", ""}, loop<count, with_headers::SymplecticEuler<Pair>>},
      {{g, "header, Vector2d", ""}, loop<count, with_headers::SymplecticEuler<Vector2d>>},
      {{g, "header, one Vec", one_vec_note},
       with_headers::whole<count, with_headers::SymplecticEuler>,
       For::many},
      {{g, "header, std::function", any_note},
       loop<count, with_headers::SymplecticEuler<Vector2d, AnyGravity>>,
       For::one},
      {{g, "header, VectorXd", dynamic_note},
       loop<count, with_headers::SymplecticEuler<VectorXd>>,
       For::one},
      {{g, "odeint, array", "told that x is v and v is x, so that v moves first"},
       loop<count, with_odeint::SymplecticEuler<Two>>},
      {{g, "odeint, Eigen", "likewise, Vector2d"},
       loop<count, with_odeint::SymplecticEuler<Vector2d>>},
  };
}

template <std::size_t count>
std::vector<Variant> velocity_verlet_variants() {
  using Eigen::Vector2d;
  using Two = std::array<double, 2>;
  const std::string g = "velocity_verlet";
  return {
      {{g, "by hand", ""}, loop<count, by_hand::VelocityVerlet>},
      {{g, "header, struct", ""}, loop<count, with_headers::VelocityVerlet<Pair>>},
      {{g, "header, Vector2d", ""}, loop<count, with_headers::VelocityVerlet<Vector2d>>},
      {{g, "header, one Vec", one_vec_note},
       with_headers::whole<count, with_headers::VelocityVerlet>,
       For::many},
      {{g, "odeint, array", ""}, loop<count, with_odeint::VelocityVerlet<Two>>},
      {{g, "odeint, Eigen", "Vector2d"}, loop<count, with_odeint::VelocityVerlet<Vector2d>>},
  };
}

template <std::size_t count>
std::vector<Variant> rk4_variants() {
  using namespace boost::numeric;
  using Eigen::Vector2d, Eigen::Vector4d, Eigen::VectorXd;
  using Four = std::array<double, 4>;
  const std::string g = "rk4";
  const std::string packed = "trap: stored as one vector of four, read again number by number";
  const std::string gsl =
      "a call of 2h: a whole step, two halves, 11 evaluations; what the halves gave is returned";
  return {
      {{g, "by hand", ""}, loop<count, by_hand::Rk4>},
      {{g, "header, struct", ""}, loop<count, with_headers::Rk4<Pair>>},
      {{g, "header, Vector2d", ""}, loop<count, with_headers::Rk4<Vector2d>>},
      {{g, "header, one Vec", one_vec_note},
       with_headers::whole<count, with_headers::Rk4>,
       For::many},
      {{g, "header, std::function", any_note},
       loop<count, with_headers::Rk4<Vector2d, AnyGravity>>,
       For::one},
      {{g, "header, VectorXd", dynamic_note}, loop<count, with_headers::Rk4<VectorXd>>, For::one},
      {{g, "by hand, packed in a Vector4d", packed},
       loop<count, by_hand::Rk4Packed<Vector4d>>,
       For::one},
      {{g, "odeint, array", ""}, loop<count, with_odeint::FirstOrder<odeint::runge_kutta4<Four>>>},
      {{g, "odeint classic, array", "the same method, its second implementation"},
       loop<count, with_odeint::FirstOrder<odeint::runge_kutta4_classic<Four>>>},
      {{g, "odeint, Eigen", "packed in a Vector4d"},
       loop<count, with_odeint::FirstOrder<odeint::runge_kutta4<Vector4d>>>},
      {{g, "odeint, vector", whole_note},
       with_odeint::whole<odeint::runge_kutta4<std::vector<double>>>,
       For::many},
      {{g, "GSL", gsl + ", so it counts as two steps of h"}, with_gsl},
      {{g, "GSL, for each call", "the same, counted as one step"}, with_gsl, For::one, 2},
      {{g, "SUNDIALS ERKStep", ""}, with_sundials([](auto& all) { all.choose_rk4(); })},
  };
}

template <std::size_t count>
std::vector<Variant> dopri5_variants() {
  using namespace boost::numeric;
  using Eigen::Vector2d, Eigen::Vector4d;
  using Four = std::array<double, 4>;
  using Numbers = std::vector<double>;
  const std::string g = "dopri5";
  return {
      {{g, "by hand", "without the estimate of its error; that of the others is not asked for"},
       loop<count, by_hand::Dopri5>},
      {{g, "header, struct", ""}, loop<count, with_headers::Dopri5<Pair>>},
      {{g, "header, Vector2d", ""}, loop<count, with_headers::Dopri5<Vector2d>>},
      {{g, "header, one Vec", one_vec_note},
       with_headers::whole<count, with_headers::Dopri5>,
       For::many},
      {{g, "odeint, array",
        "adds slope by slope: one addition less to wait for, four more roundings"},
       loop<count, with_odeint::Dopri5<odeint::runge_kutta_dopri5<Four>>>},
      {{g, "odeint, Eigen", "packed in a Vector4d"},
       loop<count, with_odeint::Dopri5<odeint::runge_kutta_dopri5<Vector4d>>>},
      {{g, "odeint, vector", whole_note},
       with_odeint::whole<odeint::runge_kutta_dopri5<Numbers>>,
       For::many},
      {{g, "SUNDIALS ERKStep", "its own table"},
       with_sundials([](auto& all) { all.choose_dopri5(); })},
  };
}

/// The rows of SUNDIALS' symplectic stepper, or word that it is missing.
inline std::vector<Variant> sprk_variants() {
  const peers::Row euler{"symplectic_euler", "SUNDIALS SPRKStep", ""};
  const peers::Row verlet{"velocity_verlet", "SUNDIALS SPRKStep", ""};
#if SUNDIALS_IS_NEW
  const auto stepper = [](const char* method) {
    return with_sundials([method](auto& all) { all.choose_symplectic(method); });
  };
  return {{euler, stepper("ARKODE_SPRK_EULER_1_1")},
          {verlet, stepper("ARKODE_SPRK_PSEUDO_LEAPFROG_2_2")}};
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
