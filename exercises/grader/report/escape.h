// SPDX-License-Identifier: MIT-0
/// @file
/// Text that may come from a student, made harmless in a markup.
#pragma once
#include <string>
#include <string_view>

namespace grade {

/// Printable text in one line of Markdown that means no more than its letters.
std::string markdown(std::string_view text);

/// A code block in Markdown, whose fence is longer than any in the text.
std::string markdown_code(std::string_view text);

/// Text of our own for HTML, in quotes too, to the letter.
std::string html_to_the_letter(std::string_view text);

/// Printable text for HTML and XML, in quotes too.
std::string html(std::string_view text);

}  // namespace grade
