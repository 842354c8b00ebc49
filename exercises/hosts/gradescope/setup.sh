#!/usr/bin/env bash
# SPDX-License-Identifier: MIT-0
# Gradescope runs this once, as root, when it makes the image in which submissions are graded: Ubuntu, or Debian.
set -euo pipefail
source=${AUTOGRADER:-/autograder}/source
export DEBIAN_FRONTEND=noninteractive
apt-get update
apt-get install -y --no-install-recommends g++ bubblewrap util-linux
chmod u+x "$source/build/exercises/grade"
# What each submission is compiled with is made here, once.
"$source/build/exercises/grade" check || true
chmod -R go= "$source"
[ -s "$source/build/exercises/grader/kit/compiler.txt" ] || {
  echo "setup.sh: the grader could not make ready what it compiles with" >&2
  exit 1
}
