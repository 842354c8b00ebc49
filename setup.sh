#!/usr/bin/env bash
# SPDX-License-Identifier: MIT-0
# Brings all that building and testing the book needs: packages of the distribution, and npm packages by the lock file.
# Run again, it does nothing. For Debian 12 and 13; written for Ubuntu 24.04 too, but not tested there.
#   ./setup.sh          the book and its tests
#   ./setup.sh thorough these, and what the tests need that the preset `test` leaves out
#   ./setup.sh peers    the first, and the libraries that the benchmark sets beside the book's methods
#   ./setup.sh grader   only what the grader needs: to compile it, and to run it
set -euo pipefail

fail() {
  echo "setup.sh: $1" >&2
  exit "${2:-1}"
}

case "$# $*" in
  "0 ") purpose="the book needs" ;;
  "1 thorough") purpose="all tests of the book need" ;;
  "1 peers") purpose="the book and its benchmark need" ;;
  "1 grader") purpose="the grader needs" ;;
  *) fail "knows no argument but \"thorough\", \"peers\" and \"grader\", not \"$*\"" 2 ;;
esac
cd "$(dirname "${BASH_SOURCE[0]}")"
# shellcheck source=/dev/null
system=$({ . /etc/os-release && echo "$ID $VERSION_ID"; } 2>/dev/null) || system=unknown
chromium=chromium-headless-shell firefox=firefox-esr
[ "$system" != "ubuntu 24.04" ] || chromium=chromium-browser firefox=firefox

# packages: what for
needs="cmake ninja-build g++: to build the programs and the tests
gnuplot-nox: figures
bubblewrap: the cage in which exercises are graded
libeigen3-dev: vectors and linear systems
catch2: C++ tests, version 3
libcli11-dev: command lines, of the chooser of methods and of the grader
libseccomp-dev nlohmann-json3-dev libtomlplusplus-dev: the grader
nodejs: to make the mistakes that the grader knows"
[ "$*" = grader ] || needs+="
clang-19 libclang-rt-19-dev: the second compiler, and its sanitizers
clang-format-19: to lay the sources out
libglm-dev: to try the snippets on another library's vectors
doxygen: reference of the code
npm ca-certificates: to weave the book
$chromium: to test the book in a browser, and to print it
lld-19 wasi-libc libc++-19-dev-wasm32 libclang-rt-19-dev-wasm32: live figures, C++ for the browser
git: to test a clean checkout"
[ "$*" != thorough ] || needs+="
$firefox: to test the live figures in another browser
clang-tidy-19: to look the sources over
poppler-utils: to read the book's PDF
g++-aarch64-linux-gnu qemu-user: to see the same bits on 64-bit Arm
g++-mingw-w64-x86-64-posix: to compile the headers for Windows"
[ "$system" != "debian 12" ] || [ "$*" != thorough ] || needs+="
clang-14: the distribution's own clang, which readers of the headers have"
[ "$*" != peers ] || needs+="
libbenchmark-dev: to measure
libboost-dev libgsl-dev libsundials-dev: odeint, GSL and SUNDIALS, to measure beside; Debian's SUNDIALS brings PETSc and MPI"

node_is_new_enough() {
  node -e 'const [major, minor] = process.versions.node.split(".").map(Number)
    process.exit(major > 18 || (major === 18 && minor >= 19) ? 0 : 1)' 2>/dev/null
}

# Node and npm often come from elsewhere, and then Debian's npm would not install beside them.
is_there() {
  case $1 in
    nodejs) node_is_new_enough ;;
    npm) command -v npm >/dev/null ;;
    catch2) [[ ${installed[catch2]-} == 3.* ]] ;;
    *) [ -n "${installed[$1]-}" ] ;;
  esac
}

