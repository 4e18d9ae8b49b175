"""Readers: ParaView finds them by the ending of a file, and frames are time steps that stages take as a whole."""

import math
import pathlib
import struct

import bole_paraview
import paraview_test as t
from paraview import servermanager, simple

FRAMES = [40, 60, 50]  # points


def write_frames(folder):
    """A KITTI recording: a pole in the middle of a ring of points, one frame each 0.1 s."""
    velodyne = folder / "velodyne_points" / "data"
    velodyne.mkdir(parents=True, exist_ok=True)
    for number, points in enumerate(FRAMES):
        values = []
        for i in range(points):
            angle = 2 * math.pi * i / points
            values += [5 * math.cos(angle), 5 * math.sin(angle), 0.1 * (i % 8), 0.5]
        (velodyne / f"{number:010d}.bin").write_bytes(struct.pack(f"{len(values)}f", *values))
    stamps = [f"2011-09-26 13:02:25.{number}00000000" for number in range(len(FRAMES))]
    (velodyne.parent / "timestamps.txt").write_text("\n".join(stamps) + "\n", encoding="ascii")
    return velodyne


def check_time(folder):
    scan = bole_paraview.stage("io.read_scan")
    scan.UpdatePipelineInformation()  # as the window does, before a file is named: no error
    bole_paraview.set_option(scan, "file", str(write_frames(folder)))
    scan.UpdateVTKObjects()
    scan.UpdatePipelineInformation()
    times = list(scan.TimestepValues)
    t.equal(len(times), len(FRAMES), "time steps")
    for time, points in zip(times, FRAMES):
        scan.UpdatePipeline(time)
        t.equal(scan.GetDataInformation().GetNumberOfPoints(), points, f"points at {time} s")
    # The stage behind gets the recording, through ParaView's own filters between.
    slam = bole_paraview.stage("slam.run", {}, {"frames": (scan, "frames")})
    slam.UpdatePipeline()
    text = bole_paraview.error(slam)  # three empty rings are no scan that SLAM can use
    t.check(f"of {len(FRAMES)} frames" in text, f"slam.run: '{text}'")


def check_files(folder):
    table = folder / "trees.csv"
    table.write_text("tree_id,x_m,y_m,dbh_cm\n1,0.5,1.5,30\n2,4.5,2.5,25.5\n", encoding="ascii")
    reader = bole_paraview.stage("io.read_table", {"file": str(table)})
    reader.UpdatePipeline()
    rows = servermanager.Fetch(reader)
    t.equal(rows.GetNumberOfRows(), 2, "rows")
    t.equal(rows.GetValueByName(1, "dbh_cm").ToDouble(), 25.5, "value")
    bole_paraview.write(reader, "table", folder / "again.csv")
    t.equal((folder / "again.csv").read_text(encoding="ascii").splitlines()[2], "2,4.5000,2.5000,25.50", "written row")

    path = folder / "walk.tum"
    path.write_text("0 0 0 0 0 0 0 1\n1 2 0 0 0 0 0 1\n", encoding="ascii")
    reader = bole_paraview.stage("io.read_trajectory", {"file": str(path)})
    reader.UpdatePipeline()
    t.equal(reader.GetDataInformation().GetNumberOfPoints(), 2, "poses")

    # A filter of ParaView, and a stage behind it.
    sphere = simple.Sphere(ThetaResolution=64, PhiResolution=64)
    sliced = bole_paraview.stage("rows.voxel", {}, {"points": (sphere, sphere.SMProxy.GetOutputPortName(0))})
    sliced.UpdatePipeline()
    t.check(sliced.GetDataInformation().GetNumberOfPoints() > 0, "a stage takes no data of another filter")


def check_opening(folder):
    cloud = folder / "points.las"
    sphere = simple.Sphere()
    sphere.UpdatePipeline()
    bole_paraview.write(sphere, sphere.SMProxy.GetOutputPortName(0), cloud)
    reader = simple.OpenDataFile(str(cloud))
    t.check(reader is not None and reader.SMProxy.GetXMLName() == "Bole_io_read_cloud", f"{cloud.name} is opened by {reader}")
    reader.UpdatePipeline()
    t.equal(reader.GetDataInformation().GetNumberOfPoints(), sphere.GetDataInformation().GetNumberOfPoints(), "points")


def test(folder):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    check_time(folder)
    check_files(folder)
    check_opening(folder)


t.run(test)
