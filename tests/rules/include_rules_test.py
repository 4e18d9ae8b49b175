#!/usr/bin/env python3
"""Arrows point down only: checks every #include against the layers of docs/dev/architecture.md."""

import pathlib
import re
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
MODULES = ROOT / "modules"

DOMAIN = {"alignment", "io", "sim", "slam", "survey", "ground", "stems", "inventory", "evaluation", "rows", "steering",
          "rgbd", "plant"}
# What a file of a module may include from other modules, by layer. Domain modules never include one another.
BELOW = {
    "base": set(),
    "camera": {"base"},
    "cloud": {"base", "camera"},
    "sensor": {"base", "camera", "cloud"},
    "geo": {"base", "camera", "cloud"},
    "pipeline": {"base", "camera", "cloud"},
    "documents": {"base", "pipeline", "io"},
    "vtkbridge": {"base", "camera", "cloud", "pipeline"},
    "render": {"base", "camera", "cloud"},
    "report": {"base", "camera", "cloud", "pipeline", "render", "io"},
}
for domain in DOMAIN:
    BELOW[domain] = {"base", "camera", "cloud", "sensor", "geo"}

# Heavy or foreign libraries and the headers that betray them.
HEAVY = re.compile(r'^(ceres/|pcl/|CGAL/|gdal|ogr|cpl_|embree|rtcore|opencv|xlsxwriter|pcap)')
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
    if inner.endswith(("stages.cpp", "_stages.h")):
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


TYPE = re.compile(r"(?:struct|class|enum class) (?:\w+_EXPORT )?(\w+)[^;]*\{")


def types_of(text):
    """Names of the types that a source declares at namespace level, with their namespaces; those without a name left out."""
    spaces, found = [], []
    for line in text.splitlines():
        if begin := re.match(r"namespace ([\w:]*)\s*\{", line):
            spaces.append(begin.group(1))
        elif line.startswith("}  // namespace") and spaces:
            spaces.pop()
        elif (declared := TYPE.match(line)) and spaces and "" not in spaces:
            found.append("::".join(spaces) + "::" + declared.group(1))
    return found


class IncludeRules(unittest.TestCase):
    def test_modules(self):
        files = sources(MODULES)
        self.assertGreater(len(files), 10, "no sources found: the test looks in the wrong place")
        found = [f"{p.relative_to(ROOT)} {v}" for p in files for v in violations_of(p, includes(p))]
        self.assertEqual(found, [], "\n".join(found))

    def test_no_type_has_the_name_of_another_modules(self):
        # The linker would take one module's destructor for the other's type, and say nothing.
        owners = {}
        for p in sources(MODULES):
            for name in types_of(p.read_text(encoding="utf-8", errors="replace")):
                owners.setdefault(name, set()).add(p.relative_to(MODULES).parts[0])
        self.assertGreater(len(owners), 100, "no types found: the test looks in the wrong way")
        found = [f"{name} is declared in {', '.join(sorted(modules))}" for name, modules in owners.items() if len(modules) > 1]
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


DESKTOP = ROOT / "app" / "desktop"
# What each floor of the desktop may include from the others. Views do not include panels, nor panels views.
DESKTOP_BELOW = {
    "look": set(),
    "commands": set(),
    "document": {"look"},
    "running": {"look", "document"},
    "views": {"look", "commands", "document", "running"},
    "panels": {"look", "commands", "document", "running"},
    "workbench": {"look", "commands", "document", "running", "views", "panels"},
    "features": {"look", "commands", "document", "running", "views", "panels", "workbench"},
    "shell": {"look", "commands", "document", "running", "views", "panels", "workbench", "features"},
}