# Fills `missing` with packages and `reasons` with one line for each group of them.
find_missing() {
  local status package version packages reason absent
  local -A installed=()
  while read -r status package version; do
    [ "$status" != installed ] || installed[$package]=$version
  done < <(dpkg-query -W -f '${db:Status-Status} ${Package} ${Version}\n')
  missing=() reasons=""
  while IFS=: read -r packages reason; do
    absent=()
    for package in $packages; do
      is_there "$package" || absent+=("$package")
    done
    [ ${#absent[@]} -eq 0 ] || reasons+="  ${absent[*]}:$reason"$'\n'
    missing+=("${absent[@]}")
  done <<<"$needs"
}

as_root() {
  if [ "$EUID" -eq 0 ]; then "$@"; else sudo "$@"; fi
}

apt() {
  as_root env DEBIAN_FRONTEND=noninteractive NEEDRESTART_MODE=a \
    apt-get -qq -o Dpkg::Use-Pty=0 -o DPkg::Lock::Timeout=300 "$@" >"$log" 2>&1 ||
    { tail -n 20 "$log" >&2; fail "apt-get $1 failed"; }
}

# Debian 12 itself has Catch2 2. The pin lets this one package, and no other, come from the backports.
add_backports() {
  local targets mirror
  # shellcheck disable=SC2016
  targets=$(apt-get indextargets --format '$(CODENAME) $(SITE)' 'Created-By: Packages')
  if ! grep -q '^bookworm-backports ' <<<"$targets"; then
    mirror=$(sed -n 's/^bookworm //p' <<<"$targets" | head -n 1)
    [ -n "$mirror" ] || fail "Catch2 3 comes from bookworm-backports, but no apt source names a mirror of bookworm"
    echo "  new apt source for catch2 alone: bookworm-backports at $mirror"
    as_root tee /etc/apt/sources.list.d/bookworm-backports-catch2.sources >/dev/null <<END
Types: deb
URIs: $mirror
Suites: bookworm-backports
Components: main
Signed-By: /usr/share/keyrings/debian-archive-keyring.gpg
END
  fi
  as_root tee /etc/apt/preferences.d/bookworm-backports-catch2 >/dev/null <<END
Package: catch2
Pin: release n=bookworm-backports
Pin-Priority: 500
END
  apt update
}

install_packages() {
  [ "$EUID" -eq 0 ] || command -v sudo >/dev/null || fail "run it as root, or install sudo; packages are missing:
$reasons"
  echo "Installing with apt-get, which takes some minutes:"
  echo -n "$reasons"
  log=$(mktemp)
  trap 'rm -f "$log"' EXIT
  apt update
  if [ "$system" = "debian 12" ] && [[ " ${missing[*]} " == *" catch2 "* ]]; then add_backports; fi
  apt install -y --no-install-recommends "${missing[@]}"
  find_missing
  [ ${#missing[@]} -eq 0 ] || fail "installed, and yet not to be found, or hidden by an older version: ${missing[*]}"
}

# Run as root in somebody else's folder, npm's files become that person's.
as_owner() {
  local user group home
  read -r user group < <(stat -c '%u %g' .)
  if [ "$EUID" -ne 0 ] || [ "$user" -eq 0 ]; then
    "$@"
  else
    home=$(getent passwd "$user" | cut -d: -f6) || home=""
    setpriv --reuid "$user" --regid "$group" --clear-groups env HOME="${home:-/tmp}" "$@"
  fi
}

install_npm_packages() {
  local stamp
  stamp="$(sha256sum <package-lock.json) node $(node -p 'process.versions.node.split(".")[0]')"
  [ "$stamp" != "$(cat node_modules/.stamp 2>/dev/null)" ] || return 0
  echo "Installing with npm what package-lock.json names: formulas, highlighting, search, fonts, tests of the book"
  as_owner npm ci --no-update-notifier --loglevel=error || fail "npm ci failed"
  as_owner tee node_modules/.stamp >/dev/null <<<"$stamp"
}

case $system in
  "debian 12" | "debian 13" | "ubuntu 24.04") ;;
  *) fail "knows Debian 12 and 13 and Ubuntu 24.04, not this system. Install what these Debian packages hold:
  ${needs//$'\n'/$'\n'  }
Then run: $([ "$*" = grader ] || echo "npm ci && ")cmake --workflow --preset ${1:-book}" ;;
esac

find_missing
[ ${#missing[@]} -eq 0 ] || install_packages
[ "$*" = grader ] || install_npm_packages
echo "Everything that $purpose is there."
