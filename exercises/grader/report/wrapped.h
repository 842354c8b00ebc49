// SPDX-License-Identifier: MIT-0
#pragma once
#include <cstddef>
#include <string>

namespace grade {

/// Words over as many lines of 80 columns as they need, all but the first indented. What may come
/// from a submission is escaped.
std::string wrapped(const std::string& text, std::size_t indent);

}  // namespace grade
