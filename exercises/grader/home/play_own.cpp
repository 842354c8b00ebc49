// SPDX-License-Identifier: MIT-0
#include "home/play_own.h"

#include <cstdio>

#include "compile.h"
#include "exit_codes.h"
#include "grade_command.h"
#include "home/play_page.h"
#include "home/scene.h"
#include "judge/called.h"
#include "judge/driver.h"
#include "judge/known.h"
#include "judge/session.h"
#include "kit.h"
#include "printable.h"
#include "report/files.h"
#include "submission.h"

namespace grade {
namespace {

/// Draws what the student's code does, as far as it comes.
Played played(const Scene& scene, const Request& request, const judge::Caged& caged) {
  Played played{scene, Stage(scene.view), ""};
  judge::Session& session = judge::session();
  session = {};
  session.exercise = request.exercise.name;
  try {
    session.begin = [&] { return judge::begin_called(judge::Known::right(scene.exercise)); };
    judge::Student right;
    session.begin = [&] { return judge::begin_driver(caged); };
    judge::Student yours;
    scene.film(played.stage, yours, right);
  } catch (const judge::Stopped&) {
  }
  played.why = session.why;
  return played;
}

/// The page's place; the reason why it can't be written there.
std::filesystem::path page_of(const Request& request) {
  std::filesystem::path page = request.submission;
  page.replace_filename(request.exercise.task() + ".html");
  const auto there = read_whole(page);
  if (there && !is_play_page(*there))
    throw Usage("'" + printable_name(page.string()) +
                "' is there already, and is not the grader's own; move it away");
  return page;
}

}  // namespace

int play_own(const Command& command) {
  Request request = command.request;
  const std::filesystem::path page = page_of(request);
  const Scene* const scene = scene_of(request.exercise.name);
  if (!scene) return refuse(Exit::bad_input, "nothing moves in " + request.exercise.name);
  do_without_a_cage_that_cannot_be_had(request);
  const Submission taken =
      read_submission(request.submission, request.exercise.chapter(), request.exercise.header());
  if (!taken.refused.empty()) return refuse(Exit::unreadable, printable(taken.refused));
  const cage::Kit kit = own_kit();
  const std::string harness = read_whole(request.exercise.folder / "harness.h").value_or("");
  const Compiled compiled = compile(taken.text, request.exercise.header(), harness, request.sandbox,
                                    kit, request.compile_limits);
  if (compiled.failed) return refuse(Exit::did_not_run, printable(compiled.message));
  const judge::Caged caged{.kit = kit,
                           .driver = compiled.driver,
                           .sandbox = request.sandbox,
                           .limits = request.run_limits};
  const Played seen = played(*scene, request, caged);
  request.runs = 1;
  const Report report = grade_driver(request, compiled.driver);
  write_whole(page, play_page(seen, report));
  std::printf("Open %s in a browser.\n", printable_name(page.string()).c_str());
  return seen.why.empty() ? Exit::graded : refuse(Exit::did_not_run, printable(seen.why));
}

}  // namespace grade
