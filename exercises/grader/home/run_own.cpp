// SPDX-License-Identifier: MIT-0
#include "home/run_own.h"

#include "compile.h"
#include "kit.h"
#include "replace_all.h"
#include "sanitizer_message.h"
#include "submission.h"

namespace grade {
namespace {

constexpr const char* header = "yours.h";

cage::Limits patient() {
  cage::Limits limits;
  limits.processor = 10;
  limits.wall = 30;
  return limits;
}

std::string ending(const cage::Ended& ended) {
  using How = cage::Ended::How;
  switch (ended.how) {
    case How::exited:
      return ended.code == 0 ? "" : "it ended with exit code " + std::to_string(ended.code);
    case How::signalled:
      return "it was ended by signal " + std::to_string(ended.code);
    case How::wall_limit:
    case How::processor_limit:
      return "it was stopped after " + std::to_string(static_cast<int>(ended.wall)) +
             " s. Is there a loop that never ends?";
    case How::output_limit:
      return "it printed without end";
    case How::never_started:
      break;
  }
  return "it could not be started: " + ended.err;
}

}  // namespace

Ran run_own(const std::filesystem::path& file, cage::Sandbox sandbox) {
  const Submission submission = read_submission(file, "", file.filename().string());
  if (!submission.refused.empty()) return {"", "", submission.refused, submission.unreadable};
  const cage::Kit kit = own_kit();
  if (sandbox == cage::Sandbox::bubblewrap) {
    if (const auto why = cage::unsafe(kit)) return {"", "", *why, false};
  }
  cage::Limits to_compile = patient();
  to_compile.memory = 2'500'000'000;
  const Compiled compiled =
      compile(submission.text, header, "", sandbox, kit, to_compile, cage::Build::own);
  const auto named = [&](const std::string& said) {
    return replace_all(said, header, submission.name);
  };
  if (compiled.failed) return {"", "", named(compiled.message), false};
  cage::Ended ended =
      cage::run(sandbox, kit, compiled.driver, patient(), cage::Build::own).finish();
  if (ran_out_of_memory(ended.err)) {
    return {ended.out, named(ended.err),
            "it was stopped when it held two gigabytes of memory. Does something grow without end?",
            false};
  }
  const std::string told = sanitizer_message(ended.err, header);
  if (!told.empty()) return {ended.out, "", named(told), false};
  return {ended.out, named(without_warnings(ended.err)), ending(ended), false};
}

}  // namespace grade
