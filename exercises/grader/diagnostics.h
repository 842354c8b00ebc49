// SPDX-License-Identifier: MIT-0
/// @file
/// The compiler's messages, turned into what a student can use.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace grade {

/// One message of the compiler, with the lines that belong to it.
struct Diagnostic {
  std::string file, place;  ///< `5:3`; both empty if it has no place
  std::string kind;         ///< `error`, `warning`, `note`
  std::string text;
  std::vector<std::string> before;   ///< "In function ...", "In instantiation of ..."
  std::vector<std::string> excerpt;  ///< lines of the source
  bool is_error() const { return kind.ends_with("error") || kind == "sorry, unimplemented"; }
};

/// All messages, in the compiler's order.
std::vector<Diagnostic> diagnostics(std::string_view said);

/// The errors, the student's own first, without a trace of our files.
/// @param header  what the student's file is called
std::string errors(const std::vector<Diagnostic>& all, const std::string& header);

/// The warnings in the student's file.
std::string warnings(const std::vector<Diagnostic>& all, const std::string& header);

/// One sentence on what is behind these errors, if it is well known; else empty.
/// @param header  what the student's file is called
std::string hint(const std::vector<Diagnostic>& all, const std::string& header);

}  // namespace grade
