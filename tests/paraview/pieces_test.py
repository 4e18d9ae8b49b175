"""With several processes a cloud is dealt out in pieces that hold each point once, and the first process can have it whole."""

import collections
import pathlib

import bole_paraview
import paraview_test as t
from paraview import servermanager
from vtkmodules.util.numpy_support import vtk_to_numpy

# Without these the cloud decides its unit and its axes, and each process reads all of it for that.
DECIDED = {"unit": "metre", "up": "z"}


def points_of(proxy):
    """The points of all processes, on the first one, by their coordinates in millimetres; the origin is added to them."""
    proxy.UpdatePipeline()
    data = servermanager.Fetch(proxy)
    if data is None or data.GetNumberOfPoints() == 0:
        return collections.Counter()
    origin = vtk_to_numpy(data.GetFieldData().GetArray("origin")).reshape(-1)
    points = vtk_to_numpy(data.GetPoints().GetData()).astype(float) + origin
    return collections.Counter(map(tuple, (points * 1000).round().astype(int).tolist()))


def points_here(proxy):
    return proxy.SMProxy.GetClientSideObject().GetOutputDataObject(0).GetNumberOfPoints()


def whole(reader):
    """The cloud as a stage gets it; this one hands it on as it is."""
    return bole_paraview.stage("survey.join_trajectory", {}, {"points": (reader, "points")})


def check_file(path, options=None):
    """The points on all processes, and whether they are spread."""
    options = options or {}
    looked_at = bole_paraview.stage("io.read_cloud", {"file": path, **options})
    by_pieces = bole_paraview.stage("io.read_cloud", {"file": path, **options, **DECIDED})
    region = whole(by_pieces)
    everything, first, second = points_of(region), points_of(looked_at), points_of(by_pieces)
    origins = [servermanager.Fetch(p).GetFieldData().GetArray("origin") for p in (region, by_pieces)]
    name = f"{pathlib.Path(path).name} {options or ''}"
    print(f"{name}: {sum(second.values())} points, {points_here(by_pieces)} on process 0, {sum(everything.values())} in the stage")
    t.check(sum(everything.values()) > 0, f"{name}: no points")
    t.check(first == everything, f"{name}: {sum(first.values())} points dealt out, {sum(everything.values())} in the stage")
    t.check(second == everything, f"{name}: {sum(second.values())} points by pieces, {sum(everything.values())} in the stage")
    t.equal(points_here(region), sum(everything.values()), f"{name}: points of the stage on process 0")
    same = all(abs(origins[0].GetComponent(0, k) - origins[1].GetComponent(0, k)) < 1e-6 for k in range(3))
    t.check(same, f"{name}: the pieces have another origin")
    return 0 < points_here(by_pieces) < sum(second.values())


def test(data, folder):
    data, folder = pathlib.Path(data), pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    copc = str(data / "copc" / "octree.copc.laz")
    reader = bole_paraview.stage("io.read_cloud", {"file": copc})
    reader.UpdatePipeline()
    for name in ("copy.las", "copy.ply"):
        bole_paraview.write(reader, "points", folder / name)

    spread = {
        "COPC": check_file(copc),
        "COPC within bounds": check_file(copc, {"bounds": "500000,5400000,500016,5400032"}),
        "COPC coarse": check_file(copc, {"resolution": 0.6}),
        "LAS": check_file(str(folder / "copy.las")),
        "PLY": check_file(str(folder / "copy.ply")),
    }
    for number in (0, 3, 7):
        spread[f"LAZ {number}"] = check_file(str(data / "laz" / f"format{number}.laz"))
    print("spread over the processes:", spread)
    for name in ("COPC", "COPC within bounds", "LAS"):
        t.check(spread[name] == (t.processes() > 1), f"{name}: spread is {spread[name]} on {t.processes()} processes")
    t.check(not spread["PLY"], "a PLY file is not dealt out, but here it is")


t.run(test)
