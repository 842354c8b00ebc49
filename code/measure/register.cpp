// SPDX-License-Identifier: MIT-0
// The register of the book's methods: what each says of itself, as a table that figures, films and
// tests read.
#include <string>

#include "measure/methods.h"
#include "measure/record.h"

namespace {

std::string yes(bool holds) {
  return holds ? "yes" : "no";
}

const char* dash(measure::Dash dash) {
  return dash == measure::Dash::solid    ? "solid"
         : dash == measure::Dash::dashed ? "dashed"
                                         : "dotted";
}

// Empty where a method has none.
template <class Method>
std::vector<measure::Cell> style() {
  if constexpr (measure::IsDrawn<Method>) {
    constexpr measure::FigureStyle style = Method::style;
    return {double(style.colour), dash(style.dash), double(style.symbol), style.size, style.width};
  }
  return {"none", "none", "none", "none", "none"};
}

template <class Method>
std::vector<measure::Cell> traits() {
  if constexpr (measure::HasAllTraits<Method>)
    return {double(Method::order),
            double(Method::drag_order),
            double(Method::evaluations),
            Method::spring_limit,
            Method::drag_limit,
            double(Method::free_fall_after_ten_steps),
            yes(Method::symplectic),
            yes(Method::reversible),
            yes(Method::conserves_angular_momentum),
            yes(Method::allows_negative_step),
            yes(Method::contender)};
  return std::vector<measure::Cell>(11, "none");
}

template <class List>
void add(measure::Table& table, const char* family) {
  list::for_each(List(), [&](auto method) {
    using Method = decltype(method);
    std::vector<measure::Cell> row{Method::name, Method::header, Method::function, family};
    for (const auto& cells : {style<Method>(), traits<Method>()})
      row.insert(row.end(), cells.begin(), cells.end());
    table.add(row);
  });
}

}  // namespace

int main(int argc, char** argv) {
  return measure::record(argc, argv, [](measure::Record& record) {
    measure::Table& table = record.table("methods", {{"name"},
                                                     {"header"},
                                                     {"function"},
                                                     {"family"},
                                                     {"colour"},
                                                     {"dash"},
                                                     {"symbol"},
                                                     {"size"},
                                                     {"width"},
                                                     {"order"},
                                                     {"drag_order"},
                                                     {"evaluations"},
                                                     {"spring_limit"},
                                                     {"drag_limit"},
                                                     {"free_fall_after_ten_steps"},
                                                     {"symplectic"},
                                                     {"reversible"},
                                                     {"conserves_angular_momentum"},
                                                     {"allows_negative_step"},
                                                     {"contender"}});
    add<list::EulerFamily>(table, "Euler");
    add<list::VerletFamily>(table, "Verlet");
    add<list::RungeKuttaKin>(table, "Runge-Kutta");
    add<list::ImplicitKin>(table, "implicit");
    add<list::SpringKin>(table, "spring");
    add<list::DampingKin>(table, "damping");
  });
}
