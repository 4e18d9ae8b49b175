#!/usr/bin/env python3
"""Other Pythons: another build of 3.11 works, without VTK and numpy of its own; the others say in one sentence why they do not."""

import glob
import importlib.util
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import plot

BUILD = {}
exec((pathlib.Path(plot.PACKAGE) / "bole" / "_build.py").read_text(), BUILD)
ENVIRONMENT = {k: v for k, v in os.environ.items() if k not in {"VIRTUAL_ENV", "PYTHONHOME"}}


def pythons():
    """(program, version, ABI) of every other CPython of this machine: BOLE_TEST_PYTHONS, those of pyenv, and those in the PATH."""
    places = os.environ.get("BOLE_TEST_PYTHONS", "").split(os.pathsep)
    places += glob.glob(os.path.expanduser("~/.pyenv/versions/3.*/bin/python3")) + glob.glob("/usr/bin/python3.[0-9]*[0-9]") + glob.glob("/usr/local/bin/python3.[0-9]*[0-9]")
    found = []
    for place in filter(None, places):
        asked = plot.python("import sys, sysconfig; print('%d.%d' % sys.version_info[:2], sysconfig.get_config_var('SOABI'))", interpreter=place, env=ENVIRONMENT)
        if asked.returncode == 0 and os.path.realpath(place) != os.path.realpath(sys.executable):
            found.append((place, *asked.stdout.split()))
    return found


def last_line(process):
    return process.stderr.strip().splitlines()[-1] if process.stderr.strip() else ""


class OtherPythons(unittest.TestCase):
    def test_another_build_of_the_same_version(self):
        same = [place for place, _, abi in pythons() if abi == BUILD["ABI"]]
        if not same:
            self.skipTest(f"there is no other Python {BUILD['PYTHON']}")
        code = """
import sys, json, bole
cloud, out = sys.argv[1:]
result = bole.run("stem_map_from_cloud", scan=cloud, out=out)
print(result.verdict, "numpy" in sys.modules, len(bole.stages()))
try:
    print(len(result.stems))
except ImportError as error:
    print(error)
"""
        with tempfile.TemporaryDirectory() as folder:
            import numpy

            path = pathlib.Path(folder) / "plot.xyz"
            numpy.savetxt(path, plot.plot_points(), "%.4f")
            for place in same:
                told = plot.python(code, path, pathlib.Path(folder) / "out", interpreter=place, env=ENVIRONMENT)
                self.assertEqual(told.returncode, 0, told.stderr)
                first, second = told.stdout.splitlines()
                self.assertRegex(first, r"^(sign|look) False \d+$")  # arrays alone need numpy
                self.assertRegex(second, r"^\d+$|^numpy is not installed for this Python, and arrays need it: \S+ -m pip install numpy$")

    def test_other_versions_say_why(self):
        other = {version: place for place, version, abi in pythons() if abi != BUILD["ABI"] and tuple(map(int, version.split("."))) >= (3, 8)}
        if not other:
            self.skipTest("there is no other version of Python")
        for version, place in other.items():
            told = plot.python("import bole", interpreter=place, env=ENVIRONMENT)
            self.assertNotEqual(told.returncode, 0, version)
            line = last_line(told)
            for words in (f"is built for Python {BUILD['PYTHON']}", f"this is cpython {version}.", f"use {BUILD['INTERPRETER']}"):
                self.assertIn(words, line)
            # The program does not need the package.
            self.assertIn("Bole", subprocess.run([place, "-m", "bole", "--version"], capture_output=True, text=True, check=False, env=ENVIRONMENT).stdout, version)


class Missing(unittest.TestCase):
    """Copies of the package that lack something, in this Python."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="bole_python_")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.package = self.folder / "lib" / "python3" / "dist-packages" / "bole"
        self.package.mkdir(parents=True)
        for library in (pathlib.Path(plot.PACKAGE) / "bole" / BUILD["LIBRARIES"]).resolve().glob("*.so"):
            (self.folder / "lib" / library.name).symlink_to(library)  # a module looks for them from its own place
        for path in (pathlib.Path(plot.PACKAGE) / "bole").iterdir():
            if path.name not in ("_build.py", "__pycache__"):
                (self.package / path.name).symlink_to(path.resolve())

    def imported(self, code="import bole", before="", **changed):
        """What a Python says that has this package and nothing else of its site."""
        build = (pathlib.Path(plot.PACKAGE) / "bole" / "_build.py").read_text() + "".join(f"{key} = {value!r}\n" for key, value in changed.items())
        (self.package / "_build.py").write_text(build)
        environment = {**ENVIRONMENT, "PYTHONPATH": os.pathsep.join(filter(None, [before, str(self.package.parent)]))}
        return subprocess.run([sys.executable, "-S", "-c", code], capture_output=True, text=True, check=False, env=environment, timeout=60)

    def test_finds_vtk_where_the_build_found_it(self):
        told = self.imported("import bole, vtkmodules, sys; print(vtkmodules.__file__, bole.vtkBoleSlam().GetStageType(), bole._build.VTK_FOLDER in sys.path)")
        self.assertEqual(told.returncode, 0, told.stderr)
        self.assertRegex(told.stdout, rf"^{re.escape(BUILD['VTK_FOLDER'])}/vtkmodules/__init__.py slam.run False")

    def test_no_vtk(self):
        told = self.imported(VTK_FOLDER=str(self.folder))
        self.assertRegex(last_line(told), rf"bole needs the Python package of VTK {BUILD['VTK']} .* neither installed for \S+ nor in {self.folder}: install the Debian package python3-vtk9$")

    def test_another_vtk(self):
        wheel = self.folder / "wheel" / "vtkmodules"
        wheel.mkdir(parents=True)
        (wheel / "__init__.py").write_text("")
        (wheel / "vtkCommonCore.py").write_text("class vtkVersion:\n    GetVTKVersion = staticmethod(lambda: '9.5.2')\n")
        told = self.imported(before=str(wheel.parent))
        self.assertRegex(last_line(told), rf"bole is built with VTK {BUILD['VTK']}, and this Python has VTK 9.5.2 \({wheel}\): one process cannot hold both")

    def test_a_missing_library(self):
        module = next(self.package.glob("vtkBoleBridge*"))
        module.unlink()
        module.write_bytes(b"no library")
        self.assertRegex(last_line(self.imported()), "bole .* cannot load its compiled modules .*: a library is missing or of another version; install")

    def test_no_numpy(self):
        told = self.imported("import bole; bole.run('stem_map_from_cloud', scan=[[0, 0, 0]])")
        self.assertRegex(last_line(told), r"numpy is not installed for this Python, and arrays need it: \S+ -m pip install numpy$")


class Import(unittest.TestCase):
    def test_is_light(self):
        told = plot.python("import sys, bole; print([name for name in ('numpy', 'pandas', 'IPython', 'vtkmodules.vtkRenderingCore') if name in sys.modules])")
        self.assertEqual(told.stdout.strip(), "[]", told.stderr)

    def test_everything_public_is_told_of(self):
        import bole

        self.assertTrue(importlib.util.find_spec("bole.campaign"))
        for name in bole.__all__:
            self.assertTrue(getattr(bole, name).__doc__ is not None, name)


if __name__ == "__main__":
    unittest.main()
