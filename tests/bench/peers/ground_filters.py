#!/usr/bin/env python3
"""Ground filters of other programs on the tiles of ground_errors: cloth simulation (CSF) and SMRF.

    ground_filters.py --data DATA [--errors build/headless/bin/ground_errors]

DATA holds isprs_filter and als_ground. Run it with a Python that has laspy, lazrs, numpy, and as far as they are to be
compared cloth-simulation-filter (CSF) and scipy (SMRF, written here after the paper). PDAL's own SMRF runs where `pdal` is on
the path. What is absent is named and left out, and the script ends with success. Every filter has one set of parameters for
all tiles: CSF a cloth of 1 m with rigidness 1, slope smoothing and a threshold of 0.5 m; SMRF cell 1 m, slope 0.15, window
18 m, threshold 0.5 m, scalar 1.25 (the single set of Pingel, Clarke and McBride, ISPRS J. 77, 2013). With --errors the rows of Bole (its defaults) stand beside them.
Errors as Sithole and Vosselman (2004) count them: type I ground taken for object, type II object taken for ground.
"""
import argparse
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

TILES = ["isprs_filter/samp31_ref.las", "isprs_filter/samp51_ref.las", "als_ground/Topography.laz", "als_ground/MixedConifer.laz"]


def print_row(filter_name, tile, ground, reference):
    kept = reference != 9  # water
    truth = reference[kept] == 2
    found = ground[kept]
    type_1, type_2 = (truth & ~found).sum() / truth.sum(), (~truth & found).sum() / (~truth).sum()
    print(f"| {filter_name} | {tile.stem} | {100 * type_1:.2f} | {100 * type_2:.2f} | {100 * (truth != found).mean():.2f} |", flush=True)


def csf_ground(CSF, numpy, xyz):
    csf = CSF.CSF()
    csf.params.bSloopSmooth = True
    csf.params.cloth_resolution = 1.0
    csf.params.rigidness = 1
    csf.params.class_threshold = 0.5
    csf.setPointCloud(xyz)
    ground, other = CSF.VecInt(), CSF.VecInt()
    csf.do_filtering(ground, other, False)  # prints its progress
    out = numpy.zeros(len(xyz), bool)
    out[numpy.array(ground, dtype=int)] = True
    return out


def nearest_filled(ndimage, numpy, grid):
    index = ndimage.distance_transform_edt(numpy.isnan(grid), return_distances=False, return_indices=True)
    return grid[tuple(index)]


def smrf_ground(ndimage, numpy, xyz, cell=1.0, slope=0.15, window=18.0, threshold=0.5, scalar=1.25):
    column, row = (numpy.floor((xyz[:, k] - xyz[:, k].min()) / cell).astype(int) for k in (0, 1))
    lowest = numpy.full((row.max() + 1, column.max() + 1), numpy.inf)
    numpy.minimum.at(lowest, (row, column), xyz[:, 2])
    lowest[numpy.isinf(lowest)] = numpy.nan
    empty = numpy.isnan(lowest)
    surface = nearest_filled(ndimage, numpy, lowest)

    def disk(radius):
        y, x = numpy.mgrid[-radius:radius + 1, -radius:radius + 1]
        return x * x + y * y <= radius * radius

    # Low outliers: the same opening, upside down, with one window and a steep slope.
    low = -ndimage.grey_opening(-surface, footprint=disk(1)) - surface > 5 * cell
    objects, last = numpy.zeros(surface.shape, bool), surface
    for radius in range(1, int(numpy.ceil(window / cell)) + 1):
        opened = ndimage.grey_opening(last, footprint=disk(radius))
        objects |= last - opened > slope * radius * cell
        last = opened
    terrain = nearest_filled(ndimage, numpy, numpy.where(objects | low | empty, numpy.nan, surface))
    terrain = ndimage.gaussian_filter(terrain, 0.5)
    dy, dx = numpy.gradient(terrain, cell)
    at = [(xyz[:, 1] - xyz[:, 1].min()) / cell - 0.5, (xyz[:, 0] - xyz[:, 0].min()) / cell - 0.5]
    height, steep = (ndimage.map_coordinates(g, at, order=1, mode="nearest") for g in (terrain, numpy.hypot(dx, dy)))
    return numpy.abs(xyz[:, 2] - height) <= threshold + scalar * steep


def pdal_ground(laspy, tile, stage, folder):
    out = folder / "out.las"
    subprocess.run(["pdal", "pipeline", "--stdin"], input=json.dumps([str(tile), {"type": "filters.assign", "value": "Classification = 1"}, stage, str(out)]), text=True,
                   check=True)
    return laspy.read(out).classification == 2


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--data", type=pathlib.Path, required=True)
    parser.add_argument("--errors", type=pathlib.Path)
    arguments = parser.parse_args()
    try:
        import laspy
        import numpy
    except ImportError as error:
        print(f"skipped: {error}; install laspy, lazrs and numpy for this Python")
        return 0
    try:
        import CSF
    except ImportError:
        CSF = None
        print("CSF left out: cloth-simulation-filter is not installed for this Python")
    try:
        from scipy import ndimage
    except ImportError:
        ndimage = None
        print("SMRF left out: scipy is not installed for this Python")
    pdal = shutil.which("pdal")
    if not pdal:
        print("PDAL left out: no pdal on the path")
    print("| filter | tile | type I, % | type II, % | total, % |\n|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as scratch:
        for tile in (arguments.data / name for name in TILES):
            if not tile.exists():
                print(f"| absent | {tile} | | | |")
                continue
            cloud = laspy.read(tile)
            reference, xyz = numpy.asarray(cloud.classification), numpy.c_[cloud.x, cloud.y, cloud.z]
            if CSF:
                print_row("CSF", tile, csf_ground(CSF, numpy, xyz - xyz.min(0)), reference)
            if ndimage:
                print_row("SMRF", tile, smrf_ground(ndimage, numpy, xyz), reference)
            if pdal:
                folder = pathlib.Path(scratch)
                smrf = {"type": "filters.smrf", "cell": 1.0, "slope": 0.15, "window": 18.0, "threshold": 0.5, "scalar": 1.25, "ignore": ""}
                print_row("SMRF (PDAL)", tile, pdal_ground(laspy, tile, smrf, folder), reference)
    if arguments.errors:
        print(subprocess.run([arguments.errors, f"data={arguments.data}"], capture_output=True, text=True, check=True).stdout)
    return 0


if __name__ == "__main__":
    sys.exit(main())
