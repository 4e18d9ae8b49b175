#!/usr/bin/env bash
# in_paraview.sh PREFIX PROCESSES SCRIPT ARGUMENT...: runs a script in pvbatch, with ParaView's Python modules of PREFIX.
# 77, which ctest takes for a skipped test, and the reason where that cannot be done.
set -euo pipefail
prefix=$1 processes=$2
shift 2
skip() { echo "skipped: $1"; exit 77; }

[ -f "$prefix/lib/python3/dist-packages/paraview/simple.py" ] || skip "ParaView's Python modules are not in $prefix (app/paraview/prepare.sh)"
command -v pvbatch >/dev/null || skip "pvbatch is not installed (package paraview)"
start=()
if [ -n "${BOLE_TEST_DRAWS:-}" ]; then
  command -v xvfb-run >/dev/null || skip "xvfb-run is not installed (package xvfb)"
  # pvbatch opens the screen twice: without -noreset it may be starting anew at the second time.
  start=(xvfb-run --auto-servernum --server-args "-screen 0 1600x1200x24 -noreset")
fi
if [ "$processes" -gt 1 ]; then
  command -v mpirun >/dev/null || skip "mpirun is not installed (package openmpi-bin)"
  start+=(mpirun --oversubscribe -np "$processes")
  [ "$(id -u)" -ne 0 ] || start+=(--allow-run-as-root)
fi
export PYTHONPATH="$prefix/lib/python3/dist-packages:${PYTHONPATH:-}"
# A client of pvserver is a Python of its own: pvbatch serves itself.
program=(pvbatch)
if [ -n "${BOLE_TEST_CLIENT:-}" ]; then
  command -v mpirun >/dev/null || skip "mpirun is not installed (package openmpi-bin)"
  program=(/usr/bin/python3)
fi
"${start[@]}" "${program[@]}" "$@" 2>&1 | tee "${TMPDIR:-/tmp}/pvbatch_$$.log"
# pvbatch ends with 0 after an error in a script: the scripts say how they ended.
last=$(grep -a -o -E '^bole-test: (passed|failed|skipped.*)' "${TMPDIR:-/tmp}/pvbatch_$$.log" | tail -1 || true)
rm -f "${TMPDIR:-/tmp}/pvbatch_$$.log"
case "$last" in
  *passed) exit 0 ;;
  *skipped*) exit 77 ;;
  *) exit 1 ;;
esac
