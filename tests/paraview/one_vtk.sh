#!/usr/bin/env bash
# one_vtk.sh PLUGIN: fails when the plugin or a library that it brings links a VTK that is not ParaView's.
set -euo pipefail
libraries=$(ldd "$1" "$(dirname "$1")"/*.so)
if grep -q "not found" <<<"$libraries"; then
  grep "not found" <<<"$libraries"
  exit 1
fi
found=$(grep -o -E 'libvtk[^ ]*-pv[0-9.]+\.so' <<<"$libraries" | sort -u | wc -l)
foreign=$(grep -o -E 'libvtk[^ ]*-9\.[0-9]+\.so' <<<"$libraries" | sort -u || true)
echo "$found libraries of ParaView's VTK"
[ "$found" -gt 3 ] || { echo "too few: is this the plugin?"; exit 1; }
[ -z "$foreign" ] || { echo "another VTK: $foreign"; exit 1; }
