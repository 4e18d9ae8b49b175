#!/usr/bin/env bash
# The front door: each verb is one or two CMake presets. ./do help lists them.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

install_packages() { # the file that lists them; none that is there is ever removed for them
  local missing
  missing=$(grep -v '^#' "${1:-packages.apt}" | while read -r p; do dpkg-query -W -f='${Status}' "$p" 2>/dev/null | grep -q 'ok installed' || echo "$p"; done)
  [ -z "$missing" ] && return
  local as_root=""
  [ "$(id -u)" -eq 0 ] || as_root=sudo
  $as_root apt-get update -qq
  # shellcheck disable=SC2086
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-remove --no-install-recommends $missing
}

# The plugin has a build tree of its own, since ParaView brings another VTK. Says why where it is skipped.
test_paraview() {
  if app/paraview/prepare.sh build/paraview-packages; then cmake --workflow --preset paraview; fi
}

usage="usage: ./do build | demo | test | paraview | bench | format | lint | docs"
case "${1:-help}" in
  build) install_packages; cmake --workflow --preset build ;;
  demo) install_packages; cmake --preset headless; cmake --build --preset headless --target demo ;;
  test) install_packages; cmake --workflow --preset ci; cmake --workflow --preset fuzz; test_paraview; cmake --build --preset summary ;;
  paraview) install_packages; install_packages app/paraview/packages.apt; cmake --workflow --preset build; test_paraview ;;
  bench) install_packages; cmake --workflow --preset build; cmake --build --preset headless --target bench ;;
  format | lint | docs) install_packages; cmake --preset ci; cmake --build --preset ci --target "$1" ;;
  help) echo "$usage" ;;
  *) echo "$usage" >&2; exit 2 ;;
esac
