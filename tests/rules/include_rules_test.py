#!/usr/bin/env python3
"""Arrows point down only: checks every #include against the layers of docs/dev/architecture.md."""

import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
MODULES = ROOT / "modules"

DOMAIN = {"io", "sim", "slam", "survey", "ground", "stems", "evaluation", "rows", "geo", "steering"}
# What a file of a module may include from other modules, by layer. Domain modules never include one another.
BELOW = {
    "base": set(),
    "cloud": {"base"},
    "sensor": {"base", "cloud"},
    "pipeline": {"base", "cloud"},
    "vtkbridge": {"base", "cloud", "pipeline"},
    "render": {"base", "cloud"},
    "report": {"base", "cloud", "pipeline", "render", "io"},
}
for domain in DOMAIN:
    BELOW[domain] = {"base", "cloud", "sensor"}

# Heavy or foreign libraries and the headers that betray them.
HEAVY = re.compile(r'^(ceres/|pcl/|CGAL/|gdal|ogr|cpl_|embree|rtcore|xlsxwriter|pcap)')
VTK = re.compile(r'^vtk')
QT = re.compile(r'^Q[A-Z]\w+(/|$)')
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.M)
SOURCES = {".h", ".hpp", ".cpp", ".cxx", ".cc"}


def sources(folder):
    return [p for p in sorted(folder.rglob("*")) if p.suffix in SOURCES]


def includes(path):
    return INCLUDE.findall(path.read_text(encoding="utf-8", errors="replace"))


def violations_of(path, text_includes):
    """The includes of one file under modules/ that break a rule, with the reason."""
    parts = path.relative_to(MODULES).parts
    module, inner = parts[0], parts[1]
    wraps_vtk = inner == "vtk" or module in {"vtkbridge", "render", "report"}
    allowed = {module} | BELOW.get(module, set())
    if inner == "stages.cpp":
        allowed |= {"pipeline"}
    if inner == "vtk":
        allowed |= {"pipeline", "vtkbridge"}
    found = []
    for include in text_includes:
        target = include.split("/")[0]
        if "/" in include and (MODULES / target).is_dir() and target not in allowed:
            found.append(f"includes {include}: {module} may use only {', '.join(sorted(allowed))}")
        if VTK.match(include) and not wraps_vtk:
            found.append(f"includes {include}: VTK is seen in */vtk, vtkbridge, render and report only")
        if QT.match(include):
            found.append(f"includes {include}: Qt is seen in app/desktop only")
        if HEAVY.match(include) and path.suffix in {".h", ".hpp"}:
            found.append(f"includes {include}: this library belongs in .cpp files")
    return found


class IncludeRules(unittest.TestCase):
    def test_modules(self):
        files = sources(MODULES)
        self.assertGreater(len(files), 10, "no sources found: the test looks in the wrong place")
        found = [f"{p.relative_to(ROOT)} {v}" for p in files for v in violations_of(p, includes(p))]
        self.assertEqual(found, [], "\n".join(found))

    def test_every_module_has_a_layer(self):
        names = {p.name for p in MODULES.iterdir() if p.is_dir()}
        self.assertEqual(names - set(BELOW), set(), "name the layer of these modules here and in docs/dev/architecture.md")

    def test_qt_only_in_the_desktop(self):
        found = [f"{p.relative_to(ROOT)} includes {i}" for p in sources(ROOT / "app") if "desktop" not in p.parts for i in includes(p) if QT.match(i)]
        self.assertEqual(found, [])

    def test_the_rules_can_fail(self):
        core = MODULES / "stems" / "core" / "x.cpp"
        self.assertTrue(violations_of(core, ["vtkPolyData.h"]))
        self.assertTrue(violations_of(core, ["ground/core/dem.h"]) or not (MODULES / "ground").is_dir())
        self.assertTrue(violations_of(core, ["QString"]))
        self.assertTrue(violations_of(MODULES / "stems" / "core" / "x.h", ["ceres/ceres.h"]))
        self.assertTrue(violations_of(core, ["pipeline/stage.h"]))
        self.assertFalse(violations_of(MODULES / "stems" / "stages.cpp", ["pipeline/stage.h", "base/option.h", "Eigen/Core"]))


class Repository(unittest.TestCase):
    def test_folders_of_the_top_level(self):
        expected = {"app", "modules", "pipelines", "tests", "resources", "docs"}
        self.assertTrue(expected <= {p.name for p in ROOT.iterdir() if p.is_dir()})

    def test_source_files_stay_readable(self):
        found = [f"{p.relative_to(ROOT)}: {n} lines" for folder in ("app", "modules") for p in sources(ROOT / folder) if (n := len(p.read_text(errors="replace").splitlines())) > 600]
        self.assertEqual(found, [], "split these files")


if __name__ == "__main__":
    sys.exit(unittest.main())
