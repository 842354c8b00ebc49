// SPDX-License-Identifier: MIT-0
#pragma once
#include <string>
#include <string_view>

namespace grade {

/// Bytes as the text of a `data:` address (RFC 4648).
std::string base64(std::string_view bytes);

}  // namespace grade
