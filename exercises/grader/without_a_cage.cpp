// SPDX-License-Identifier: MIT-0
#include "without_a_cage.h"

#include <sys/stat.h>

#include <cstdio>

#include "cage/command.h"
#include "command_line.h"
#include "printable.h"

namespace grade {
namespace {

/// Two users are a wall, if there are two, and if the file is the one's alone.
void keep_secret(const std::filesystem::path& seed_file) {
  if (seed_file.empty()) return;
  const std::string shown = "'" + printable_name(seed_file.string()) + "'";
  if (!cage::unprivileged())
    throw Usage("without a cage the code that is graded could read " + shown +
                "; grade where a cage can be had, or as root, or name no seed file");
  struct stat about{};
  const bool own = ::stat(seed_file.c_str(), &about) == 0 && about.st_uid == 0;
  if (!own || (about.st_mode & 077) != 0)
    throw Usage("without a cage the code that is graded could read " + shown +
                "; as root: chown root and chmod 600 it");
}

}  // namespace

void do_without_a_cage(Request& request) {
  keep_secret(request.seed_file);
  request.sandbox = cage::Sandbox::none;
}

void do_without_a_cage_that_cannot_be_had(Request& request) {
  if (request.sandbox == cage::Sandbox::none) return;
  if (!unsafe()) return;
  do_without_a_cage(request);
  std::fprintf(stderr, "No cage here, so %s: grade check says why.\n",
               cage::unprivileged() ? "the code runs as a user who is nobody else"
                                    : "your code runs like any program of yours");
}

}  // namespace grade
