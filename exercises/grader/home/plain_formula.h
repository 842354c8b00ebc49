// SPDX-License-Identifier: MIT-0
#pragma once
#include <string>

namespace grade {

/// Text with its formulas, written between `\f$` and `\f$`, in letters that a terminal has:
/// `\f$ h\,\omega \le 2 \f$` becomes `h ω ≤ 2`.
std::string plain_formulas(std::string text);

}  // namespace grade