def desktop_violations(path, text_includes):
    """The includes of one file of the desktop that break a rule. Its main.cpp stands above all floors."""
    parts = path.relative_to(DESKTOP).parts
    if len(parts) == 1:
        return []
    floor, found = parts[0], []
    for include in text_includes:
        target = include.split("/")
        if include == "shell/main_window.h" and floor != "shell":
            found.append(f"includes {include}: features see workbench/workbench.h, the shell alone the window")
        elif len(target) > 1 and target[0] in DESKTOP_BELOW and target[0] != floor and target[0] not in DESKTOP_BELOW[floor]:
            found.append(f"includes {include}: {floor} may use only {', '.join(sorted(DESKTOP_BELOW[floor])) or 'Qt'}")
        elif floor == "features" and target[0] == "features" and len(target) > 2 and target[1] != parts[1]:
            found.append(f"includes {include}: a feature does not know another; let them meet in the workbench")
        elif floor == "look" and (MODULES / target[0]).is_dir():
            found.append(f"includes {include}: look uses Qt only")
    return found


def include_loop(graph):
    """A list of files that include one another in a ring; empty: there is none."""
    done, path = set(), []

    def visit(node):
        if node in path:
            return path[path.index(node):] + [node]
        if node in done:
            return []
        path.append(node)
        for below in graph.get(node, []):
            if loop := visit(below):
                return loop
        path.pop()
        done.add(node)
        return []

    return next((loop for node in graph if (loop := visit(node))), [])


class DesktopRules(unittest.TestCase):
    files = sources(DESKTOP)

    def test_floors(self):
        self.assertGreater(len(self.files), 50, "no sources found: the test looks in the wrong place")
        found = [f"{p.relative_to(ROOT)} {v}" for p in self.files for v in desktop_violations(p, includes(p))]
        self.assertEqual(found, [], "\n".join(found))
        self.assertEqual({p.relative_to(DESKTOP).parts[0] for p in self.files} - {"main.cpp"}, set(DESKTOP_BELOW))

    def test_no_file_includes_itself_through_others(self):
        graph = {str(p.relative_to(DESKTOP)): [i for i in includes(p) if (DESKTOP / i).is_file()] for p in self.files}
        self.assertEqual(include_loop(graph), [])

    def test_the_rules_can_fail(self):
        self.assertTrue(desktop_violations(DESKTOP / "panels" / "x.cpp", ["views/scene_view.h"]))
        self.assertTrue(desktop_violations(DESKTOP / "views" / "x.h", ["panels/log_panel.h"]))
        self.assertTrue(desktop_violations(DESKTOP / "document" / "x.cpp", ["running/runner.h"]))
        self.assertTrue(desktop_violations(DESKTOP / "look" / "x.cpp", ["pipeline/stage.h"]))
        self.assertTrue(desktop_violations(DESKTOP / "features" / "rows" / "x.cpp", ["shell/main_window.h"]))
        self.assertTrue(desktop_violations(DESKTOP / "features" / "rows" / "x.cpp", ["features/walk/frame_bar.h"]))
        self.assertFalse(desktop_violations(DESKTOP / "features" / "rows" / "x.cpp", ["features/rows/row_editor.h", "views/scene_view.h"]))
        self.assertFalse(desktop_violations(DESKTOP / "main.cpp", ["shell/main_window.h"]))
        self.assertEqual(include_loop({"a": ["b"], "b": ["c"], "c": ["b"]}), ["b", "c", "b"])
        self.assertEqual(include_loop({"a": ["b", "c"], "b": ["c"], "c": []}), [])

    def test_every_folder_is_explained(self):
        page = (DESKTOP / "README.md").read_text(encoding="utf-8")
        folders = {p.parent.relative_to(DESKTOP).as_posix() for p in self.files} - {"."}
        missing = [f for f in sorted(folders) if f"`{f}/`" not in page]
        self.assertEqual(missing, [], "tell in app/desktop/README.md what these folders are for")

    def test_every_feature_is_installed(self):
        listed = set(re.findall(r"feature\((\w+)\)", (DESKTOP / "features" / "features.cpp").read_text(encoding="utf-8")))
        self.assertEqual({p.name for p in (DESKTOP / "features").iterdir() if p.is_dir()}, listed)

    def test_commands_are_found_by_the_registry(self):
        asked = re.compile(r"findChild<QAction\b|findChild<QAction\s*\*")
        found = [str(p.relative_to(ROOT)) for folder in (DESKTOP, ROOT / "tests" / "desktop") for p in sources(folder) if asked.search(p.read_text(encoding="utf-8"))]
        self.assertEqual(found, [], "ask commands().action(id), which refuses an id that does not exist")

    # Names of stages belong to their modules: here stages are known by ports, options and facts.
    STAGE_NAME = re.compile(r'"(?:io|sim|slam|survey|ground|stems|evaluation|rows|steering|geo|report)\.[a-z_]+"')

    def test_no_stage_is_known_by_its_name(self):
        found = [f"{p.relative_to(ROOT)}: {m.group(0)}" for p in self.files for line in p.read_text(encoding="utf-8").splitlines() for m in self.STAGE_NAME.finditer(line.split("//")[0]) if "document.set(" not in line]
        self.assertEqual(found, [], "use document/stage_roles.h")

    def test_folders_stay_small(self):
        counts = {}
        for p in self.files:
            counts[p.parent] = counts.get(p.parent, 0) + 1
        self.assertEqual([f"{f.relative_to(ROOT)}: {n} files" for f, n in counts.items() if n > 40], [])


