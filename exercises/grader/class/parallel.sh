#!/usr/bin/env bash
# SPDX-License-Identifier: MIT-0
# Grades one exercise of a class by GNU parallel, on this machine or on several:
#   PARALLEL='--jobs 8' parallel.sh path/to/grade 2-euler/orbit-drift submissions results --seed-file seed.txt
# GNU parallel takes its own options from the variable PARALLEL, among them `--sshloginfile nodes`, if the folders are the
# same on all of them. Afterwards the grader makes the tables, and grades what was left over:
#   grade --class submissions --out results --seed-file seed.txt
set -euo pipefail
[ $# -ge 4 ] || { echo "usage: ${0##*/} GRADE EXERCISE SUBMISSIONS RESULTS [OPTION OF GRADE...]" >&2; exit 2; }
grade=$1 exercise=$2 submissions=$3 results=$4
shift 4

find "$submissions" -mindepth 1 -maxdepth 1 -type d -not -name '.*' -printf '%f\0' | sort -z |
  parallel --null --quote "$grade" --out "$results/{}/$exercise" "$@" -- "$exercise" "$submissions/{}" >/dev/null
