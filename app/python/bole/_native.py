"""Loads the compiled modules, or says in one sentence why this Python cannot."""

import ctypes
import importlib.machinery
import importlib.util
import os
import pathlib
import sys

from . import _build

HERE = pathlib.Path(os.path.abspath(__file__)).parent  # not resolve(): in a build the modules are links to the sources


def is_program():
    """Whether this import is the first step of `python3 -m bole`: sys.argv[0] is "-m" while the package is looked for."""
    if sys.argv[:1] != ["-m"]:
        return False
    words = pathlib.Path("/proc/self/cmdline").read_bytes().split(b"\0")
    return b"-m" in words and words[words.index(b"-m") + 1] == b"bole"


def find_engine():
    """The engine of campaigns needs nothing of VTK, so it lies beside the program and not in this package."""
    place = str((HERE / _build.ENGINE).resolve())
    if place not in sys.path:
        sys.path.append(place)


def program():
    """The path of the command line program: BOLE_PROGRAM, that of this build or installation, or the first in the PATH."""
    beside = (HERE / _build.PROGRAM).resolve()
    if not os.environ.get("BOLE_PROGRAM") and beside.is_file():
        return str(beside)
    from bole_campaign.program import find_program

    return find_program()


def check_python():
    if f".{_build.ABI}.so" in importlib.machinery.EXTENSION_SUFFIXES:
        return
    version = ".".join(map(str, sys.version_info[:3]))
    raise ImportError(
        f"bole {_build.VERSION} is built for Python {_build.PYTHON} ({_build.ABI}), and this is {sys.implementation.name} {version} ({sys.executable}): "
        f"use {_build.INTERPRETER} or another Python {_build.PYTHON}, or build Bole with -DPython3_EXECUTABLE={sys.executable} and a VTK for it",
        name="bole",
    )


def import_vtk():
    """VTK's Python package, in the version that bole is built with: from the path, else from where the build found it."""
    spec = importlib.util.find_spec("vtkmodules")
    if spec is None:
        folder = pathlib.Path(_build.VTK_FOLDER) / "vtkmodules"
        if not (folder / "__init__.py").is_file():
            raise ImportError(
                f"bole needs the Python package of VTK {_build.VTK} (vtkmodules), and it is neither installed for {sys.executable} nor in {_build.VTK_FOLDER}: "
                "install the Debian package python3-vtk9",
                name="vtkmodules",
            )
        # Only this package: the others of that folder belong to another Python.
        spec = importlib.util.spec_from_file_location("vtkmodules", folder / "__init__.py", submodule_search_locations=[str(folder)])
        module = importlib.util.module_from_spec(spec)
        sys.modules["vtkmodules"] = module
        spec.loader.exec_module(module)
    from vtkmodules.vtkCommonCore import vtkVersion

    found = vtkVersion.GetVTKVersion()
    if found.split(".")[:2] != _build.VTK.split(".")[:2]:
        place = next(iter(spec.submodule_search_locations or ()), spec.origin)
        raise ImportError(
            f"bole is built with VTK {_build.VTK}, and this Python has VTK {found} ({place}): one process cannot hold both; "
            f"use an environment without that VTK (bole then takes the one in {_build.VTK_FOLDER})",
            name="vtkmodules",
        )


def draw_without_display():
    """Without a display, binds VTK's gl* calls to OSMesa, as the program does. Too late once VTK's rendering is loaded."""
    library = HERE / _build.LIBRARIES / "libbole_osmesa.so"
    if not os.environ.get("DISPLAY") and "vtkmodules.vtkRenderingOpenGL2" not in sys.modules and library.exists():
        ctypes.CDLL(str(library), ctypes.RTLD_GLOBAL)


def load():
    """The VTK classes of Bole by name. Throws ImportError."""
    check_python()
    import_vtk()
    try:
        draw_without_display()
        classes = {}
        for name in _build.MODULES:
            module = importlib.import_module(f".{name}", __package__)
            classes.update({key: value for key, value in vars(module).items() if key.startswith("vtkBole")})
    except (ImportError, OSError) as error:
        raise ImportError(
            f"bole {_build.VERSION} cannot load its compiled modules ({error}): a library is missing or of another version; "
            f"install the Debian packages bole and python3-bole again, or build Bole with BOLE_PYTHON=ON",
            name="bole",
        ) from error
    classes["vtkBolePlotReport"]()  # registers the stages of the report, which pipeline documents may name
    return classes


def numpy():
    try:
        import numpy as module
    except ImportError:
        raise ImportError(f"numpy is not installed for this Python, and arrays need it: {sys.executable} -m pip install numpy", name="numpy") from None
    return module
