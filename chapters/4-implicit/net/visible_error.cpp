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

using Vec = Eigen::Matrix<Tallied, Eigen::Dynamic, 1>;
using Counted = scenes::State<Vec>;
using Pictures = std::vector<Eigen::VectorXd>;

constexpr int frames = 60;       ///< a second
constexpr int in_picture = 6;    ///< frames that run together in an eye
constexpr int true_steps = 800;  ///< of RK4 in a frame of the truth

/// What a player sees of the places: their mean over a tenth of a second, ten times.
class Eye {
 public:
  /// @param looks  at a frame: one for what is drawn, more for what there is to see
  Eye(const Eigen::VectorXd& start, int looks) : before_(start), samples_(in_picture * looks) {}

  /// Where the masses are at the next look, to which they went in a straight line.
  void see(const Eigen::VectorXd& x) {
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

/// The true motion: what there is to see of it, and what sixty pictures a second show.
struct Truth {
  Pictures there, drawn;
};

/// By steps so short that the fastest motion is followed.
template <class Scene>
Truth truth(const Scene& scene, Struck s, int steps) {
  Eye eye(s.x, steps), screen(s.x, 1);
  for (int n = 1; n <= frames * steps; ++n) {
    integrate::rk4(s.x, s.v, 0.0, frame / steps, scene);
    eye.see(s.x);
    if (n % steps == 0) screen.see(s.x);
  }
  return {eye.pictures(), screen.pictures()};
}

/// The same of one of the nets, which differ in their types: worked out once for each blow.
template <class Scene>
const Truth& known_truth(const Scene& net, const Struck& start) {
  static std::deque<std::pair<Eigen::VectorXd, Truth>> known;  // whose members stay where they are
  for (const auto& [blow, found] : known) {
    if (blow == start.v) return found;
  }
  return known.emplace_back(start.v, truth(net, start, true_steps)).second;
}

/// How far what is seen is from what there is to see, over how far that has moved from the start.
double off(const Pictures& seen, const Pictures& there, const Eigen::VectorXd& start) {
  double wrong = 0, moved = 0;
  for (std::size_t n = 0; n < there.size(); ++n) {
    wrong += (seen[n] - there[n]).squaredNorm();
    moved += (there[n] - start).squaredNorm();
  }
  return std::sqrt(wrong / moved);
}

/// A system that is solved in plain numbers. What that takes is counted by the entries of the
/// matrix or of its factor.
template <class Scene, class CountedScene>
class Plain {
 public:
  Plain(const Scene& scene, const CountedScene& counted)
      : scene_(scene),
        filling_(work_of_filling(counted)),
        solving_(work_of_solving(factor_of(step_matrix_of(scene)))),
        system_(system_of(scene)) {}

  bool operator()(const Vec& x, const Vec& v, Tallied, Tallied p, Tallied q, Vec& change) {
    const Eigen::VectorXd at = x.cast<double>(), speed = v.cast<double>();
    Eigen::VectorXd plain = change.cast<double>();
    const bool solved = residual == 0 ? system_(at, speed, 0.0, p.value, q.value, plain)
                                      : iterate(at, speed, p.value, q.value, plain);
    Tallied::operations += std::lround(filling_ + (residual == 0 ? solving_ : 0));
    change = plain.cast<Tallied>();
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
    Tallied::operations += long(solver.iterations()) * work_of_iteration(matrix);
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
auto elimination(const scenes::Cloth<>& cloth, const scenes::Cloth<Tallied>& counted) {
  return Plain(cloth, counted);
}

/// Newton's method to its end.
constexpr int to_its_end = 0;

/// Calls `newton(norm, tolerance)` for so many solves, or to the end. What the norm takes is not
/// counted.
template <class Newton>
bool solved(int solves, Newton newton) {
  const auto norm = [solves, done = 0](const Vec& change) mutable {
    if (solves != to_its_end) return Tallied(++done < solves ? 1 : 0);
    double most = 0;
    for (const Tallied& one : change) most = std::max(most, std::abs(one.value));
    return Tallied(most);
  };
  return newton(norm, Tallied(tolerance)) > 0;
}

auto backward_euler(int solves) {
  return [solves](Counted& s, const auto& scene, auto& system, Tallied h) {
    if (solves == 1) return integrate::backward_euler(s.x, s.v, 0.0, h, scene, system);
    return solved(solves, [&](auto norm, Tallied close) {
      return integrate::backward_euler_newton(s.x, s.v, 0.0, h, scene, system, norm, close);
    });
  };
}

auto trapezoid(int solves) {
  return [solves](Counted& s, const auto& scene, auto& system, Tallied h) {
    if (solves == 1) return integrate::trapezoid(s.x, s.v, 0.0, h, scene, system);
    return solved(solves, [&](auto norm, Tallied close) {
      return integrate::trapezoid_newton(s.x, s.v, 0.0, h, scene, system, norm, close);
    });
  };
}

auto bdf2(int solves) {
  return [solves, previous = std::optional<integrate::Bdf2Previous<Vec>>()](
             Counted& s, const auto& scene, auto& system, Tallied h) mutable {
    if (!previous) previous = integrate::bdf2_start(s.x, s.v, 0.0, h, scene);
    if (solves == 1) return integrate::bdf2(s.x, s.v, *previous, 0.0, h, h, scene, system);
    return solved(solves, [&](auto norm, Tallied close) {
      return integrate::bdf2_newton(s.x, s.v, *previous, 0.0, h, h, scene, system, norm, close);
    });
  };
}

constexpr auto symplectic_euler = [](Counted& s, const auto& scene, auto&, Tallied h) {
  integrate::symplectic_euler(s.x, s.v, 0.0, h, scene);
  return true;
};

/// Ways on one net, after one blow.
template <class Scene, class CountedScene>
class Race {
 public:
  Race(const Scene& scene, const CountedScene& counted, const Struck& start)
      : scene_(scene), counted_(counted), start_(start), truth_(known_truth(scene, start).there) {}

  /// By elimination, or if there is a residual, by conjugate gradients down to it.
  template <class Step>
  Way run(const char* method, int steps, Step step, double residual = 0) const {
    if (residual > 0) {
      Plain system(scene_, counted_);
      system.residual = residual;
      return run_with(system, method, steps, step);
    }
    auto system = elimination(scene_, counted_);
    return run_with(system, method, steps, step);
  }

  std::vector<Way> run_all() const {
    std::vector<Way> all;
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
    all.push_back(run("backward Euler to the end", 1, backward_euler(to_its_end)));
    all.push_back(run("trapezoid to the end", 1, trapezoid(to_its_end)));
    all.push_back(run("gradients to a hundredth", 1, backward_euler(1), 1e-2));
    all.push_back(run("gradients to a thousandth", 1, backward_euler(1), 1e-3));
    std::sort(all.begin(), all.end(), [](const Way& a, const Way& b) { return a.work < b.work; });
    double nearest = INFINITY;
    for (Way& way : all) {
      way.answers = way.off < nearest;
      nearest = std::min(nearest, way.off);
    }
    return all;
  }

 private:
  template <class Step, class System>
  Way run_with(System& system, const char* method, int steps, Step step) const {
    Counted s{start_.x.template cast<Tallied>(), start_.v.template cast<Tallied>()};
    Eye screen(start_.x, 1);
    const double work = tally([&] {
      for (int n = 1; n <= frames * steps; ++n) {
        if (!step(s, counted_, system, Tallied(frame / steps))) std::abort();
        if (n % steps == 0) screen.see(s.x.template cast<double>());
      }
    });
    const Eigen::VectorXd x = s.x.template cast<double>(), v = s.v.template cast<double>();
    return {method, steps, work / frames / double(x.size()),
            off(screen.pictures(), truth_, start_.x),
            scene_.energy(x, v) / scene_.energy(start_.x, start_.v)};
  }

  const Scene& scene_;
  const CountedScene& counted_;
  Struck start_;
  Pictures truth_;
};

/// Calls something with a net, and with the same net of counted numbers.
template <class Go>
auto on_net(const std::string& net, Go go) {
  if (net == "rope") return go(steel_rope, rope_of<Tallied>(steel_rope.count));
  if (net == "cloth") return go(steel_cloth, cloth_of<Tallied>(steel_cloth.side));
  throw std::logic_error("there is no net called " + net);
}

}  // namespace

std::vector<Way> ways(const std::string& net, double speed) {
  return on_net(net, [speed](const auto& scene, const auto& counted) {
    return Race(scene, counted, struck(scene, speed)).run_all();
  });
}

const Way& way_of(const std::vector<Way>& all, const std::string& method, int steps) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Way& way) {
    return way.method == method && way.steps == steps;
  });
  if (found == all.end()) throw std::logic_error("the figure has no net moved by " + method);
  return *found;
}

