// SPDX-License-Identifier: MIT-0
#include "visible_error.h"

#include <Eigen/IterativeLinearSolvers>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <deque>
#include <optional>
#include <stdexcept>
#include <utility>

#include "integrate/bdf2.h"
#include "integrate/rk4.h"
#include "integrate/trapezoid.h"
#include "matrix_costs.h"
#include "nets.h"
#include "substeps.h"

namespace {

using Vec = Eigen::Matrix<OpCounted, Eigen::Dynamic, 1>;
using Counted = scenes::State<Vec>;
using Pictures = std::vector<Eigen::VectorXd>;

constexpr int frames = 60;       ///< a second
constexpr int in_picture = 6;    ///< frames that run together in an eye
constexpr int true_steps = 800;  ///< of RK4 in a frame of the truth

/// The motion blur of an eye: the mean of the places over a tenth of a second, ten times.
class MotionBlur {
 public:
  /// @param samples  in a frame: one for the pictures of a screen, more for the motion itself
  MotionBlur(const Eigen::VectorXd& start, int samples)
      : before_(start), samples_(in_picture * samples) {}

  /// Adds the places at the next sample, to which the masses went in a straight line.
  void add(const Eigen::VectorXd& x) {
    if (taken_ == 0) pictures_.push_back(Eigen::VectorXd::Zero(x.size()));
    pictures_.back() += (before_ + x) / (2 * samples_);
    before_ = x;
    taken_ = (taken_ + 1) % samples_;
  }

  const Pictures& pictures() const { return pictures_; }

 private:
  Eigen::VectorXd before_;
  Pictures pictures_;
  int samples_, taken_ = 0;
};

/// The true motion with motion blur, and the same of its sixty pictures a second.
struct TrueMotion {
  Pictures blurred, drawn;
};

/// The true motion, in steps so short that they follow the highest frequency.
template <class Scene>
TrueMotion true_motion(const Scene& scene, MassSpringState s, int steps) {
  MotionBlur eye(s.x, steps), screen(s.x, 1);
  for (int n = 1; n <= frames * steps; ++n) {
    integrate::rk4(s.x, s.v, 0.0, frame / steps, scene);
    eye.add(s.x);
    if (n % steps == 0) screen.add(s.x);
  }
  return {eye.pictures(), screen.pictures()};
}

/// The true motion of one of the nets, which differ in their types: worked out once for each blow.
template <class Scene>
const TrueMotion& known_motion(const Scene& net, const MassSpringState& start) {
  // Whose members stay where they are.
  static std::deque<std::pair<Eigen::VectorXd, TrueMotion>> known;
  for (const auto& [blow, found] : known) {
    if (blow == start.v) return found;
  }
  return known.emplace_back(start.v, true_motion(net, start, true_steps)).second;
}

/// The distance of pictures from the true ones, over how far these have moved from the start.
double visible_error(const Pictures& seen, const Pictures& truth, const Eigen::VectorXd& start) {
  double wrong = 0, moved = 0;
  for (std::size_t n = 0; n < truth.size(); ++n) {
    wrong += (seen[n] - truth[n]).squaredNorm();
    moved += (truth[n] - start).squaredNorm();
  }
  return std::sqrt(wrong / moved);
}

/// A linear system that is solved in plain doubles. The operations are counted by the entries of
/// the matrix or of its factor.
template <class Scene, class CountedScene>
class PlainSystem {
 public:
  PlainSystem(const Scene& scene, const CountedScene& counted)
      : scene_(scene),
        filling_(work_of_filling(counted)),
        solving_(work_of_solving(factor_of(step_matrix_of(scene)))),
        system_(system_of(scene)) {}

  bool operator()(const Vec& x, const Vec& v, OpCounted, OpCounted p, OpCounted q, Vec& change) {
    const Eigen::VectorXd at = x.cast<double>(), speed = v.cast<double>();
    Eigen::VectorXd plain = change.cast<double>();
    const bool solved = residual == 0 ? system_(at, speed, 0.0, p.value, q.value, plain)
                                      : iterate(at, speed, p.value, q.value, plain);
    OpCounted::operations += std::lround(filling_ + (residual == 0 ? solving_ : 0));
    change = plain.cast<OpCounted>();
    return solved;
  }