class Repository(unittest.TestCase):
    def test_folders_of_the_top_level(self):
        expected = {"app", "modules", "pipelines", "tests", "resources", "docs"}
        self.assertTrue(expected <= {p.name for p in ROOT.iterdir() if p.is_dir()})

    # What a person who opens the repository sees first; output of a run does not belong here.
    TOP_LEVEL = {"app", "docs", "modules", "pipelines", "resources", "tests", ".ci", ".clang-format", ".clang-tidy", ".gitignore", "CHANGELOG.md", "CITATION.cff", "CMakeLists.txt", "CMakePresets.json", "LICENSE", "README.md", "do", "mkdocs.yml", "packages.apt"}

    def test_nothing_else_lies_at_the_top_level(self):
        listing = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, text=True)
        if listing.returncode != 0:
            self.skipTest("this is no checkout")
        self.assertEqual({p.split("/")[0] for p in listing.stdout.split("\0") if p} - self.TOP_LEVEL, set())

    # printf and its like ask the language of the system for the decimal point; files have one point in every language.
    SPEAKS_A_LANGUAGE = re.compile(r"\b(strto[dfl]d?|sto[df]|stold|atof)\s*\(|\b\w*(printf|scanf)\s*\([^;]*%[-+ #0-9.*]*l?[aefgAEFG]\b")

    def test_numbers_speak_no_language(self):
        found = [f"{p.relative_to(ROOT)}: {m.group(0)[:80]}" for folder in (MODULES, ROOT / "app" / "cli") for p in sources(folder) for m in self.SPEAKS_A_LANGUAGE.finditer(p.read_text(errors="replace"))]
        self.assertEqual(found, [], "use number_from_text, std::from_chars or fmt")
        for text in ("strtod(t, nullptr)", "std::stod(t)", 'sscanf(t, "%d:%lf", &a, &b)', 'snprintf(t, n, "%.*f", 2, x)'):
            self.assertTrue(self.SPEAKS_A_LANGUAGE.search(text), text)
        self.assertFalse(self.SPEAKS_A_LANGUAGE.search('sscanf(t, "%d-%d", &a, &b)'))

    def test_source_files_stay_readable(self):
        found = [f"{p.relative_to(ROOT)}: {n} lines" for folder in ("app", "modules") for p in sources(ROOT / folder) if (n := len(p.read_text(errors="replace").splitlines())) > 600]
        self.assertEqual(found, [], "split these files")


if __name__ == "__main__":
    sys.exit(unittest.main())
