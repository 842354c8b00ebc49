// SPDX-License-Identifier: MIT-0
// Prints "method scene hash" for a long trajectory of every method whose arithmetic IEEE 754
// settles to the last bit: + - * / and square roots; and "shelf header hash" for each such header
// of the shelf. The others call the C library's exponential, sine or power, which no two libraries
// round alike.
#include <cxxabi.h>

#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <type_traits>
#include <typeinfo>

#include "measure/methods.h"
#include "measure/run.h"
#include "scenes/orbit.h"
#include "scenes/outer_solar_system.h"
#include "scenes/pendulum.h"
#include "scenes/spring.h"
#include "shelf/aim.h"
#include "shelf/blend.h"
#include "shelf/bounce.h"
#include "shelf/contact.h"
#include "shelf/damper.h"
#include "shelf/event.h"
#include "shelf/first_order.h"
#include "shelf/fixed_step.h"
#include "shelf/grapple.h"
#include "shelf/jump.h"
#include "shelf/link.h"
#include "shelf/orientation.h"
#include "shelf/wheel.h"
#include "snippets/shelf_calls/aim.h"
#include "snippets/shelf_calls/blend.h"
#include "snippets/shelf_calls/bounce.h"
#include "snippets/shelf_calls/contact.h"
#include "snippets/shelf_calls/damper.h"
#include "snippets/shelf_calls/event.h"
#include "snippets/shelf_calls/first_order.h"
#include "snippets/shelf_calls/fixed_step.h"
#include "snippets/shelf_calls/grapple.h"
#include "snippets/shelf_calls/jump.h"
#include "snippets/shelf_calls/link.h"
#include "snippets/shelf_calls/wheel.h"

namespace {

template <class Method>
constexpr bool calls_the_c_library =
    std::is_same_v<Method, measure::SpringExact> || std::is_same_v<Method, measure::SpringFolded> ||
    std::is_same_v<Method, measure::LinearDampingExponentialLast> ||
    std::is_same_v<Method, measure::LinearDampingExponentialFirst> ||
    std::is_same_v<Method, measure::LinearDampingExact>;

// FNV-1a, one double at a time.
struct Hash {
  std::uint64_t value = 0xcbf29ce484222325;

  void add(double x) { value = (value ^ std::bit_cast<std::uint64_t>(x)) * 0x100000001b3; }

  template <class Vec>
  void add(const Vec& x) {
    for (const double coordinate : x.reshaped()) add(coordinate);
  }
};

// "measure::Euler" as g++ and clang++ both spell it.
template <class Method>
std::string name() {
  int status = 0;
  char* const spelled = abi::__cxa_demangle(typeid(Method).name(), nullptr, nullptr, &status);
  std::string name = status == 0 ? spelled : "?";
  std::free(spelled);
  return name.substr(name.find_last_of(':') + 1);
}

// What is read out of each step of Dormand and Prince, three tenths of the way.
template <class Scene, class Vec>
void print_path(const char* where, const Scene& scene, const scenes::State<Vec>& s, double h,
                long steps) {
  Hash hash;
  auto path = integrate::dopri5_path(s.x, s.v, 0.0, h, scene);
  for (long n = 0; n < steps; ++n) {
    integrate::dopri5(path, h, scene);
    hash.add(path.position(path.t_before + 0.3 * h));
    hash.add(path.velocity(path.t_before + 0.3 * h));
  }
  std::printf("Dopri5Path %s %016llx\n", where, static_cast<unsigned long long>(hash.value));
}

template <class Method, class Scene, class Vec>
void print(const char* where, const Scene& scene, scenes::State<Vec> s, double h, long steps) {
  if constexpr (!calls_the_c_library<Method>) {
    Hash hash;
    measure::run(Method(), scene, s, h, steps, [&hash](double, const scenes::State<Vec>& now) {
      hash.add(now.x);
      hash.add(now.v);
    });
    std::printf("%s %s %016llx\n", name<Method>().c_str(), where,
                static_cast<unsigned long long>(hash.value));
  }
}

void print(const char* header, void (*call)(Numbers&)) {
  Numbers found;
  call(found);
  Hash hash;
  for (const double number : found.all) hash.add(number);
  std::printf("shelf %s %016llx\n", header, static_cast<unsigned long long>(hash.value));
}

// What of orientation.h calls no sine.
void turns_without_sines(Numbers& found) {
  const shelf::Vec3<double> inertia = shelf::inertia_of_box(1.0, {0.2, 0.14, 0.03});
  shelf::Quaternion<double> q;
  const shelf::Vec3<double> L = shelf::angular_momentum(q, {0.2, 20, 0.2}, inertia);
  for (int n = 0; n < 1000; ++n) {
    shelf::spin_by_midpoint(q, L, inertia, 1 / 60.0);
    shelf::turn(q, shelf::angular_velocity(q, L, inertia), 1e-3);
    for (const double number : {q.w, q.x, q.y, q.z}) found.add(number);
    found.add(shelf::inverse_mass_at(q, inertia, 1.0, {0.1, -0.07, 0.015}, {0, 1, 0}));
  }
}

}  // namespace

int main() {
  const scenes::Pendulum<> pendulum{.angle = 3};
  const scenes::Orbit<> orbit;
  const scenes::State<Eigen::Vector2d> pericentre{{0.4, 0}, {0, 2}};
  const scenes::OuterSolarSystem<> planets;
  const scenes::Spring<> spring{.omega = 3, .zeta = 0.01};
  list::for_each(list::General(), [&](auto method) {
    using Method = decltype(method);
    print<Method>("pendulum", pendulum, pendulum.start(), 1e-3, 10'000);
    print<Method>("orbit", orbit, pericentre, 1e-3, 5000);
  });
  print_path("pendulum", pendulum, pendulum.start(), 1e-3, 10'000);
  print_path("orbit", orbit, pericentre, 1e-3, 5000);
  list::for_each(list::Explicit(), [&](auto method) {
    print<decltype(method)>("planets", planets, planets.start(), 10.0, 500);
  });
  list::for_each(list::Joined<list::OnSprings, list::Damping>(), [&](auto method) {
    print<decltype(method)>("spring", spring, spring.start(), 1e-3, 10'000);
  });
  print("aim", aim_on<Doubles>);
  print("blend", blend_on<Doubles>);
  print("bounce", bounce_on<Doubles>);
  print("contact", contact_on<Doubles>);
  print("damper", damper_on<Doubles>);
  print("event", event_on<Doubles>);
  print("first_order", first_order_on<Doubles>);
  print("fixed_step", fixed_step_on<Doubles>);
  print("grapple", grapple_on<Doubles>);
  print("jump", jump_on<Doubles>);
  print("link", link_on<Doubles>);
  print("orientation", turns_without_sines);
  print("wheel", wheel_on<Doubles>);
}
