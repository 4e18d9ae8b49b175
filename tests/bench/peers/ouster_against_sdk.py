#!/usr/bin/env python3
"""Compares the reader of Ouster captures with ouster-sdk, point for point.

    ouster_against_sdk.py BUILD_DIR [FOLDER]

BUILD_DIR holds bin/scan_dump. FOLDER has pairs of .pcap and .json files (../shared/data/OUSTER_pcaps). The SDK also writes
captures of every profile, with random ranges, missing columns and a beam origin off the axis. Compared: the
number of frames and of points, the position of every point in sensor axes, its time, ring, reflectivity and return, and
the inertial samples. Needs ouster-sdk and numpy in the Python that runs it; without them it says so and ends with
success.
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import warnings

try:
    import numpy as np
    from ouster.sdk import core, pcap
except ImportError as error:
    print(f"SKIPPED: {error}; pip install ouster-sdk")
    sys.exit(0)

warnings.simplefilter("ignore")
GRAVITY = 9.80665
MAX_DISTANCE_M = 1e-5  # of float32 coordinates up to 100 m from those of the SDK
MAX_TIME_S = 1e-6


def metadata_of(capture):
    """The JSON file whose packets fit: the SDK is asked, not our reader."""
    sizes = {len(p) for p in udp_payloads(capture)}
    for file in sorted(capture.parent.glob("*.json"), key=lambda f: not capture.stem.startswith(f.stem)):
        info = core.SensorInfo(file.read_text())
        if core.PacketFormat.from_info(info).lidar_packet_size in sizes:
            return info
    return None


def udp_payloads(capture):
    """Payloads of a classic little-endian pcap of whole Ethernet frames, with the time of each in .time."""
    data = capture.read_bytes()
    at = 24
    while at + 16 <= len(data):
        length = int.from_bytes(data[at + 8:at + 12], "little")
        yield data[at + 16 + 42:at + 16 + length]
        at += 16 + length


def expected(capture, info):
    """Points as the SDK gives them, in the order of (frame, column, line, return)."""
    lut = core.XYZLut(info, False)
    order = np.argsort(np.argsort(np.asarray(info.beam_altitude_angles), kind="stable"), kind="stable")
    rows, points = [], []
    for index, frames in enumerate(pcap.PcapScanSource(str(capture), sensor_info=[info])):
        scan = frames[0]
        valid = (scan.status & 1) == 1
        for number, (r, f) in enumerate((("RANGE", "REFLECTIVITY"), ("RANGE2", "REFLECTIVITY2")), 1):
            if r not in scan.fields:
                continue
            ranges = scan.field(r)
            xyz = lut(scan.field(r))
            line, column = np.nonzero((ranges > 0) & valid[None, :])
            points.append(xyz[line, column])
            rows.append(np.column_stack([np.full(line.size, index), column, order[line], np.full(line.size, number), scan.timestamp[column], scan.field(f)[line, column]]))
    rows, points = np.concatenate(rows), np.concatenate(points)
    sort = np.lexsort((rows[:, 3], rows[:, 2], rows[:, 4], rows[:, 0]))
    return rows[sort], points[sort]


def inertial_of(capture, info):
    format = core.PacketFormat.from_info(info)
    out = []
    for payload in udp_payloads(capture):
        if len(payload) != format.imu_packet_size:
            continue
        rates = [np.deg2rad(getattr(format, f"imu_av_{a}")(payload)) for a in "xyz"]
        forces = [GRAVITY * getattr(format, f"imu_la_{a}")(payload) for a in "xyz"]
        out.append([format.imu_gyro_ts(payload) * 1e-9, *rates, *forces])
    return np.array(out)


def compare(dump, capture):
    info = metadata_of(capture)
    if info is None:
        return f"{capture.name}: no JSON file fits"
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "scan"
        done = subprocess.run([str(dump), str(capture), str(out), "min_range=0", "max_range=1000", "keep_partial_frames=true"], capture_output=True, text=True)
        if done.returncode != 0:
            return f"{capture.name}: {done.stderr.strip()}"
        ours = json.loads(done.stdout)
        load = lambda name, kind: np.fromfile(f"{out}.{name}", dtype=kind)
        positions, times = load("positions", np.float32).reshape(-1, 3), load("times", np.float32).astype(float)
        rings, intensities, numbers = load("rings", np.uint16), load("intensities", np.float32), load("returns", np.uint8)
        inertial = load("imu", np.float64).reshape(-1, 7)
    rows, points = expected(capture, info)
    frame = np.repeat(np.arange(len(ours["frames"])), [f["points"] for f in ours["frames"]])
    if len(positions) != len(points):
        return f"{capture.name}: {len(positions)} points, the SDK has {len(points)}"
    times += np.array([f["start_s"] for f in ours["frames"]])[frame]
    sort = np.lexsort((numbers, rings, times, frame))
    distance = np.abs(positions[sort] - points).max()
    shift = times.min() - rows[:, 4].min() * 1e-9  # the clock of the recorder
    late = np.abs(times[sort] - rows[:, 4] * 1e-9 - shift).max()
    same = {"frames": np.array_equal(frame[sort], rows[:, 0]), "rings": np.array_equal(rings[sort], rows[:, 2]), "returns": np.array_equal(numbers[sort], rows[:, 3]),
            "reflectivity": np.array_equal(intensities[sort], rows[:, 5].astype(np.float32)), "positions": distance <= MAX_DISTANCE_M, "times": late <= MAX_TIME_S}
    samples = inertial_of(capture, info)
    if len(samples):
        samples[:, 0] += shift
        same["inertial"] = samples.shape == inertial.shape and np.abs(samples[np.argsort(samples[:, 0])] - inertial).max() < 1e-5
    wrong = [name for name, equal in same.items() if not equal]
    print(f"{capture.name}: {len(ours['frames'])} frames, {len(points)} points, {len(samples)} inertial samples; largest difference {distance * 1e6:.2f} um, {late * 1e9:.0f} ns")
    return f"{capture.name}: {', '.join(wrong)} differ" if wrong else None


def write_captures(folder, example):
    """Captures that the SDK writes from the sensor of an example file: one per profile, nested metadata."""
    random = np.random.default_rng(1)
    for profile in ("LEGACY", "RNG19_RFL8_SIG16_NIR16", "RNG19_RFL8_SIG16_NIR16_DUAL", "RNG15_RFL8_NIR8", "RNG15_RFL8_NIR8_DUAL"):
        metadata = json.loads(core.SensorInfo(example.read_text()).to_json_string())
        metadata["lidar_data_format"]["udp_profile_lidar"] = profile
        metadata["config_params"]["udp_profile_lidar"] = profile
        metadata["beam_intrinsics"]["beam_to_lidar_transform"][11] = 3.5
        path = folder / f"{profile}.json"
        path.write_text(json.dumps(metadata))
        info = core.SensorInfo(path.read_text())
        packets = []
        for number in range(3):
            scan = core.LidarScan(info)
            scan.frame_id = 65534 + number & 0xFFFF
            for name in scan.fields:
                if name.startswith("RANGE"):
                    unit = 8 if profile.startswith("RNG15") else 1
                    scan.field(name)[:] = random.integers(0, 200000 // unit, scan.field(name).shape) * unit * (random.random(scan.field(name).shape) > 0.3)
                elif name.startswith("REFL"):
                    scan.field(name)[:] = random.integers(0, 255, scan.field(name).shape)
            scan.status[:] = random.random(scan.w) > 0.05
            scan.measurement_id[:] = np.arange(scan.w)
            scan.timestamp[:] = (1_700_000_000_000_000_000 + number * 100_000_000 + np.arange(scan.w) * 97_656).astype(np.uint64)
            scan.packet_timestamp[:] = scan.timestamp[::info.format.columns_per_packet]
            packets += list(core.scan_to_packets(scan, core.PacketFormat.from_info(info), 0, int(info.sn)))
        pcap.record(packets, str(folder / f"{profile}.pcap"))


def main():
    build = pathlib.Path(sys.argv[1])
    folder = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else pathlib.Path(__file__).parents[3] / "../shared/data/OUSTER_pcaps"
    captures = sorted(folder.glob("*.pcap"))
    if not captures:
        print(f"SKIPPED: no captures in {folder}")
        return 0
    dump = build / "bin" / "scan_dump"
    errors = [e for e in (compare(dump, c) for c in captures) if e]
    with tempfile.TemporaryDirectory() as written:
        write_captures(pathlib.Path(written), folder / "OS-1-128_v2.3.0_1024x10.json")
        errors += [e for e in (compare(dump, c) for c in sorted(pathlib.Path(written).glob("*.pcap"))) if e]
    print("\n".join(errors) or "all equal")
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())
