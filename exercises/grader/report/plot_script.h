// SPDX-License-Identifier: MIT-0
#pragma once
#include <string>
#include <vector>

#include "report/curve.h"

namespace grade {

/// Has gnuplot draw these curves, within this box, with the words of the plot. Of a logarithmic
/// plot both are in powers of ten.
std::string plot_script(const Plot& plot, const std::vector<Curve>& curves, const Box& box);

}  // namespace grade
