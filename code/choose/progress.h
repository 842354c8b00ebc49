// SPDX-License-Identifier: MIT-0
/// @file
/// Tells whoever waits how far a search has got.
#pragma once
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <functional>
#include <string>

/// Is told what is being tried; nobody is, if it is empty.
using Tell = std::function<void(const std::string& what)>;

/// What takes longer than two seconds says so: in a terminal in one line that is written again and
/// again, and gone at the end; elsewhere in lines that come at twice the time of the one before.
template <class Clock = std::chrono::steady_clock>
class Progress {
 public:
  /// @param out  where to, such as stderr
  /// @param terminal  whether that is one
  Progress(std::FILE* out, bool terminal) : out_(out), terminal_(terminal) {}
  ~Progress() {
    if (terminal_ && told_) std::fputs("\r\033[K", out_);
  }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Tells it, if it is time.
  void operator()(const std::string& what) {
    const double now = std::chrono::duration<double>(Clock::now() - start_).count();
    if (now < next_) return;
    next_ = terminal_ ? now + 0.1 : 2 * now;
    std::fprintf(out_, terminal_ ? "\r\033[Kchoose: %.0f s, %s" : "choose: %.0f s, %s\n", now,
                 what.c_str());
    std::fflush(out_);
    told_ = true;
  }

 private:
  std::FILE* out_;
  bool terminal_, told_ = false;
  double next_ = 2;
  typename Clock::time_point start_ = Clock::now();
};

/// Does some work that may take long, and tells on stderr how far it has got.
/// @param quiet  whether nobody is told
/// @param work  is called with whom to tell
template <class Work>
auto with_progress(bool quiet, const Work& work) {
  if (quiet) return work(Tell());
  Progress progress(stderr, isatty(STDERR_FILENO) != 0);
  return work(Tell(std::ref(progress)));
}
