// SPDX-License-Identifier: MIT-0
/// @file
/// Archives.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace grade {

struct ZipFile {
  std::string name;  ///< with its folders, parted by `/`
  std::string content;
};

/// The archive of these files, stored as they are: other programs pack more, and a few megabytes
/// matter to nobody. The same files give the same bytes.
/// @throws std::length_error  it would have 65535 files or more, or four gigabytes
std::string zip(const std::vector<ZipFile>& files);

/// The checksum of archives (CRC-32).
std::uint32_t crc32(std::string_view text);

}  // namespace grade
