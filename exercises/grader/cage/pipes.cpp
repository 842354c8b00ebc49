// SPDX-License-Identifier: MIT-0
#include "pipes.h"

#include <poll.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "exit_status.h"
#include "spawn.h"

namespace cage {

namespace {

constexpr std::size_t kept = 16384;  // at the start of what a program prints, and at its end

/// Leaves the start and the end of a text, as whole as they are.
void shorten(std::string& text) {
  constexpr std::string_view gap = "\n[...]\n";
  if (text.size() <= 2 * kept + gap.size()) return;
  text.replace(kept, text.size() - 2 * kept, gap);
}

/// Adds what is there, but no more than `most` bytes; closes the pipe at its end.
std::size_t take(File& pipe, std::string& to, std::size_t most) {
  std::array<char, 65536> bytes;
  std::size_t taken = 0;
  while (pipe && taken < most) {
    const ssize_t got = ::read(pipe.get(), bytes.data(), std::min(bytes.size(), most - taken));
    if (got > 0) {
      to.append(bytes.data(), static_cast<std::size_t>(got));
      taken += static_cast<std::size_t>(got);
    } else if (got == 0 || (errno != EAGAIN && errno != EINTR)) {
      pipe = File();
    } else {
      break;
    }
  }
  return taken;
}

}  // namespace

void Process::Pipes::start(const std::vector<std::string>& command,
                           const std::vector<std::pair<int, int>>& files, bool tells_status) {
  Pipe in = open_pipe(), out = open_pipe(), err = open_pipe(), reply = open_pipe(),
       status = open_pipe();
  std::vector<std::pair<int, int>> given = {
      {in.read.get(), 0}, {out.write.get(), 1}, {err.write.get(), 2}, {reply.write.get(), 3}};
  if (tells_status) given.emplace_back(status.write.get(), 4);
  given.insert(given.end(), files.begin(), files.end());

  tells_status_ = tells_status;
  before_ = children();
  start_ = Clock::now();
  deadline_ = start_ + std::chrono::duration_cast<Clock::duration>(
                           std::chrono::duration<double>(limits_.wall));
  program_ = spawn(command, given);
  if (program_ == 0) {
    ended_.err = "cannot start " + command[0] + ": " + std::strerror(errno);
    over_ = true;
    return;
  }
  handle_ = File(static_cast<int>(::syscall(SYS_pidfd_open, program_, 0)));
  in_ = std::move(in.write);
  out_ = std::move(out.read);
  err_ = std::move(err.read);
  reply_ = std::move(reply.read);
  status_ = std::move(status.read);
  for (const File* pipe : {&in_, &out_, &err_, &reply_, &status_}) set_nonblocking(*pipe);
}

int Process::Pipes::until_deadline() const {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline_ - Clock::now());
  return static_cast<int>(std::max<long>(0, left.count()));
}

void Process::Pipes::poll_once(std::size_t wanted, std::span<const std::byte>* unsent) {
  std::vector<pollfd> waiting = {{handle_.get(), POLLIN, 0}};
  for (const File* pipe : {&out_, &err_, &status_})
    if (*pipe) waiting.push_back({pipe->get(), POLLIN, 0});
  if (reply_ && available() < wanted) waiting.push_back({reply_.get(), POLLIN, 0});
  if (in_ && unsent) waiting.push_back({in_.get(), POLLOUT, 0});

  const int ready = ::poll(waiting.data(), waiting.size(), until_deadline());
  if (ready < 0 && errno != EINTR) return stop(Ended::How::never_started);
  if (ready == 0 && until_deadline() == 0) return stop(Ended::How::wall_limit);
  if (in_ && unsent) write_input(*unsent);
  read_pipes(wanted);
  if (printed_ > limits_.output) return stop(Ended::How::output_limit);
  if (waiting.front().revents != 0) reap();
}

void Process::Pipes::write_input(std::span<const std::byte>& unsent) {
  const ssize_t written = ::write(in_.get(), unsent.data(), unsent.size());
  if (written > 0)
    unsent = unsent.subspan(static_cast<std::size_t>(written));
  else if (errno != EAGAIN && errno != EINTR)
    in_ = File();
}

void Process::Pipes::read_pipes(std::size_t wanted) {
  if (given_ > ahead) answer_.erase(0, std::exchange(given_, 0));
  if (available() < wanted) take(reply_, answer_, std::max(wanted, ahead) - available());
  read_output(out_, ended_.out);
  read_output(err_, ended_.err);
  take(status_, status_text_, ahead);
}

void Process::Pipes::read_output(File& pipe, std::string& to) {
  printed_ += take(pipe, to, ahead);
  shorten(to);
}

void Process::Pipes::give(std::span<std::byte> bytes) {
  if (bytes.empty()) return;
  std::memcpy(bytes.data(), answer_.data() + given_, bytes.size());
  given_ += bytes.size();
  if (available() > 0) return;
  answer_.clear();
  given_ = 0;
}

void Process::Pipes::discard_answer() {
  ended_.unread += available();
  answer_.clear();
  given_ = 0;
  if (!over_ && ended_.unread > limits_.output) stop(Ended::How::output_limit);
}

void Process::Pipes::stop(Ended::How how) {
  if (over_) return;
  stopped_ = how;
  reap();
}

void Process::Pipes::reap() {
  const Reaped reaped = kill_and_reap(program_, before_);
  over_ = true;
  // Nobody is left to write, so the pipes hold only what fits into them.
  read_pipes(available() + (1 << 20));
  ended_.processor = reaped.processor;
  ended_.peak_kilobytes = reaped.peak_kilobytes;
  ended_.wall = std::chrono::duration<double>(Clock::now() - start_).count();
  if (stopped_)
    ended_.how = *stopped_;
  else
    decode_status(ended_, reaped.status, limits_, tells_status_ ? &status_text_ : nullptr);
}

}  // namespace cage
