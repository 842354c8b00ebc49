#!/usr/bin/env bash
# SPDX-License-Identifier: MIT-0
# Makes the files of a template repository, whose students' repositories grade themselves by GitHub Actions:
#   exercises/hosts/github/make.sh --exercise 2-euler/orbit-drift --out week-2
# --exercise may be repeated. --build FOLDER names another build. It has no seed but the public one, and no solution.
set -euo pipefail

source=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../.." && pwd)
# shellcheck source=exercises/hosts/parts.sh
. "$source/exercises/hosts/parts.sh"
build=$source/build exercises=() out=""
while [ $# -gt 0 ]; do
  [ $# -gt 1 ] || fail "$1 needs a value"
  case $1 in
    --exercise) exercises+=("$2") ;;
    --out) out=$2 ;;
    --build) build=$2 ;;
    *) fail "knows --exercise, --out and --build, not '$1'" ;;
  esac
  shift 2
done

check "$source" "$build" "${exercises[@]}"
[ -n "$out" ] || fail "name a folder that is not there yet: --out week-2"
[ ! -e "$out" ] || fail "'$out' is there already; name another folder"

here=$source/exercises/hosts/github grader=$out/.grader
mkdir -p "$out/.github/workflows"
cp "$here/classroom.yml" "$out/.github/workflows"
cp "$here/student.md" "$out/README.md"
cat >"$out/.gitignore" <<'END'
# What the grader makes when it runs
/.grader/build/exercises/done.txt
/.grader/build/exercises/hints.txt
/.grader/build/exercises/grader/kit/compiler.txt
/.grader/build/exercises/grader/kit/harness/
END
put_grader "$source" "$build" "$grader" task.md,starter.h,harness.h "${exercises[@]}"
for exercise in "${exercises[@]}"; do
  cp "$source/exercises/$exercise/starter.h" "$out/${exercise##*/}.h"
done
printf 'include(%s)\nput_licences(%s)\n' "$source/exercises/handout/licences.cmake" "$(cd "$grader" && pwd)/licences" >"$out/.licences.cmake"
cmake -DGXX="$(readlink -f "$(command -v g++)")" -P "$out/.licences.cmake"
rm "$out/.licences.cmake"
echo "$out: make it a repository, and that one a template"