  /// Down to which conjugate gradients solve, over the size of the right side; 0 is elimination.
  double residual = 0;

 private:
  bool iterate(const Eigen::VectorXd& x, const Eigen::VectorXd& v, double p, double q,
               Eigen::VectorXd& change) {
    const int unknowns = int(x.size());
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < unknowns; ++i) entries.emplace_back(i, i, 1.0);
    scene_.jacobian(x, v, 0.0, [&](int i, int j, double dadx, double dadv) {
      entries.emplace_back(i, j, p * dadx + q * dadv);
    });
    Sparse matrix(unknowns, unknowns);
    matrix.setFromTriplets(entries.begin(), entries.end());
    Eigen::ConjugateGradient<Sparse, Eigen::Lower | Eigen::Upper> solver(matrix);
    solver.setTolerance(residual);
    change = solver.solve(change).eval();
    OpCounted::operations += long(solver.iterations()) * work_of_iteration(matrix);
    return true;
  }

  const Scene& scene_;
  double filling_, solving_;
  decltype(system_of(std::declval<const Scene&>())) system_;
};

/// Elimination, where it can count its own numbers.
template <class Scene, class CountedScene>
auto elimination(const Scene&, const CountedScene& counted) {
  return system_of(counted);
}
auto elimination(const scenes::Cloth<>& cloth, const scenes::Cloth<OpCounted>& counted) {
  return PlainSystem(cloth, counted);
}

/// Solves of Newton's method: as many as it takes to converge.
constexpr int until_converged = 0;

/// Calls `newton(norm, tolerance)` for so many solves, or until it converges. The operations of the
/// norm are not counted.
template <class Newton>
bool solved(int solves, Newton newton) {
  const auto norm = [solves, done = 0](const Vec& change) mutable {
    if (solves != until_converged) return OpCounted(++done < solves ? 1 : 0);
    double most = 0;
    for (const OpCounted& one : change) most = std::max(most, std::abs(one.value));
    return OpCounted(most);
  };
  return newton(norm, OpCounted(newton_tolerance)) > 0;
}

auto backward_euler(int solves) {
  return [solves](Counted& s, const auto& scene, auto& system, OpCounted h) {
    if (solves == 1) return integrate::backward_euler(s.x, s.v, 0.0, h, scene, system);
    return solved(solves, [&](auto norm, OpCounted close) {
      return integrate::backward_euler_newton(s.x, s.v, 0.0, h, scene, system, norm, close);
    });
  };
}

auto trapezoid(int solves) {
  return [solves](Counted& s, const auto& scene, auto& system, OpCounted h) {
    if (solves == 1) return integrate::trapezoid(s.x, s.v, 0.0, h, scene, system);
    return solved(solves, [&](auto norm, OpCounted close) {
      return integrate::trapezoid_newton(s.x, s.v, 0.0, h, scene, system, norm, close);
    });
  };
}

auto bdf2(int solves) {
  return [solves, previous = std::optional<integrate::Bdf2Previous<Vec>>()](
             Counted& s, const auto& scene, auto& system, OpCounted h) mutable {
    if (!previous) previous = integrate::bdf2_start(s.x, s.v, 0.0, h, scene);
    if (solves == 1) return integrate::bdf2(s.x, s.v, *previous, 0.0, h, h, scene, system);
    return solved(solves, [&](auto norm, OpCounted close) {
      return integrate::bdf2_newton(s.x, s.v, *previous, 0.0, h, h, scene, system, norm, close);
    });
  };
}

constexpr auto symplectic_euler = [](Counted& s, const auto& scene, auto&, OpCounted h) {
  integrate::symplectic_euler(s.x, s.v, 0.0, h, scene);
  return true;
};

