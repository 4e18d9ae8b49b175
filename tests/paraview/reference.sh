#!/usr/bin/env bash
# reference.sh BOLE CLOUD FOLDER: the stem map of a cloud by the command line program. 77 (skipped) where either is missing.
set -euo pipefail
rm -rf "$3"
[ -x "$1" ] || { echo "skipped: there is no $1"; exit 77; }
[ -f "$2" ] || { echo "skipped: there is no $2"; exit 77; }
exec "$1" run stem_map_from_cloud --set "scan.file=$2" --set report.figures=false --out "$3"
