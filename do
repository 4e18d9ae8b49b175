#!/usr/bin/env bash
# The front door: each verb is one or two CMake presets. ./do help lists them.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

install_packages() {
  local missing
  missing=$(grep -v '^#' packages.apt | while read -r p; do dpkg-query -W -f='${Status}' "$p" 2>/dev/null | grep -q 'ok installed' || echo "$p"; done)
  [ -z "$missing" ] && return
  local as_root=""
  [ "$(id -u)" -eq 0 ] || as_root=sudo
  $as_root apt-get update -qq
  # shellcheck disable=SC2086
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing
}

usage="usage: ./do build | demo | test | bench | format | lint | docs"
case "${1:-help}" in
  build) install_packages; cmake --workflow --preset build ;;
  demo) install_packages; cmake --preset headless; cmake --build --preset headless --target demo ;;
  test) install_packages; cmake --workflow --preset ci; cmake --workflow --preset fuzz; cmake --build --preset summary ;;
  bench) install_packages; cmake --workflow --preset build; cmake --build --preset headless --target bench ;;
  format | lint | docs) install_packages; cmake --preset ci; cmake --build --preset ci --target "$1" ;;
  help) echo "$usage" ;;
  *) echo "$usage" >&2; exit 2 ;;
esac
