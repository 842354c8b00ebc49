#!/usr/bin/env bash
# SPDX-License-Identifier: MIT-0
# Makes the zip of an autograder for Gradescope, of the grader that is built:
#   exercises/hosts/gradescope/make.sh --exercise 2-euler/orbit-drift --seed-file seed.txt
# --exercise may be repeated; all are one assignment. --out FILE.zip names another place than build/gradescope,
# --build FOLDER another build. Without --seed-file it grades with the public seed. The zip holds the seed: keep it to yourself.
set -euo pipefail

source=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../.." && pwd)
# shellcheck source=exercises/hosts/parts.sh
. "$source/exercises/hosts/parts.sh"
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

check "$source" "$build" "${exercises[@]}"
[ -z "$seed" ] || [[ $(tr -d ' \r\n' <"$seed") =~ ^[0-9]{1,20}$ ]] || fail "the seed file must hold a whole number and nothing else"
[ -n "$out" ] || out=$build/gradescope/${exercises[0]##*/}.zip

umask 077
stage=$(mktemp -d)
trap 'rm -rf "$stage"' EXIT
cp "$source"/exercises/hosts/gradescope/{setup.sh,run_autograder} "$stage"
[ -z "$seed" ] || cp "$seed" "$stage/seed.txt"
# The solution is graded first, on Gradescope's own machine: it sets the limits of time.
put_grader "$source" "$build" "$stage" task.md,starter.h,harness.h,solution.h "${exercises[@]}"

mkdir -p "$(dirname "$out")"
into=$(cd "$(dirname "$out")" && pwd)/$(basename "$out")
(cd "$stage" && cmake -E tar cf "$into.new" --format=zip -- *)
mv "$into.new" "$into"
[ -n "$seed" ] || echo "It grades with the public seed, which students have, too; --seed-file names one that only you know"
echo "$into: upload it as the autograder of a programming assignment"
