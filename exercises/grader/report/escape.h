// SPDX-License-Identifier: MIT-0
/// @file
/// Makes text that may come from a student harmless where it is shown.
#pragma once
#include <string>
#include <string_view>

namespace grade {

/// Text in which nothing is hidden and nothing is a command: control characters, stray bytes and
/// characters without a shape are spelled out, and what CI services take as commands (`::error`,
/// `##[group]`) is broken by a space. Line ends and tabs stay.
std::string printable(std::string_view text);

/// The same as a name in one line; no two names become the same.
std::string printable_name(std::string_view name);

/// Printable text in one line of Markdown that means no more than its letters.
std::string markdown(std::string_view text);

/// A code block in Markdown, whose fence is longer than any in the text.
std::string markdown_code(std::string_view text);

/// Printable text for HTML and XML, in quotes too.
std::string html(std::string_view text);

}  // namespace grade
