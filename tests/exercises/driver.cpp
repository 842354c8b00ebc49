// SPDX-License-Identifier: MIT-0
// What makes a driver of the ways that ways.mjs writes. Its first argument says which of them it
// is: the header's path. Behind it stand its limits, which it sets itself, so that no other program
// is needed to start it: processor time [s], address space and files [bytes].
#include <sys/prctl.h>
#include <sys/resource.h>

#include <csignal>
#include <cstdlib>

#include "call.h"

extern "C" void (*way_of(const char* header))(harness::Call&);

namespace {

void (*chosen)(harness::Call&);

void limit(__rlimit_resource resource, const char* text, rlim_t more = 0) {
  const rlim_t soft = std::strtoul(text, nullptr, 10);
  const rlimit both = {soft, soft + more};
  if (setrlimit(resource, &both) != 0) std::abort();
}

[[gnu::constructor]] void begin(int count, char** arguments, char**) {
  chosen = count == 5 ? way_of(arguments[1]) : nullptr;
  if (!chosen) std::abort();
  // At the soft limit comes SIGXCPU, which can be told from other ends; at the hard one SIGKILL.
  limit(RLIMIT_CPU, arguments[2], 1);
  limit(RLIMIT_AS, arguments[3]);
  limit(RLIMIT_FSIZE, arguments[4]);
  limit(RLIMIT_CORE, "0");
  prctl(PR_SET_PDEATHSIG, SIGKILL);
}

}  // namespace

void answer(harness::Call& call) {
  chosen(call);
}
