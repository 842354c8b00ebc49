// SPDX-License-Identifier: MIT-0
#include "header_text.h"

#include <algorithm>
#include <cstddef>

#include "printable.h"

namespace grade {

namespace {

using namespace std::literals;

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

struct Kind {
  std::size_t at;
  std::string_view mark, name;
};

constexpr Kind kinds[] = {
    {0, "PK\x03\x04"sv, "a zip archive"},
    {0, "PK\x05\x06"sv, "a zip archive"},
    {0, "\x1f\x8b"sv, "a gzip archive"},
    {0, "BZh"sv, "a bzip2 archive"},
    {0,
     "\xfd"
     "7zXZ"sv,
     "an xz archive"},
    {0, "7z\xbc\xaf"sv, "a 7z archive"},
    {0, "Rar!"sv, "a rar archive"},
    {257, "ustar"sv, "a tar archive"},
    {0,
     "\x7f"
     "ELF"sv,
     "a compiled program or object"},
    {0, "!<arch>"sv, "a compiled library"},
    {0, "gpch"sv, "a precompiled header"},
    {0, "MZ"sv, "a Windows program"},
    {0, "%PDF-"sv, "a PDF document"},
    {0, "\xd0\xcf\x11\xe0"sv, "an Office document"},
};

bool is(std::string_view content, const Kind& kind) {
  return content.size() > kind.at && content.substr(kind.at).starts_with(kind.mark) &&
         (kind.mark != "MZ" || content.find('\0') != content.npos);
}

bool utf32(std::string_view content) {
  return content.starts_with("\xff\xfe\0\0"sv) || content.starts_with("\0\0\xfe\xff"sv);
}

bool utf16(std::string_view content) {
  if (content.starts_with("\xff\xfe") || content.starts_with("\xfe\xff")) return true;
  // Without a mark: every other byte of Latin letters is zero.
  const auto zeros = std::ranges::count(content, '\0');
  return content.size() >= 4 && zeros * 5 > static_cast<long>(content.size()) * 2 &&
         (content[0] == '\0' || content[1] == '\0') && content[0] != content[1];
}

/// The line that holds the first byte that is not UTF-8; 0 if there is none.
long broken_line(std::string_view content) {
  std::string_view left = content;
  while (!left.empty()) {
    const std::size_t size = utf8_character(left);
    if (size == 0)
      return 1 + std::ranges::count(content.substr(0, content.size() - left.size()), '\n');
    left.remove_prefix(size);
  }
  return 0;
}

}  // namespace

std::string not_a_header(std::string_view content) {
  for (const Kind& kind : kinds)
    if (is(content, kind))
      return "is " + std::string(kind.name) + "; hand in the header itself, which is text";
  if (content.size() > longest)
    return "is longer than " + std::to_string(longest / 1024) +
           " KiB, which no solution needs; hand in the header alone";
  if (utf32(content)) return "is saved as UTF-32; save it as UTF-8";
  if (utf16(content)) return "is saved as UTF-16; save it as UTF-8";
  if (content.find('\0') != content.npos) return "is not text: it holds a zero byte";
  if (const long line = broken_line(content))
    return "is not UTF-8 text: see line " + std::to_string(line) + "; save it as UTF-8";
  if (content.starts_with(byte_order_mark)) content.remove_prefix(byte_order_mark.size());
  if (content.starts_with(byte_order_mark))
    return "begins with two byte order marks; save it as UTF-8 without any";
  if (content.find('\x1a') != content.npos)
    return "holds the character Ctrl-Z, with which old editors end a file; take it out";
  if (content.find_first_not_of(" \t\r\n\f\v") == content.npos)
    return "is empty; it must define what the task asks for";
  return {};
}

}  // namespace grade
