// SPDX-License-Identifier: MIT-0
/// @file
/// The inside of a Process: the pipes, and one turn of waiting on all of them at once.
#pragma once
#include <optional>

#include "process.h"
#include "process_tree.h"

namespace cage {

class Process::Pipes {
 public:
  /// The part of an answer that is read before anybody asks for it [bytes]; beyond, the program has
  /// to wait.
  static constexpr std::size_t ahead = 65536;

  explicit Pipes(const Limits& limits) : limits_(limits) {}

  void start(const std::vector<std::string>& command, const std::vector<std::pair<int, int>>& files,
             bool tells_status);

  bool over() const { return over_; }
  bool writable() const { return !over_ && in_; }
  bool readable() const { return !over_ && reply_; }

  /// Waits until something happens on any pipe, and takes it in.
  /// @param wanted  how long the answer has to become before it is left in the pipe
  /// @param unsent  for the program's standard input; what was written is taken off its front
  void poll_once(std::size_t wanted, std::span<const std::byte>* unsent = nullptr);

  /// Ends the program now.
  void stop(Ended::How how);

  void close_input() { in_ = File(); }

  /// Counts and forgets what nobody asked for; more than the program may print ends it.
  void discard_answer();

  const Ended& ended() const { return ended_; }

  /// Bytes of the answer that are here and not yet asked for.
  std::size_t available() const { return answer_.size() - given_; }

  /// Hands them out; there must be as many.
  void give(std::span<std::byte> bytes);

 private:
  using Clock = std::chrono::steady_clock;

  int until_deadline() const;
  void write_input(std::span<const std::byte>& unsent);
  void read_pipes(std::size_t wanted);
  void read_output(File& pipe, std::string& kept);
  void reap();  ///< kills and reaps the program, and reads what it left in the pipes

  Limits limits_;
  Clock::time_point start_, deadline_;
  std::vector<pid_t> before_;
  pid_t program_ = 0;
  File handle_, in_, out_, err_, reply_, status_;
  bool tells_status_ = false, over_ = false;
  std::optional<Ended::How> stopped_;
  std::size_t printed_ = 0, given_ = 0;
  std::string answer_, status_text_;
  Ended ended_;
};

}  // namespace cage
