#!/usr/bin/env python3
"""Writes the frames of any scan as sensor_msgs/PointCloud2 into an MCAP bag, with the time of each point after the stamp.

    scan_to_bag.py BUILD_DIR SCAN OUT.mcap [option=value...]

BUILD_DIR holds bin/scan_dump; the options are those of io.read_scan. With the bag the whole chain can be run on the same
points as from their source:

    bole run forest_plot --set scan.file=OUT.mcap --set scan.sensor=vlp32c --out survey

Without rosbags and mcap in the Python that runs it, it says so and ends with success.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

try:
    import mcap.writer
    import numpy as np
    from rosbags.typesys import Stores, get_typestore
except ImportError as error:
    print(f"SKIPPED: {error}; pip install rosbags mcap numpy")
    sys.exit(0)

POINT = np.dtype([("x", "<f4"), ("y", "<f4"), ("z", "<f4"), ("intensity", "<f4"), ("time", "<f4"), ("ring", "<u2")])
FIELD_TYPES = {"f": 7, "u": 4}


def main(build, scan, out, *options):
    store = get_typestore(Stores.ROS2_HUMBLE)
    kind = store.types
    with tempfile.TemporaryDirectory() as folder:
        columns = pathlib.Path(folder) / "scan"
        done = subprocess.run([pathlib.Path(build) / "bin" / "scan_dump", scan, columns, *options], capture_output=True, text=True, check=True)
        frames = json.loads(done.stdout)["frames"]
        read = lambda name, dtype: np.fromfile(f"{columns}.{name}", dtype)
        positions, times, rings, intensities = read("positions", "f4").reshape(-1, 3), read("times", "f4"), read("rings", "u2"), read("intensities", "f4")
    fields = [kind["sensor_msgs/msg/PointField"](n, POINT.fields[n][1], FIELD_TYPES[POINT.fields[n][0].kind], 1) for n in POINT.names]
    with open(out, "wb") as file:
        writer = mcap.writer.Writer(file, compression=mcap.writer.CompressionType.LZ4)
        writer.start(profile="ros2", library="scan_to_bag")
        schema = writer.register_schema("sensor_msgs/msg/PointCloud2", "ros2msg", b"")
        channel = writer.register_channel("/points", "cdr", schema)
        at = 0
        for frame in frames:
            part = slice(at, at + frame["points"])
            at += frame["points"]
            points = np.zeros(frame["points"], POINT)
            points["x"], points["y"], points["z"] = positions[part].T
            points["intensity"], points["time"], points["ring"] = intensities[part], times[part], rings[part]
            ns = round(frame["start_s"] * 1e9)
            header = kind["std_msgs/msg/Header"](kind["builtin_interfaces/msg/Time"](ns // 10**9, ns % 10**9), "lidar")
            cloud = kind["sensor_msgs/msg/PointCloud2"](header, 1, len(points), fields, False, POINT.itemsize, points.nbytes,
                                                        np.frombuffer(points.tobytes(), np.uint8), True)
            recorded = round(frame["end_s"] * 1e9)
            writer.add_message(channel, recorded, bytes(store.serialize_cdr(cloud, "sensor_msgs/msg/PointCloud2")), recorded)
        writer.finish()
    print(f"{out}: {len(frames)} frames, {at} points")


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
