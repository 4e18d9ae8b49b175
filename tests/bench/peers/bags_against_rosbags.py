#!/usr/bin/env python3
"""Compares the readers of ROS bags with bags that rosbags and mcap (PyPI) wrote, point for point.

    bags_against_rosbags.py BUILD_DIR [--large GB]

BUILD_DIR holds bin/scan_dump. Every kind of bag (ROS 1: none, bz2, lz4; ROS 2 in SQLite: plain, zstd by message and by
file; MCAP: none, lz4, zstd, with and without summary) is written with clouds in the dialects of the drivers, messages of
a Livox and of an inertial unit. --large also writes a bag of that size, and gives the time to open it and the memory,
with the time to read its first bytes for comparison. Without rosbags and mcap in the Python that runs it, it says so and
ends with success.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile
import time

try:
    import mcap.writer
    import numpy as np
    from rosbags.rosbag1 import Writer as Writer1
    from rosbags.rosbag2 import CompressionFormat, CompressionMode, StoragePlugin
    from rosbags.rosbag2 import Writer as Writer2
    from rosbags.typesys import Stores, get_types_from_msg, get_typestore
except ImportError as error:
    print(f"SKIPPED: {error}; pip install rosbags mcap numpy")
    sys.exit(0)

START = 1_700_000_000_000_000_000
PERIOD = 100_000_000
FRAMES, RINGS, COLUMNS = 7, 32, 400
LIVOX_POINT = "uint32 offset_time\nfloat32 x\nfloat32 y\nfloat32 z\nuint8 reflectivity\nuint8 tag\nuint8 line\n"
LIVOX = "std_msgs/Header header\nuint64 timebase\nuint32 point_num\nuint8 lidar_id\nuint8[3] rsvd\nCustomPoint[] points\n"
KIND_OF = {1: "i1", 2: "u1", 3: "i2", 4: "u2", 5: "i4", 6: "u4", 7: "f4", 8: "f8"}

# name: (time field, its type in PointField, units per second, origin: "stamp", "end" or "epoch", ring field, ring from the top)
DIALECTS = {
    "ouster": ("t", 6, 1e9, "stamp", ("ring", 4), True),
    "velodyne": ("time", 7, 1.0, "stamp", ("ring", 4), False),
    "velodyne_end": ("time", 7, 1.0, "end", ("ring", 4), False),
    "hesai": ("timestamp", 8, 1.0, "epoch", ("ring", 4), True),
    "robosense": ("timestamp", 8, 1.0, "epoch", ("ring", 4), False),
    "livox_pcl_ns": ("timestamp", 8, 1e9, "epoch", ("line", 2), False),
    "nebula": ("time_stamp", 6, 1e9, "stamp", ("channel", 4), False),
    "offset_time": ("offset_time", 6, 1e9, "stamp", ("ring", 2), False),
}


def sweep(k):
    """Points of frame k: x, y, z, intensity, ring (0 lowest), seconds after the start. Some are not numbers or zeros."""
    rng = np.random.default_rng(k)
    ring = np.tile(np.arange(RINGS), COLUMNS)
    column = np.repeat(np.arange(COLUMNS), RINGS)
    elevation = np.radians(-25 + 40 * ring / (RINGS - 1))
    azimuth = -2 * np.pi * column / COLUMNS
    distance = rng.uniform(2, 60, ring.size)
    xyz = (distance[:, None] * np.stack([np.cos(elevation) * np.cos(azimuth), np.cos(elevation) * np.sin(azimuth), np.sin(elevation)], 1)).astype(np.float32)
    xyz[rng.random(ring.size) < 0.05] = np.nan
    xyz[rng.random(ring.size) < 0.05] = 0
    return xyz, rng.integers(0, 256, ring.size).astype(np.float32), ring, 0.0995 * column / COLUMNS


def cloud_data(dialect, k, big_endian):
    name, kind, per_second, origin, (ring_name, ring_kind), from_top = DIALECTS[dialect]
    xyz, intensity, ring, seconds = sweep(k)
    stamp = START + k * PERIOD
    base = {"stamp": 0.0, "end": -0.1, "epoch": stamp * 1e-9}[origin]
    fields = [("x", 7), ("y", 7), ("z", 7), ("intensity", 7), (ring_name, ring_kind), (name, kind)]
    if dialect == "livox_pcl_ns":
        fields.append(("tag", 2))
    order = ">" if big_endian else "<"
    points = np.zeros(len(xyz), np.dtype([(n, order + KIND_OF[t]) for n, t in fields]))
    points["x"], points["y"], points["z"] = xyz.T
    points["intensity"] = intensity
    points[ring_name] = RINGS - 1 - ring if from_top else ring
    points[name] = (base + seconds) * per_second if kind in (7, 8) else np.round(seconds * per_second)
    return stamp, fields, points


def times(store, ns):
    return store.types["builtin_interfaces/msg/Time"](sec=int(ns // 10**9), nanosec=int(ns % 10**9))


def header(store, ns, frame):
    more = {"seq": 1} if "ROS1" in store.kind else {}
    return store.types["std_msgs/msg/Header"](stamp=times(store, ns), frame_id=frame, **more)


def cloud_message(store, dialect, k, big_endian):
    stamp, fields, points = cloud_data(dialect, k, big_endian)
    field = store.types["sensor_msgs/msg/PointField"]
    offsets = [points.dtype.fields[n][1] for n, _ in fields]
    return stamp, store.types["sensor_msgs/msg/PointCloud2"](
        header=header(store, stamp, "lidar"), height=1, width=len(points), fields=[field(n, o, t, 1) for (n, t), o in zip(fields, offsets)],
        is_bigendian=big_endian, point_step=points.dtype.itemsize, row_step=points.nbytes, data=np.frombuffer(points.tobytes(), np.uint8), is_dense=False)


def livox_message(store, name, k):
    xyz, intensity, ring, seconds = sweep(k)
    stamp = START + k * PERIOD
    point = store.types[f"{name}/msg/CustomPoint"]
    points = [point(int(round(s * 1e9)), float(p[0]), float(p[1]), float(p[2]), int(i), 0x10, int(r) % 6)
              for s, p, i, r in zip(seconds, xyz, intensity, ring)]
    return stamp, store.types[f"{name}/msg/CustomMsg"](header=header(store, stamp, "livox"), timebase=stamp, point_num=len(points), lidar_id=1,
                                                       rsvd=np.zeros(3, np.uint8), points=points)


def imu_message(store, k):
    stamp = START + k * PERIOD // 20
    vector, quaternion = store.types["geometry_msgs/msg/Vector3"], store.types["geometry_msgs/msg/Quaternion"]
    zeros = np.zeros(9)
    return stamp, store.types["sensor_msgs/msg/Imu"](header(store, stamp, "imu"), quaternion(0, 0, 0, 1), zeros, vector(*imu_values(k)[:3]), zeros,
                                                     vector(*imu_values(k)[3:]), zeros)


def imu_values(k):
    return 0.01 * k, -0.02 * k, 0.5, 0.1, 0.2, 9.81 + 1e-3 * k


def make_store(kind):
    store = get_typestore(Stores.ROS1_NOETIC if kind == "ROS1" else Stores.ROS2_HUMBLE)
    store.kind = kind
    for name in ("livox_ros_driver", "livox_ros_driver2"):
        store.register({**get_types_from_msg(LIVOX_POINT, f"{name}/msg/CustomPoint"), **get_types_from_msg(LIVOX.replace("CustomPoint", f"{name}/CustomPoint"), f"{name}/msg/CustomMsg")})
    return store


def messages(store, dialect, big_endian, units):
    """(topic, type, recording time, message) in order of recording."""
    out = []
    for k in range(FRAMES):
        if dialect in ("livox_ros_driver", "livox_ros_driver2"):
            stamp, message = livox_message(store, dialect, k)
            out.append(("/scan", f"{dialect}/msg/CustomMsg", stamp + PERIOD, message))
        else:
            stamp, message = cloud_message(store, dialect, k, big_endian)
            out.append(("/scan", "sensor_msgs/msg/PointCloud2", stamp + PERIOD, message))
    for k in range(20 * FRAMES if units else 0):
        stamp, message = imu_message(store, k)
        out.append(("/imu", "sensor_msgs/msg/Imu", stamp, message))
    return sorted(out, key=lambda m: m[2])


def ros1_writer(compression):
    def write(path, store, list_of):
        path = path.with_suffix(".bag")
        writer = Writer1(path)
        if compression:
            writer.set_compression(compression)
        with writer:
            connections = {}
            for topic, kind, ns, message in list_of:
                if topic not in connections:
                    connections[topic] = writer.add_connection(topic, kind, typestore=store)
                writer.write(connections[topic], ns, store.serialize_ros1(message, kind))
        return path
    return write


def ros2_writer(plugin, mode=None):
    def write(path, store, list_of):
        writer = Writer2(path, version=8, storage_plugin=plugin)
        if mode:
            writer.set_compression(mode, CompressionFormat.ZSTD)
        with writer:
            connections = {}
            for topic, kind, ns, message in list_of:
                if topic not in connections:
                    connections[topic] = writer.add_connection(topic, kind, typestore=store)
                writer.write(connections[topic], ns, store.serialize_cdr(message, kind))
        return path
    return write


def mcap_writer(compression, little=True, **more):
    def write(path, store, list_of):
        path = path.with_suffix(".mcap")
        with open(path, "wb") as file:
            writer = mcap.writer.Writer(file, chunk_size=300_000, compression=compression, **more)
            writer.start(profile="ros2", library="bench")
            channels = {}
            for k, (topic, kind, ns, message) in enumerate(list_of):
                if topic not in channels:
                    schema = writer.register_schema(kind, "ros2msg", b"")
                    channels[topic] = writer.register_channel(topic, "cdr", schema)
                writer.add_message(channels[topic], ns, bytes(store.serialize_cdr(message, kind, little_endian=little)), ns, k)
            writer.finish()
        return path
    return write


C = mcap.writer.CompressionType
KINDS = {
    "ros1": ("ROS1", ros1_writer(None)),
    "ros1_bz2": ("ROS1", ros1_writer(Writer1.CompressionFormat.BZ2)),
    "ros1_lz4": ("ROS1", ros1_writer(Writer1.CompressionFormat.LZ4)),
    "db3": ("ROS2", ros2_writer(StoragePlugin.SQLITE3)),
    "db3_zstd_message": ("ROS2", ros2_writer(StoragePlugin.SQLITE3, CompressionMode.MESSAGE)),
    "db3_zstd_file": ("ROS2", ros2_writer(StoragePlugin.SQLITE3, CompressionMode.FILE)),
    "mcap_folder": ("ROS2", ros2_writer(StoragePlugin.MCAP)),
    "mcap_folder_zstd": ("ROS2", ros2_writer(StoragePlugin.MCAP, CompressionMode.FILE)),
    "mcap": ("ROS2", mcap_writer(C.NONE)),
    "mcap_lz4": ("ROS2", mcap_writer(C.LZ4)),
    "mcap_zstd": ("ROS2", mcap_writer(C.ZSTD)),
    "mcap_zstd_big_endian": ("ROS2", mcap_writer(C.ZSTD, little=False)),
    "mcap_no_summary": ("ROS2", mcap_writer(C.LZ4, repeat_channels=False, repeat_schemas=False, use_statistics=False,
                                            index_types=mcap.writer.IndexType.NONE)),
    "mcap_no_chunks": ("ROS2", mcap_writer(C.NONE, use_chunking=False)),
}


def dump(program, path, out, *options):
    done = subprocess.run([program, path, out, *options], capture_output=True, text=True)
    if done.returncode != 0:
        return None, done.stderr.strip()
    return json.loads(done.stdout), ""


def differences(info, out, dialect, units):
    """What differs, in words."""
    bad = []
    rosette = dialect.startswith("livox")
    if info["count"] != FRAMES:
        return [f"{info['count']} frames"]
    if info["rosette"] != rosette:
        bad.append("pattern")
    read = lambda name, kind: np.fromfile(f"{out}.{name}", kind)
    positions, seconds, ring, intensity = read("positions", "f4").reshape(-1, 3), read("times", "f4"), read("rings", "u2"), read("intensities", "f4")
    at, worst = 0, 0.0
    for k, frame in enumerate(info["frames"]):
        xyz, i, r, t = sweep(k)
        keep = np.isfinite(xyz).all(1) & (xyz != 0).any(1)
        part = slice(at, at + frame["points"])
        at += frame["points"]
        if frame["points"] != keep.sum() or not np.array_equal(positions[part], xyz[keep]):
            bad.append(f"positions of frame {k}")
            continue
        if not np.array_equal(intensity[part], i[keep]):
            bad.append(f"intensities of frame {k}")
        if not np.array_equal(ring[part], np.zeros(keep.sum()) if rosette else r[keep]):
            bad.append(f"rings of frame {k}")
        start = (START + k * PERIOD) * 1e-9 + (-0.1 if dialect == "velodyne_end" else 0)
        worst = max(worst, np.abs(frame["start_s"] - start + seconds[part].astype(float) - t[keep]).max())
    if worst > 1e-6:  # a double of seconds since 1970 resolves 0.24 us
        bad.append(f"times by {worst:.2e} s")
    imu = read("imu", "f8").reshape(-1, 7)
    expected = np.array([(START + k * PERIOD // 20, *imu_values(k)) for k in range(20 * FRAMES if units else 0)]).reshape(-1, 7)
    expected[:, 0] *= 1e-9
    if imu.shape != expected.shape or not np.allclose(imu, expected, rtol=0, atol=3e-7) or not np.array_equal(imu[:, 1:], expected[:, 1:]):
        bad.append(f"inertial unit ({len(imu)} of {len(expected)})")
    return bad


def large_bag(program, folder, gigabytes, write, name):
    """Time and memory of a large bag: opened, and one of a hundredth of its frames for comparison."""
    store = make_store("ROS1" if name.startswith("ros1") else "ROS2")
    rng = np.random.default_rng(1)
    count = 131072
    dtype = np.dtype([("x", "<f4"), ("y", "<f4"), ("z", "<f4"), ("intensity", "<f4"), ("t", "<u4"), ("ring", "<u2"), ("pad", "<u2")])
    points = np.zeros(count, dtype)
    for axis in "xyz":
        points[axis] = rng.uniform(-20, 20, count)
    points["t"] = np.linspace(0, 99e6, count)
    points["ring"] = np.arange(count) % 128
    field = store.types["sensor_msgs/msg/PointField"]
    fields = [field(n, dtype.fields[n][1], t, 1) for n, t in (("x", 7), ("y", 7), ("z", 7), ("intensity", 7), ("t", 6), ("ring", 4))]
    data = np.frombuffer(points.tobytes(), np.uint8)

    def stream():
        for k in range(int(gigabytes * 1e9 / points.nbytes)):
            stamp = START + k * PERIOD
            yield ("/scan", "sensor_msgs/msg/PointCloud2", stamp + PERIOD,
                   store.types["sensor_msgs/msg/PointCloud2"](header(store, stamp, "lidar"), 1, count, fields, False, dtype.itemsize, points.nbytes, data, True))
            for j in range(20):
                yield ("/imu", "sensor_msgs/msg/Imu", stamp + PERIOD + j, imu_message(store, 20 * k + j)[1])

    path = write(folder / name, store, stream())
    files = [f for f in path.rglob("*") if f.is_file()] if path.is_dir() else [path]
    size = sum(f.stat().st_size for f in files) / 1e9
    info, error = dump(program, path, "-")
    begin = time.perf_counter()
    whole, _ = dump(program, path, folder / "whole")
    print(f"{name:18} {size:.2f} GB, {info['count']} frames: opened in {info['open_seconds']:.3f} s with {info['open_peak_mib']:.0f} MiB; "
          f"all frames read in {time.perf_counter() - begin:.1f} s with {whole['peak_mib']:.0f} MiB" if info else f"{name}: {error}")
    for f in [*files, *folder.glob("whole.*")]:
        f.unlink()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--large", type=float, default=0)
    arguments = parser.parse_args()
    program = arguments.build / "bin" / "scan_dump"
    failures = done = 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for kind, (system, write) in KINDS.items():
            store = make_store(system)
            wanted = [*DIALECTS, "livox_ros_driver", "livox_ros_driver2"]
            for dialect in wanted:
                for big_endian in (False, True) if dialect == "ouster" else (False,):
                    label = f"{kind} {dialect}{' big-endian data' if big_endian else ''}"
                    path = write(folder / label.replace(" ", "_"), store, messages(store, dialect, big_endian, True))
                    info, error = dump(program, path, folder / "out", "min_range=0")
                    bad = differences(info, folder / "out", dialect, True) if info else [error]
                    done += 1
                    if bad:
                        failures += 1
                        print(f"{label}: DIFFERS: {'; '.join(bad)[:300]}")
            print(f"{kind}: {len(wanted) + 1} recordings compared")
        if arguments.large > 0:
            for name, write in (("ros1", KINDS["ros1"][1]), ("mcap_lz4", KINDS["mcap_lz4"][1]), ("db3", KINDS["db3"][1])):
                large_bag(program, folder, arguments.large, write, name)
    print(f"{done} recordings, {failures} differ")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