std::vector<Way> moved(const std::string& net, double speed, const std::vector<Ask>& all,
                       unsigned draw) {
  return on_net(net, [&](const auto& scene, const auto& counted) {
    const Race race(scene, counted, struck(scene, speed, draw));
    std::vector<Way> found;
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

double off_of_truth(const std::string& net, double speed) {
  return on_net(net, [speed](const auto& scene, const auto&) {
    const Struck start = struck(scene, speed);
    return off(truth(scene, start, true_steps / 2).there, known_truth(scene, start).there, start.x);
  });
}

double off_if_true(const std::string& net, double speed) {
  return on_net(net, [speed](const auto& scene, const auto&) {
    const Struck start = struck(scene, speed);
    const Truth& known = known_truth(scene, start);
    return off(known.drawn, known.there, start.x);
  });
}

int fewest_substeps(const std::string& net) {
  return on_net(net, [](const auto& scene, const auto&) { return substeps_for(scene); });
}

void seen(measure::Record& record) {
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
    const auto all = ways(net, gentle);
    const auto add_time = [&](const std::string& function, const std::string& method, int steps) {
      const Way& way = way_of(all, method, steps);
      times.add({net, method, double(steps), way.work, "time:" + frame_name(net, function),
                 100 * way.off});
    };
    add_time("symplectic_euler", "symplectic Euler", fewest_substeps(net));
    add_time("backward_euler", "backward Euler", 1);
    add_time("bdf2", "BDF2", 1);
    add_time("trapezoid", "trapezoid", 1);
    for (const Way& way : all) {
      table.add({net, way.method, double(way.steps), way.work, way.off, way.left});
    }
    for (auto way = all.begin(); way != all.end(); ++way) {
      if (!way->answers) continue;
      const auto next = std::find_if(way + 1, all.end(), [](const Way& w) { return w.answers; });
      answers.add({net, way->method, double(way->steps), way->work,
                   next == all.end() ? INFINITY : next->work, way->off});
    }
    const auto off_by = [&](const std::string& name, const std::string& method, int steps) {
      record.number("seen-" + std::string(net) + "-" + name, 100 * way_of(all, method, steps).off,
                    2, "%");
    };
    off_by("substeps", "symplectic Euler", fewest_substeps(net));
    off_by("backward", "backward Euler", 1);
    record.number("seen-" + std::string(net) + "-true", 100 * off_if_true(net, gentle), 2, "%");
  }
  record.number("seen-rope-five", 100 * moved("rope", gentle, {{"BDF2", 5}})[0].off, 2, "%");
}
