# SPDX-License-Identifier: MIT-0
# What both make.sh need, which read this file: what they refuse, and the parts of the grader that they hand over.

fail() {
  echo "make.sh: $1" >&2
  exit 2
}

# check SOURCE BUILD EXERCISE...: all of them are there, and the grader is built
check() {
  local source=$1 build=$2 exercise
  shift 2
  [ $# -gt 0 ] || fail "name at least one --exercise; build/exercises/grade list names all"
  for exercise in "$@"; do
    [[ $exercise =~ ^[0-9a-z-]+/[0-9a-z-]+$ && -f $source/exercises/$exercise/judge.cpp ]] ||
      fail "there is no exercise '$exercise'; build/exercises/grade list names all"
  done
  [ -x "$build/exercises/grade" ] || fail "there is no grader in $build; cmake --workflow --preset grader builds it"
}

# put_grader SOURCE BUILD FOLDER FILES EXERCISE...: the grader, the list of the exercises, and of each these files (a,b,c)
put_grader() {
  local source=$1 build=$2 into=$3 files exercise file
  IFS=, read -ra files <<<"$4"
  shift 4
  mkdir -p "$into/exercises/grader" "$into/build/exercises/grader/kit"
  printf '%s\n' "$@" >"$into/exercises.txt"
  for exercise in "$@"; do
    mkdir -p "$into/exercises/$exercise"
    for file in "${files[@]}"; do cp "$source/exercises/$exercise/$file" "$into/exercises/$exercise"; done
  done
  cp -R "$source/exercises/grader/harness" "$into/exercises/grader"
  cp "$build/exercises/grade" "$build/exercises/installed.txt" "$into/build/exercises"
  cp "$build/exercises/grader/kit"/{canary,limited,run.bpf,check.bpf,compile.bpf} "$into/build/exercises/grader/kit"
}