/// Methods on one net, after one blow.
template <class Scene, class CountedScene>
class Trial {
 public:
  Trial(const Scene& scene, const CountedScene& counted, const MassSpringState& start)
      : scene_(scene),
        counted_(counted),
        start_(start),
        truth_(known_motion(scene, start).blurred) {}

  /// By elimination, or if there is a residual, by conjugate gradients down to it.
  template <class Step>
  Outcome run(const char* method, int steps, Step step, double residual = 0) const {
    if (residual > 0) {
      PlainSystem system(scene_, counted_);
      system.residual = residual;
      return run_with(system, method, steps, step);
    }
    auto system = elimination(scene_, counted_);
    return run_with(system, method, steps, step);
  }

  std::vector<Outcome> run_all() const {
    std::vector<Outcome> all;
    for (const int steps : {substeps_for(scene_), 100, 150, 200, 300, 400}) {
      all.push_back(run("symplectic Euler", steps, symplectic_euler));
    }
    for (const int steps : {1, 2, 4, 8, 16}) {
      all.push_back(run("backward Euler", steps, backward_euler(1)));
      all.push_back(run("BDF2", steps, bdf2(1)));
      all.push_back(run("trapezoid", steps, trapezoid(1)));
    }
    all.push_back(run("backward Euler twice", 1, backward_euler(2)));
    all.push_back(run("BDF2 twice", 1, bdf2(2)));
    all.push_back(run("backward Euler to the end", 1, backward_euler(until_converged)));
    all.push_back(run("trapezoid to the end", 1, trapezoid(until_converged)));
    all.push_back(run("gradients to a hundredth", 1, backward_euler(1), 1e-2));
    all.push_back(run("gradients to a thousandth", 1, backward_euler(1), 1e-3));
    std::sort(all.begin(), all.end(),
              [](const Outcome& a, const Outcome& b) { return a.work < b.work; });
    double nearest = INFINITY;
    for (Outcome& outcome : all) {
      outcome.is_nearest = outcome.error < nearest;
      nearest = std::min(nearest, outcome.error);
    }
    return all;
  }

 private:
  template <class Step, class System>
  Outcome run_with(System& system, const char* method, int steps, Step step) const {
    Counted s{start_.x.template cast<OpCounted>(), start_.v.template cast<OpCounted>()};
    MotionBlur screen(start_.x, 1);
    const double work = count_operations([&] {
      for (int n = 1; n <= frames * steps; ++n) {
        if (!step(s, counted_, system, OpCounted(frame / steps))) std::abort();
        if (n % steps == 0) screen.add(s.x.template cast<double>());
      }
    });
    const Eigen::VectorXd x = s.x.template cast<double>(), v = s.v.template cast<double>();
    return {method, steps, work / frames / double(x.size()),
            visible_error(screen.pictures(), truth_, start_.x),
            scene_.energy(x, v) / scene_.energy(start_.x, start_.v)};
  }

  const Scene& scene_;
  const CountedScene& counted_;
  MassSpringState start_;
  Pictures truth_;
};

/// Calls something with a net, and with the same net of counted numbers.
template <class Go>
auto with_net(const std::string& net, Go go) {
  if (net == "rope") return go(steel_rope, rope_of<OpCounted>(steel_rope.count));
  if (net == "cloth") return go(steel_cloth, cloth_of<OpCounted>(steel_cloth.side));
  throw std::logic_error("there is no net called " + net);
}

}  // namespace

std::vector<Outcome> outcomes_on(const std::string& net, double speed) {
  return with_net(net, [speed](const auto& scene, const auto& counted) {
    return Trial(scene, counted, with_random_velocities(scene, speed)).run_all();
  });
}

const Outcome& outcome_of(const std::vector<Outcome>& all, const std::string& method, int steps) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Outcome& outcome) {
    return outcome.method == method && outcome.steps == steps;
  });
  if (found == all.end()) throw std::logic_error("the figure has no net moved by " + method);
  return *found;
}

