#!/bin/sh
# as_user.sh KIT INSTALLED PROGRAMS: runs the cage's tests again as a user who is not root, with a copy of
# all that they need, since the build may lie where only root can read.
set -eu
if [ "$(id -u)" != 0 ]; then
  echo "not root: the tests ran as an ordinary user already"
  exit 77
fi
user=61100
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
cp -R "$1" "$copy/kit"
cp -R "$3" "$copy/programs"
cp "$2" "$copy/programs/installed.txt"
chown -R $user:$user "$copy"
setpriv --reuid $user --regid $user --clear-groups --inh-caps=-all -- \
  env KIT="$copy/kit" TMPDIR="$copy" "$copy/programs/tests.grader.cage"
