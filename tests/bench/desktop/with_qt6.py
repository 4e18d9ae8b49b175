#!/usr/bin/env python3
"""Whether the window compiles with Qt 6: each of its translation units with the headers of Qt 6 in place of those of Qt 5, nothing
linked. The Qt of a program is that of its VTK, and VTK of Debian 12 is built with Qt 5, so that no window can be linked with Qt 6
there.

  with_qt6.py build/headless [--qt6 /usr/include/x86_64-linux-gnu/qt6]

Needs the headers (Debian: qt6-base-dev). Without them it says so and ends with 0. Ends with 1 where a unit does not compile.
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys

MODULES = ["", "QtCore", "QtGui", "QtWidgets", "QtOpenGL", "QtOpenGLWidgets"]


def units_of(build):
    """Commands of the window's own sources; what moc of Qt 5 made is of no use to Qt 6."""
    commands = json.loads((build / "compile_commands.json").read_text())
    return [c for c in commands
            if "bole_desktop.dir" in c["command"] and "mocs_compilation" not in c["file"] and "cmake_pch" not in c["file"]]


def with_qt6(command, headers):
    command = re.sub(r"-Winvalid-pch -include \S+", "", command)
    command = re.sub(r"-isystem \S*qt5\S*", "", command)
    command = re.sub(r" -o \S+ -c ", " " + " ".join(f"-isystem {headers / m}" for m in MODULES) + " -fsyntax-only ", command)
    return command.replace("-Werror", "").replace("-O3", "")


def compiled(unit, headers):
    done = subprocess.run(with_qt6(unit["command"], headers), shell=True, cwd=unit["directory"], capture_output=True, text=True)
    return pathlib.Path(unit["file"]).name, done.returncode, done.stderr


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--qt6", type=pathlib.Path, default=pathlib.Path("/usr/include/x86_64-linux-gnu/qt6"))
    arguments = parser.parse_args()
    if not (arguments.qt6 / "QtWidgets").is_dir():
        print(f"skipped: there are no headers of Qt 6 in {arguments.qt6} (Debian: qt6-base-dev)")
        return 0
    units = units_of(arguments.build)
    if not units:
        print(f"{arguments.build} has no compile commands of the window: configure with the desktop first", file=sys.stderr)
        return 2
    refused = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for name, status, said in pool.map(lambda unit: compiled(unit, arguments.qt6), units):
            errors = [line for line in said.splitlines() if "error:" in line]
            refused += status != 0
            print(f"{name}: {'compiles' if status == 0 else str(len(errors)) + ' errors'}", *errors[:20], sep="\n  ")
    print(f"{len(units) - refused} of {len(units)} units compile with Qt 6")
    return 1 if refused else 0


if __name__ == "__main__":
    sys.exit(main())
