// SPDX-License-Identifier: MIT-0
#include "home/play_own.h"

#include <cstdio>

#include "exit_codes.h"
#include "grade_command.h"
#include "home/own_driver.h"
#include "home/play_page.h"
#include "home/scene.h"
#include "judge/session.h"
#include "printable.h"
#include "report/files.h"
#include "without_a_cage.h"

namespace grade {
namespace {

/// Draws what the student's code does, as far as it comes.
Played played(const Scene& scene, const OwnDriver& own) {
  Played played{scene, Stage(scene.view), ""};
  judge::Session& session = judge::session();
  session = {};
  session.exercise = scene.exercise;
  try {
    judge::Student right = begin_right(scene.exercise), yours = own.begin();
    scene.film(played.stage, yours, right);
  } catch (const judge::Stopped&) {
  }
  played.why = session.why;
  return played;
}

/// The page's place.
std::filesystem::path page_of(const Request& request) {
  std::filesystem::path page = request.submission;
  page.replace_filename(request.exercise.task() + ".html");
  refuse_foreign_page(page);
  return page;
}

}  // namespace

int play_own(const Command& command) {
  Request request = command.request;
  const std::filesystem::path page = page_of(request);
  const Scene* const scene = scene_of(request.exercise.name);
  if (!scene) return refuse(Exit::bad_input, "nothing moves in " + request.exercise.name);
  do_without_a_cage_that_cannot_be_had(request);
  const OwnDriver own(request);
  if (!own.why_not.empty())
    return refuse(own.unreadable ? Exit::unreadable : Exit::did_not_run, printable(own.why_not));
  const Played seen = played(*scene, own);
  request.runs = 1;
  const Report report = grade_driver(request, own.driver());
  write_whole(page, play_page(seen, report));
  std::printf("Open %s in a browser.\n", printable_name(page.string()).c_str());
  return seen.why.empty() ? Exit::graded : refuse(Exit::did_not_run, printable(seen.why));
}

}  // namespace grade