std::vector<Outcome> run_setups(const std::string& net, double speed, const std::vector<Setup>& all,
                                unsigned draw) {
  return with_net(net, [&](const auto& scene, const auto& counted) {
    const Trial race(scene, counted, with_random_velocities(scene, speed, draw));
    std::vector<Outcome> found;
    for (const auto& [method, steps, solves] : all) {
      const char* const name = method.c_str();
      if (method == "symplectic Euler") {
        found.push_back(race.run(name, steps, symplectic_euler));
      } else if (method == "backward Euler") {
        found.push_back(race.run(name, steps, backward_euler(solves)));
      } else if (method == "BDF2") {
        found.push_back(race.run(name, steps, bdf2(solves)));
      } else {
        found.push_back(race.run(name, steps, trapezoid(solves)));
      }
    }
    return found;
  });
}

double error_of_truth(const std::string& net, double speed) {
  return with_net(net, [speed](const auto& scene, const auto&) {
    const MassSpringState start = with_random_velocities(scene, speed);
    return visible_error(true_motion(scene, start, true_steps / 2).blurred,
                         known_motion(scene, start).blurred, start.x);
  });
}

double error_of_sixty_pictures(const std::string& net, double speed) {
  return with_net(net, [speed](const auto& scene, const auto&) {
    const MassSpringState start = with_random_velocities(scene, speed);
    const TrueMotion& known = known_motion(scene, start);
    return visible_error(known.drawn, known.blurred, start.x);
  });
}

int fewest_substeps(const std::string& net) {
  return with_net(net, [](const auto& scene, const auto&) { return substeps_for(scene); });
}

void record_visible_errors(measure::Record& record) {
  auto& table = record.table("seen", {{"net"},
                                      {"method"},
                                      {"steps", "", measure::whole},
                                      {"work", "", 3},
                                      {"off", "", 2},
                                      {"energy left", "", 2}});
  auto& answers = record.table("seen-answers", {{"net"},
                                                {"method"},
                                                {"steps", "", measure::whole},
                                                {"work", "", 3},
                                                {"until", "", 3},
                                                {"off", "", 2}});
  auto& times = record.table("net-times", {{"net"},
                                           {"method"},
                                           {"steps", "", measure::whole},
                                           {"multiplications", "", measure::whole},
                                           {"time", "ns"},
                                           {"off by", "%", 2}});
  for (const char* net : {"rope", "cloth"}) {
    const auto all = outcomes_on(net, gentle);
    const auto add_time = [&](const std::string& function, const std::string& method, int steps) {
      const Outcome& outcome = outcome_of(all, method, steps);
      times.add({net, method, double(steps), outcome.work, "time:" + frame_name(net, function),
                 100 * outcome.error});
    };
    add_time("symplectic_euler", "symplectic Euler", fewest_substeps(net));
    add_time("backward_euler", "backward Euler", 1);
    add_time("bdf2", "BDF2", 1);
    add_time("trapezoid", "trapezoid", 1);
    for (const Outcome& outcome : all) {
      table.add({net, outcome.method, double(outcome.steps), outcome.work, outcome.error,
                 outcome.energy_left});
    }
    for (auto outcome = all.begin(); outcome != all.end(); ++outcome) {
      if (!outcome->is_nearest) continue;
      const auto next =
          std::find_if(outcome + 1, all.end(), [](const Outcome& w) { return w.is_nearest; });
      answers.add({net, outcome->method, double(outcome->steps), outcome->work,
                   next == all.end() ? INFINITY : next->work, outcome->error});
    }
    const auto off_by = [&](const std::string& name, const std::string& method, int steps) {
      record.number("seen-" + std::string(net) + "-" + name,
                    100 * outcome_of(all, method, steps).error, 2, "%");
    };
    off_by("substeps", "symplectic Euler", fewest_substeps(net));
    off_by("backward", "backward Euler", 1);
    record.number("seen-" + std::string(net) + "-true", 100 * error_of_sixty_pictures(net, gentle),
                  2, "%");
  }
  record.number("seen-rope-five", 100 * run_setups("rope", gentle, {{"BDF2", 5}})[0].error, 2, "%");
}
