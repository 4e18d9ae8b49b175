#!/usr/bin/env bash
# What clean_root.sh runs in the root, as a person without rights. Every step must succeed.
#   in_clean_root.sh [qgis]
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
step() { echo "== $*"; }

step "bole --version"
bole --version

step "libraries are found beside one another, at the level of this processor"
LD_DEBUG=files bole version 2>&1 | sed -n 's/.*calling init: //p' | grep -E 'lib(bole_|vtkBole)' | xargs realpath | sort > libraries.txt
grep -q '^/usr/lib/[^/]*/bole/libbole_base.so' libraries.txt
if grep -v '^/usr/lib/' libraries.txt; then
  echo "libraries from elsewhere"
  exit 1
fi
levels=/usr/lib/x86_64-linux-gnu/bole/glibc-hwcaps
if [ -d $levels/x86-64-v3 ] && /lib64/ld-linux-x86-64.so.2 --help | grep -q 'x86-64-v3 (supported, searched)'; then
  [ "$(grep -c "^$levels/x86-64-v3/" libraries.txt)" -eq "$(ls $levels/x86-64-v3 | wc -l)" ]
fi
echo "$(wc -l < libraries.txt) libraries, $(grep -c glibc-hwcaps libraries.txt) of them for the level of this processor"

step "bole simulate, bole run"
bole simulate --plot demo --seed 1 --max-time 40 --out scan > simulate.log
bole run /usr/share/bole/pipelines/forest_plot.json --set scan.file=scan/walk.pcap --out survey > run.log 2>&1 || { tail -20 run.log; exit 1; }
head -3 survey/stems.csv
[ "$(wc -l < survey/stems.csv)" -gt 3 ]
for result in report.html summary.json plot.gpkg dem.tif survey.xlsx; do [ -s survey/$result ]; done
python3 -c 'import json; s = json.load(open("survey/summary.json")); print("verdict:", s["verdict"])'

step "a finished cloud"
bole survey survey/cloud.laz --out cloud > cloud.log 2>&1 || { tail -20 cloud.log; exit 1; }
[ -s cloud/report.html ]

step "bole campaign"
echo '{"pipeline": "stem_map_from_cloud", "inputs": [{"id": "a", "set": {"scan.file": "survey/cloud.las"}}, {"id": "b", "set": {"scan.file": "absent.las"}}]}' > campaign.json
code=0
bole campaign run campaign.json --out campaign > campaign.log 2>&1 || code=$?
[ $code -eq 2 ] || { cat campaign.log; exit 1; }
[ "$(wc -l < campaign/stems.csv)" -gt 3 ] && [ -s campaign/campaign.gpkg ] && [ -s campaign/campaign.html ]

step "python3 -c 'import bole'"
python3 - <<'PYTHON'
import bole

survey = bole.run("stem_map_from_cloud", scan="survey/cloud.laz", out="python")
stems = survey.vtk("edit.stems").GetNumberOfRows()  # numpy is not installed here
assert stems > 0 and survey.report.is_file()
print("bole", bole.__version__, "-", stems, "stems,", bole.__file__)
PYTHON
python3 -m bole --version

step "bole-desktop opens the cloud in a window"
xvfb-run -a -s "-screen 0 1400x900x24" timeout 120 bole-desktop --time-startup
code=0
xvfb-run -a -s "-screen 0 1400x900x24" timeout 20 bole-desktop survey/cloud.laz > desktop.log 2>&1 || code=$?
[ $code -eq 124 ] || { cat desktop.log; echo "bole-desktop ended with $code and did not stay open"; exit 1; }

step "man pages, completion and desktop files"
[ -s /usr/share/man/man1/bole.1.gz ] && [ -s /usr/share/man/man1/bole-desktop.1.gz ]
bash -c '. /usr/share/bash-completion/completions/bole; complete -p bole'
grep -q '^Exec=bole-desktop' /usr/share/applications/bole-desktop.desktop
[ -s /usr/share/icons/hicolor/scalable/apps/bole.svg ]
[ "$(file -b --mime-type /usr/share/icons/hicolor/48x48/apps/bole.png)" = image/png ]

if [ "${1:-}" = qgis ]; then
  step "QGIS Processing"
  export QT_QPA_PLATFORM=offscreen
  process=$(command -v qgis_process.bin || command -v qgis_process) # the wrapper of Debian 12 hands on an option that the program does not know
  $process plugins enable bole_provider > qgis_enable.log 2>&1 || grep -q 'already enabled' qgis_enable.log || { cat qgis_enable.log; exit 1; }
  $process list 2> /dev/null | grep -A9 '^Bole'
  $process help bole:stem_map_from_cloud > qgis_help.log 2>&1
  grep -q 'ground' qgis_help.log
  $process run bole:stem_map_from_cloud -- INPUT="$PWD/survey/cloud.laz" OUTPUT_FOLDER="$PWD/qgis" > qgis_run.log 2>&1 || { tail -40 qgis_run.log; exit 1; }
  tail -12 qgis_run.log
  [ -s qgis/plot.gpkg ]
fi
