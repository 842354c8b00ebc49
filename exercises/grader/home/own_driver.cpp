// SPDX-License-Identifier: MIT-0
#include "home/own_driver.h"

#include "judge/called.h"
#include "judge/known.h"
#include "judge/session.h"
#include "kit.h"
#include "replace_all.h"
#include "report/files.h"
#include "submission.h"

namespace grade {

OwnDriver::OwnDriver(const Request& request)
    : kit_(own_kit()),
      caged_{.kit = kit_,
             .driver = compiled_.driver,
             .sandbox = request.sandbox,
             .limits = request.run_limits} {
  const std::string header = request.exercise.header();
  const Submission taken = read_submission(request.submission, request.exercise.chapter(), header);
  why_not = taken.refused;
  unreadable = !taken.refused.empty();
  if (unreadable) return;
  const std::string harness = read_whole(request.exercise.folder / "harness.h").value_or("");
  compiled_ = compile(taken.text, header, harness, request.sandbox, kit_, request.compile_limits);
  if (compiled_.failed) why_not = replace_all(compiled_.message, header, taken.name);
}

judge::Student OwnDriver::begin() const {
  judge::session().begin = [this] { return judge::begin_driver(caged_); };
  return {};
}

judge::Student begin_right(const std::string& exercise) {
  judge::session().begin = [exercise] {
    return judge::begin_called(judge::Known::solution(exercise));
  };
  return {};
}

}  // namespace grade
