#!/usr/bin/env python3
"""A simulated plot, read back as other programs give it: a cloud without rays, and the path of its sensor beside it.

    cloud_with_path.py BUILD_DIR WORK [SEED]

Simulates `demo`, maps it with the true poses, takes the rays (sensor, range, pass, ring, facts) out of the cloud and writes it as
LAZ with GPS time less 1e9 s, and the path as TUM in Unix time and as GeoSLAM text at 10 Hz in seconds of the GPS week.
Prints a table of stems and diameters with each. Needs laspy[lazrs] and numpy; without them it says so.
"""
import pathlib
import subprocess
import sys

import measured

try:
    import laspy
    import lazrs  # noqa: F401 (laspy uses it)
    import numpy as np
except ImportError as error:
    print(f"SKIPPED: {error}; pip install 'laspy[lazrs]'")
    sys.exit(0)

GPS_EPOCH_UNIX, LEAP, WEEK = 315964800, 18, 604800
BARK = ["stems.bark_relief=0.001"]  # of the simulated trees


def make(build, work, seed):
    bole, scan = build / "bin/bole", work / "scan"
    if not (work / "map/cloud.laz").exists():
        subprocess.run([bole, "simulate", "--plot", "demo", "--seed", str(seed), "--out", scan], check=True, capture_output=True)
        subprocess.run([bole, "run", measured.REPOSITORY / "pipelines/forest_plot.json", "--out", work / "map", "--set", f"scan.file={scan}/walk.pcap", "--set",
                        f"slam.trajectory={scan}/trajectory.tum", "--set", "plot.width=16", "--set", "plot.length=16"], check=True, capture_output=True)
    return scan


def strip(work):
    """The cloud as another program would have written it."""
    full = laspy.read(work / "map/cloud.laz")
    names = set(full.point_format.dimension_names)
    unix = np.asarray(full["time"] if "time" in names else full.gps_time)
    header = laspy.LasHeader(point_format=6, version="1.4")
    header.scales, header.offsets = full.header.scales, full.header.offsets
    header.global_encoding.gps_time_type = laspy.header.GpsTimeType.STANDARD
    plain = laspy.LasData(header)
    plain.x, plain.y, plain.z = full.x, full.y, full.z
    plain.intensity = full.intensity
    plain.gps_time = unix - GPS_EPOCH_UNIX + LEAP - 1e9
    plain.write(work / "plain.laz")
    poses = np.loadtxt(work / "map/trajectory.tum")
    week = poses[:, 0] - GPS_EPOCH_UNIX + LEAP
    week -= np.floor(week[0] / WEEK) * WEEK
    kept = np.arange(0, len(poses), max(1, round(0.1 / np.median(np.diff(poses[:, 0])))))
    with open(work / "path.txt", "w", encoding="ascii") as out:
        out.write("%time x y z q0 q1 q2 q3 userfields\n")
        for i in kept:
            _, x, y, z, qx, qy, qz, qw = poses[i]
            out.write(f"{week[i]:.6f} {x:.6f} {y:.6f} {z:.6f} {qw:.9f} {qx:.9f} {qy:.9f} {qz:.9f}\n")


def main():
    build, work = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    scan = make(build, work, int(sys.argv[3]) if len(sys.argv) > 3 else 1)
    strip(work)
    reference = [{"x": float(r["x_m"]), "y": float(r["y_m"]), "dbh": float(r["dbh_cm"]), "quality": ""} for r in measured.rows_of(scan / "trees.csv")
                 if r["state"] == "alive" and r["in_plot"] == "1" and float(r["dbh_cm"]) >= 7.5]
    print("| cloud | found | DBH bias / RMSE, cm (n) | 95 % holds | verdict |\n|---|---|---|---|---|")
    for name, cloud, settings in (("map with its own rays", work / "map/cloud.laz", []),
                                  ("without rays (LAZ)", work / "plain.laz", []),
                                  ("and path.tum, Unix time, as exported", work / "plain.laz", [f"trajectory.file={work}/map/trajectory.tum"]),
                                  ("and path.txt (GeoSLAM), GPS week, 10 Hz", work / "plain.laz", [f"trajectory.file={work}/path.txt"])):
        result = measured.survey(build / "bin/bole", cloud, work / "out", [*BARK, "plot.width=16", "plot.length=16", "plot.x=0", "plot.y=0", *settings])
        if result["trouble"]:
            print(f"| {name} | {result['trouble']} |")
            continue
        c = measured.compared(reference, result["stems"])
        print(f"| {name} | {c['found']} of {c['of']} | {measured.bias_rmse(c['differences'])} | {c['holding']} of {c['intervals']} | {result['verdict']}: {measured.codes(result)} |")


if __name__ == "__main__":
    main()
