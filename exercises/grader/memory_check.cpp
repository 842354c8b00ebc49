// SPDX-License-Identifier: MIT-0
#include "memory_check.h"

#include "compile.h"
#include "judge/session.h"
#include "sanitizer_message.h"
#include "time_limits.h"

namespace grade {
namespace {

// It is several times as slow.
constexpr double slower = 5;

cage::Limits longer(cage::Limits limits) {
  limits.processor *= slower;
  limits.wall *= slower;
  return limits;
}

}  // namespace

std::string misused_memory(const Request& request, const cage::Kit& kit, const std::string& text,
                           const std::string& harness) {
  const std::string header = request.exercise.header();
  const Compiled compiled = compile(text, header, harness, request.sandbox, kit,
                                    longer(request.compile_limits), cage::Build::checked);
  if (compiled.failed) return {};
  judge::Session& session = judge::session();
  session = {};
  session.kit = &kit;
  session.driver = &compiled.driver;
  session.sandbox = request.sandbox;
  session.build = cage::Build::checked;
  session.limits = longer(request.run_limits);
  session.longest = slower * longest_run(request);
  session.seed = request.seed;
  judge::run_tests(request.exercise.name);
  return sanitizer_message(session.printed, header);
}

}  // namespace grade
