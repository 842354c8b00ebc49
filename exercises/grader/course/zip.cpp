// SPDX-License-Identifier: MIT-0
#include "course/zip.h"

#include <array>
#include <limits>
#include <stdexcept>

#include "printable.h"

namespace grade {
namespace {

constexpr std::array<std::uint32_t, 256> crc_table() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t i = 0; i < table.size(); ++i) {
    std::uint32_t c = i;
    for (int bit = 0; bit < 8; ++bit) c = (c & 1) != 0 ? 0xedb88320 ^ (c >> 1) : c >> 1;
    table[i] = c;
  }
  return table;
}

/// A number of two or four bytes, the lowest first.
template <int bytes>
std::string le(std::size_t number) {
  constexpr std::size_t most = (std::size_t{1} << (8 * bytes)) - 1;
  if (number >= most) throw std::length_error("the archive is too large");
  std::string text;
  for (int i = 0; i < bytes; ++i) text += char(number >> (8 * i) & 0xff);
  return text;
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t size = utf8_character(text);
    if (size == 0) return false;
    text.remove_prefix(size);
  }
  return true;
}

/// What stands before each file, and again in the list at the end.
std::string about(const ZipFile& file) {
  constexpr std::size_t version = 20, utf8_name = 1 << 11, stored = 0;
  constexpr std::size_t midnight = 0, first_of_1980 = 1 << 5 | 1;
  const std::uint32_t checksum = crc32(file.content);
  std::string crc;
  for (int i = 0; i < 4; ++i) crc += char(checksum >> (8 * i) & 0xff);
  return le<2>(version) + le<2>(is_utf8(file.name) ? utf8_name : 0) + le<2>(stored) +
         le<2>(midnight) + le<2>(first_of_1980) + crc + le<4>(file.content.size()) +
         le<4>(file.content.size()) + le<2>(file.name.size()) + le<2>(0);
}

std::string in_list(const ZipFile& file, std::size_t at) {
  constexpr std::size_t unix_and_version = 3 << 8 | 20, plain_file = 0100644;
  return "PK\x01\x02" + le<2>(unix_and_version) + about(file) + le<2>(0) + le<2>(0) + le<2>(0) +
         le<2>(0) + le<2>(plain_file) + le<4>(at) + file.name;
}

}  // namespace

std::uint32_t crc32(std::string_view text) {
  static constexpr std::array<std::uint32_t, 256> table = crc_table();
  std::uint32_t c = 0xffffffff;
  for (const char one : text) c = table[(c ^ static_cast<unsigned char>(one)) & 0xff] ^ (c >> 8);
  return c ^ 0xffffffff;
}

std::string zip(const std::vector<ZipFile>& files) {
  std::string archive, list;
  for (const ZipFile& file : files) {
    list += in_list(file, archive.size());
    archive += "PK\x03\x04" + about(file) + file.name + file.content;
  }
  const std::string count = le<2>(files.size());
  return archive + list + "PK\x05\x06" + le<2>(0) + le<2>(0) + count + count + le<4>(list.size()) +
         le<4>(archive.size()) + le<2>(0);
}

}  // namespace grade
