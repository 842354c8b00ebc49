// SPDX-License-Identifier: MIT-0
#include "memory_check.h"

#include "compile.h"
#include "judge/driver.h"
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
  const judge::Caged caged{.kit = kit,
                           .driver = compiled.driver,
                           .sandbox = request.sandbox,
                           .build = cage::Build::checked,
                           .limits = longer(request.run_limits),
                           .longest = slower * longest_run(request)};
  judge::Session& session = judge::session();
  session = {};
  session.begin = [&] { return judge::begin_driver(caged); };
  session.seed = request.seed;
  judge::run_tests(request.exercise.name);
  return sanitizer_message(session.printed, header);
}

}  // namespace grade
