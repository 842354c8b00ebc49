// SPDX-License-Identifier: MIT-0
#pragma once
#include "finding.h"
#include "home/stage.h"

namespace grade {

/// A plot as a film that draws its curves, the student's first, in the order of their points. It
/// needs no gnuplot.
Stage film_of(const Plot& plot);

}  // namespace grade
