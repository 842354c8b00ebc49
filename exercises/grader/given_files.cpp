// SPDX-License-Identifier: MIT-0
#include "given_files.h"

#include <algorithm>
#include <charconv>
#include <system_error>

#include "command_line.h"
#include "printable.h"
#include "report/files.h"

namespace grade {

std::optional<std::uint64_t> whole_number(const std::string& text) {
  std::uint64_t value = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<std::string> small_file(const std::filesystem::path& file) {
  // No pipe that never ends, and nothing of many megabytes.
  constexpr std::size_t most = 1 << 20;
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  std::error_code none;
  try {
    auto text = read_whole(std::filesystem::canonical(file, none), most);
    if (text && text->starts_with(byte_order_mark)) text->erase(0, byte_order_mark.size());
    return text;
  } catch (const NotOwn&) {
    return std::nullopt;
  }
}

std::uint64_t seed_in(const std::filesystem::path& file) {
  std::optional<std::string> text = small_file(file);
  if (!text) throw Usage("can't read the seed file '" + printable_name(file.string()) + "'");
  std::erase_if(*text, [](char c) { return c == '\n' || c == '\r' || c == ' '; });
  // The seed itself may be a secret: what the file holds is not printed.
  if (const auto held = whole_number(*text)) return *held;
  throw Usage("the seed file '" + printable_name(file.string()) +
              "' must hold a whole number below 2^64 and nothing else");
}

bool lies_within(const std::filesystem::path& inner, const std::filesystem::path& outer) {
  const auto whole = [](const std::filesystem::path& path) {
    return std::filesystem::weakly_canonical(path / "");
  };
  const auto above = whole(outer), below = whole(inner);
  const auto differ = std::ranges::mismatch(above, below);
  return differ.in1 == above.end() || differ.in1->empty();
}

}  // namespace grade
