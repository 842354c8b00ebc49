#!/usr/bin/env bash
# SPDX-License-Identifier: MIT-0
# Makes the files of a template repository, whose students' repositories grade themselves by GitHub Actions:
#   exercises/hosts/github/make.sh --exercise 2-euler/orbit-drift --out week-2
# --exercise may be repeated. --build FOLDER names another build. It has no seed but the public one, and no solution.
set -euo pipefail

fail() {
  echo "make.sh: $1" >&2
  exit 2
}

source=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../.." && pwd)
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

[ ${#exercises[@]} -gt 0 ] || fail "name at least one --exercise; build/exercises/grade list names all"
for exercise in "${exercises[@]}"; do
  [[ $exercise =~ ^[0-9a-z-]+/[0-9a-z-]+$ && -f $source/exercises/$exercise/judge.cpp ]] ||
    fail "there is no exercise '$exercise'; build/exercises/grade list names all"
done
[ -x "$build/exercises/grade" ] || fail "there is no grader in $build; cmake --workflow --preset grader builds it"
[ -n "$out" ] || fail "name a folder that is not there yet: --out week-2"
[ ! -e "$out" ] || fail "'$out' is there already; name another folder"

here=$source/exercises/hosts/github grader=$out/.grader
mkdir -p "$out/.github/workflows" "$grader/exercises/grader" "$grader/build/exercises/grader/kit"
cp "$here/classroom.yml" "$out/.github/workflows"
cp "$here/student.md" "$out/README.md"
printf '%s\n' "${exercises[@]}" >"$grader/exercises.txt"
for exercise in "${exercises[@]}"; do
  mkdir -p "$grader/exercises/$exercise"
  cp "$source/exercises/$exercise"/{task.md,starter.h,harness.h} "$grader/exercises/$exercise"
  cp "$source/exercises/$exercise/starter.h" "$out/${exercise##*/}.h"
done
cp -R "$source/exercises/grader/harness" "$grader/exercises/grader"
cp "$build/exercises/grade" "$build/exercises/installed.txt" "$grader/build/exercises"
cp "$build/exercises/grader/kit"/{canary,limited,run.bpf,check.bpf,compile.bpf} "$grader/build/exercises/grader/kit"
printf 'include(%s)\nput_licences(%s)\n' "$source/exercises/handout/licences.cmake" "$(cd "$grader" && pwd)/licences" >"$out/.licences.cmake"
cmake -DGXX="$(readlink -f "$(command -v g++)")" -P "$out/.licences.cmake"
rm "$out/.licences.cmake"
echo "$out: make it a repository, and that one a template"
