#!/usr/bin/env python3
"""Whether the window and its tests compile with Qt 6: each translation unit with the headers of Qt 6 in place of those of Qt 5, nothing
linked. The Qt of a program is that of its VTK, and VTK of Debian 12 is built with Qt 5, so that no window can be linked with Qt 6
there.

  with_qt6.py build/headless [--qt6 /usr/include/x86_64-linux-gnu/qt6] [--only fuzz_test]

Needs the headers, and moc for the tests (Debian: qt6-base-dev). Without them it says so and ends with 0. Ends with 1 where a unit
does not compile.
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

MODULES = ["", "QtCore", "QtGui", "QtWidgets", "QtOpenGL", "QtOpenGLWidgets", "QtTest"]


def units_of(build, only):
    """Commands of the window's own sources and of those of its tests; what moc of Qt 5 made is of no use to Qt 6."""
    commands = json.loads((build / "compile_commands.json").read_text())
    wanted = re.compile(r"bole_desktop\.dir|tests/(bench/)?desktop/CMakeFiles/")
    made = re.compile(r"mocs_compilation|cmake_pch|qrc_")
    return [c for c in commands if wanted.search(c["command"]) and not made.search(c["file"]) and only in c["file"]]


def moc_outputs(units, moc, headers, folder):
    """What tests include of moc's for the classes in their sources."""
    for unit in units:
        source = pathlib.Path(unit["file"])
        if f'#include "{source.stem}.moc"' in source.read_text(errors="replace"):
            subprocess.run([moc, *(f"-I{headers / m}" for m in MODULES), source, "-o", folder / f"{source.stem}.moc"], check=True)


def with_qt6(command, headers, mocs):
    command = re.sub(r"-Winvalid-pch -include \S+", "", command)
    command = re.sub(r"-isystem \S*qt5\S*", "", command)
    command = re.sub(r" -o \S+ -c ", " " + " ".join(f"-isystem {headers / m}" for m in MODULES) + " -fsyntax-only ", command)
    command = command.replace(" -I", f" -I{mocs} -I", 1)
    return command.replace("-Werror", "").replace("-O3", "")


def compiled(unit, headers, mocs):
    done = subprocess.run(with_qt6(unit["command"], headers, mocs), shell=True, cwd=unit["directory"], capture_output=True, text=True)
    return pathlib.Path(unit["file"]).name, done.returncode, done.stderr


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--qt6", type=pathlib.Path, default=pathlib.Path("/usr/include/x86_64-linux-gnu/qt6"))
    parser.add_argument("--moc", type=pathlib.Path, default=pathlib.Path("/usr/lib/qt6/libexec/moc"))
    parser.add_argument("--only", default="", help="part of a file name")
    arguments = parser.parse_args()
    if not (arguments.qt6 / "QtWidgets").is_dir() or not arguments.moc.exists():
        print(f"skipped: there are no headers of Qt 6 in {arguments.qt6}, or no {arguments.moc} (Debian: qt6-base-dev)")
        return 0
    units = units_of(arguments.build, arguments.only)
    if not units:
        print(f"{arguments.build} has no compile commands of the window: configure with the desktop first", file=sys.stderr)
        return 2
    refused = 0
    with tempfile.TemporaryDirectory() as mocs, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        moc_outputs(units, arguments.moc, arguments.qt6, pathlib.Path(mocs))
        for name, status, said in pool.map(lambda unit: compiled(unit, arguments.qt6, mocs), units):
            errors = [line for line in said.splitlines() if "error:" in line]
            refused += status != 0
            print(f"{name}: {'compiles' if status == 0 else str(len(errors)) + ' errors'}", *errors[:20], sep="\n  ", flush=True)
    print(f"{len(units) - refused} of {len(units)} units compile with Qt 6")
    return 1 if refused else 0


if __name__ == "__main__":
    sys.exit(main())
