"""The sample state draws: the picture is neither empty nor of one colour. Look at it when this fails."""

import pathlib
import runpy
import sys

import paraview_test as t
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader


def pixels_of(path):
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3]


def test(state, cloud, folder):
    if not pathlib.Path(cloud).is_file():
        raise t.Skipped(f"there is no {cloud}")
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    picture, table = folder / "stem_map.png", folder / "stems.csv"
    picture.unlink(missing_ok=True)
    sys.argv = [state, cloud, str(picture), str(table)]
    runpy.run_path(state, run_name="__main__")
    pixels = pixels_of(picture)
    drawn = (pixels < 250).any(axis=1).mean()
    colours = len({tuple(p) for p in pixels[::50].tolist()})
    print(f"{picture}: {100 * drawn:.0f} % drawn, {colours} colours")
    t.check(drawn > 0.1, f"only {100 * drawn:.1f} % of the picture are drawn")
    t.check(colours > 15, f"only {colours} colours")
    t.check(table.stat().st_size > 1000, "the table of the state is empty")


t.run(test)
