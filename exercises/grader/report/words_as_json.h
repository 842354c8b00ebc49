// SPDX-License-Identifier: MIT-0
/// @file
/// A report in words, for a program that shows it: the page of a book.
#pragma once
#include <string>

#include "grade_submission.h"

namespace grade {

/// `{exercise, verdict, headline, sentence, why, score, points, tests: [{name, points, outcome,
/// failed}, ...]}`; `failed` is null, or `{lines: [{label, text}, ...], plot}` of what did not
/// hold. A number of a plot that is not finite is null.
std::string words_as_json(const Report& report);

}  // namespace grade
