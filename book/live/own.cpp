// SPDX-License-Identifier: MIT-0
#include "live/own.h"

#include <cstddef>
#include <string>
#include <tuple>

#include "measure/methods/euler.h"
#include "measure/methods/runge_kutta.h"
#include "measure/methods/verlet.h"

namespace live {
namespace {

std::vector<Stand> all_stands() {
  std::vector<Stand> all(mistakes().begin(), mistakes().end());
  const auto yours = [&](std::string_view method) {
    static std::vector<std::unique_ptr<std::string>> names;  // which stay where they are
    names.push_back(std::make_unique<std::string>("yours/" + std::string(method)));
    all.push_back({names.back()->c_str(), method.data(), reader});
  };
  std::apply([&](const auto&... method) { (yours(method.function), ...); },
             std::tuple_cat(list::EulerFamily{}, list::RungeKuttaKin{}, list::VerletFamily{}));
  return all;
}

const std::vector<Stand>& stands() {
  static const std::vector<Stand> all = all_stands();
  return all;
}

Stood now;

}  // namespace

const Stand* standing() {
  return now.stand;
}

Stood stands_now() {
  return now;
}

void count_reader() {
  ++now.written;
}

void put_standing(double which) {
  now.stand = which > 0 ? &stands()[static_cast<std::size_t>(which) - 1] : nullptr;
}

std::vector<const char*> names_of_stands() {
  std::vector<const char*> names{"none"};
  for (const Stand& stand : stands()) names.push_back(stand.name);
  return names;
}

}  // namespace live
