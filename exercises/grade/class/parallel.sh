#!/usr/bin/env bash
# SPDX-License-Identifier: MIT-0
# Grades one exercise of a class by GNU parallel, which can also spread the work over machines:
#   parallel.sh path/to/grade 2-euler/orbit-drift submissions results [options of parallel]
# such as `--jobs 8 --sshloginfile nodes`, where the folders are the same on all of them. Afterwards
# `grade --class submissions --out results` makes the tables, and grades what was left over.
set -euo pipefail
[ $# -ge 4 ] || { echo "usage: ${0##*/} GRADE EXERCISE SUBMISSIONS RESULTS [OPTION...]" >&2; exit 2; }
grade=$1 exercise=$2 submissions=$3 results=$4
shift 4

find "$submissions" -mindepth 1 -maxdepth 1 -type d -not -name '.*' -printf '%f\0' | sort -z |
  parallel --null --quote "$@" "$grade" --out "$results/{}/$exercise" -- "$exercise" "$submissions/{}" >/dev/null
