// SPDX-License-Identifier: MIT-0
#include "process.h"

#include <signal.h>

#include <algorithm>
#include <system_error>

#include "pipes.h"
#include "process_tree.h"
#include "spawn.h"

namespace cage {

namespace {

using How = Ended::How;

/// bubblewrap tells on descriptor 4 whether it could start the program; nobody else does.
bool tells_status(const std::vector<std::string>& command) {
  return std::ranges::count(command, "--json-status-fd") > 0;
}

}  // namespace

Process::Process(const std::vector<std::string>& command,
                 const std::vector<std::pair<int, int>>& files, const Limits& limits,
                 std::filesystem::path folder)
    : pipes_(std::make_unique<Pipes>(limits)), folder_(std::move(folder)) {
  ::signal(SIGPIPE, SIG_IGN);  // a program that stops reading must not end us
  become_subreaper();
  pipes_->start(command, files, tells_status(command));
}

Process::~Process() {
  if (pipes_ && !pipes_->over()) pipes_->stop(How::signalled);
  std::error_code left;
  if (!folder_.empty()) std::filesystem::remove_all(folder_, left);
}

bool Process::send(std::span<const std::byte> bytes) {
  while (!bytes.empty() && pipes_->writable()) pipes_->poll_once(Pipes::ahead, &bytes);
  return bytes.empty();
}

bool Process::receive(std::span<std::byte> bytes) {
  while (pipes_->available() < bytes.size() && pipes_->readable()) pipes_->poll_once(bytes.size());
  if (pipes_->available() < bytes.size()) return false;
  pipes_->give(bytes);
  return true;
}

std::string Process::receive_all(std::size_t most) {
  pipes_->close_input();
  while (pipes_->readable() && pipes_->available() <= most) pipes_->poll_once(most + 1);
  if (pipes_->available() > most) pipes_->stop(How::output_limit);
  std::string answer(std::min(pipes_->available(), most), '\0');
  pipes_->give(std::as_writable_bytes(std::span(answer)));
  return answer;
}

Ended Process::finish() {
  pipes_->close_input();
  while (!pipes_->over()) {
    pipes_->discard_answer();
    pipes_->poll_once(Pipes::ahead);
  }
  pipes_->discard_answer();
  return pipes_->ended();
}

}  // namespace cage
