#!/usr/bin/env bash
# SPDX-License-Identifier: MIT-0
# Makes the zip of an autograder for Gradescope, of the grader that is built:
#   exercises/hosts/gradescope/make.sh --exercise 2-euler/orbit-drift --seed-file seed.txt
# --exercise may be repeated; all are one assignment. --out FILE.zip names another place than build/gradescope,
# --build FOLDER another build. Without --seed-file it grades with the public seed. The zip holds the seed: keep it to yourself.
set -euo pipefail

fail() {
  echo "make.sh: $1" >&2
  exit 2
}

source=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../.." && pwd)
build=$source/build exercises=() seed="" out=""
while [ $# -gt 0 ]; do
  [ $# -gt 1 ] || fail "$1 needs a value"
  case $1 in
    --exercise) exercises+=("$2") ;;
    --seed-file) seed=$2 ;;
    --out) out=$2 ;;
    --build) build=$2 ;;
    *) fail "knows --exercise, --seed-file, --out and --build, not '$1'" ;;
  esac
  shift 2
done

[ ${#exercises[@]} -gt 0 ] || fail "name at least one --exercise; build/exercises/grade list names all"
for exercise in "${exercises[@]}"; do
  [[ $exercise =~ ^[0-9a-z-]+/[0-9a-z-]+$ && -f $source/exercises/$exercise/judge.cpp ]] ||
    fail "there is no exercise '$exercise'; build/exercises/grade list names all"
done
[ -x "$build/exercises/grade" ] || fail "there is no grader in $build; cmake --workflow --preset grader builds it"
[ -z "$seed" ] || [[ $(tr -d ' \r\n' <"$seed") =~ ^[0-9]{1,20}$ ]] || fail "the seed file must hold a whole number and nothing else"
[ -n "$out" ] || out=$build/gradescope/${exercises[0]##*/}.zip

umask 077
stage=$(mktemp -d)
trap 'rm -rf "$stage"' EXIT
cp "$source"/exercises/hosts/gradescope/{setup.sh,run_autograder} "$stage"
printf '%s\n' "${exercises[@]}" >"$stage/exercises.txt"
[ -z "$seed" ] || cp "$seed" "$stage/seed.txt"
for exercise in "${exercises[@]}"; do
  mkdir -p "$stage/exercises/$exercise"
  # The solution is graded first, on Gradescope's own machine: it sets the limits of time.
  cp "$source/exercises/$exercise"/{task.md,starter.h,harness.h,solution.h} "$stage/exercises/$exercise"
done
mkdir -p "$stage/exercises/grader" "$stage/build/exercises/grader/kit"
cp -R "$source/exercises/grader/harness" "$stage/exercises/grader"
cp "$build/exercises/grade" "$build/exercises/installed.txt" "$stage/build/exercises"
cp "$build/exercises/grader/kit"/{canary,limited,run.bpf,check.bpf,compile.bpf} "$stage/build/exercises/grader/kit"

mkdir -p "$(dirname "$out")"
into=$(cd "$(dirname "$out")" && pwd)/$(basename "$out")
(cd "$stage" && cmake -E tar cf "$into.new" --format=zip -- *)
mv "$into.new" "$into"
[ -n "$seed" ] || echo "It grades with the public seed, which students have, too; --seed-file names one that only you know"
echo "$into: upload it as the autograder of a programming assignment"
