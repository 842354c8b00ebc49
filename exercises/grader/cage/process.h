// SPDX-License-Identifier: MIT-0
/// @file
/// A program that runs beside us within limits: its pipes, and an end that is certain.
#pragma once
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cage {

/// An open file that closes itself.
class File {
 public:
  File() = default;
  explicit File(int descriptor) : descriptor_(descriptor) {}
  File(File&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  File& operator=(File&& other) noexcept;
  ~File();
  int get() const { return descriptor_; }
  explicit operator bool() const { return descriptor_ >= 0; }

 private:
  int descriptor_ = -1;
};

/// Bytes as a file that has no name and cannot be changed any more.
File sealed(std::string_view content);

/// The address space of a program that may have as much as it likes.
inline constexpr std::size_t no_limit = static_cast<std::size_t>(-1);

/// The limits of a program.
struct Limits {
  double processor = 3;                ///< processor time [s]
  double wall = 10;                    ///< time on the clock [s]
  std::size_t memory = 1'000'000'000;  ///< address space [bytes]
  std::size_t file = 64 << 20;         ///< the longest file it writes [bytes]
  std::size_t output = 1 << 20;        ///< on stdout and stderr together [bytes]
};

/// The end of a program.
struct Ended {
  enum class How { exited, signalled, wall_limit, processor_limit, output_limit, never_started };
  How how = How::never_started;
  int code = 0;             ///< its exit code, or the number of the signal
  double processor = 0;     ///< used [s]
  double wall = 0;          ///< used [s]
  long peak_kilobytes = 0;  ///< of memory
  std::size_t unread = 0;   ///< bytes of its answer that nobody had asked for
  std::string out, err;     ///< of what it printed the first 16 KiB and the last
};

/// A program that answers on descriptor 3. It dies with this object, and all its children with it.
class Process {
 public:
  /// @param command  the program with its arguments
  /// One at a time: at its end every child of this process goes that came after it.
  ///
  /// @param files  our descriptors, and their numbers in the program (5 to 31)
  /// @param folder  removed at the end; none if empty
  Process(const std::vector<std::string>& command, const std::vector<std::pair<int, int>>& files,
          const Limits& limits, std::filesystem::path folder = {});
  ~Process();

  /// Writes to its standard input; false if it cannot be written to any more.
  bool send(std::span<const std::byte> bytes);

  /// Waits for exactly as many bytes of its answer; false if it ends or meets a limit before.
  bool receive(std::span<std::byte> bytes);

  /// All of its answer until its end, but no more than `most` bytes; more is an output_limit.
  std::string receive_all(std::size_t most);

  /// Closes its standard input, lets it come to its end, and takes everything down with it.
  Ended finish();

 private:
  class Pipes;
  std::unique_ptr<Pipes> pipes_;
  std::filesystem::path folder_;
};

}  // namespace cage
