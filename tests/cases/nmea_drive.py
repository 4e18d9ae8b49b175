#!/usr/bin/env python3
"""A simulated drive written as the NMEA log of a receiver on the roof, and measured again from that log alone.

steering_test.json drives a tractor over two lines. Its antenna positions become GGA and HDT sentences: latitude and longitude by Krueger's
series, written here and not taken from the program, headings from true north, the antenna ahead of and beside the rear axle. Among them
stand sentences that must not count: wrong checksums, no fix, another talker, times that run back. steering_track.json must find the passes
and the errors of the drive's own log, from A and B in latitude and longitude.
"""

import argparse
import csv
import json
import math
import pathlib
import shutil
import subprocess
import sys

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
EASTING, NORTHING, MERIDIAN_DEG = 434_000.0, 2_562_000.0, 114.0  # where the field lies
FORWARD, LEFT = 0.8, 0.3  # of the antenna, metres
SEMI_MAJOR, FLATTENING = 6378137.0, 1 / 298.257222101


def krueger(latitude_deg, longitude_deg):
    """Easting, northing and convergence (degrees) of a Gauss-Krueger plane, by Krueger's series in the third flattening."""
    n = FLATTENING / (2 - FLATTENING)
    radius = SEMI_MAJOR / (1 + n) * (1 + n**2 / 4 + n**4 / 64)
    alpha = [n / 2 - 2 * n**2 / 3 + 5 * n**3 / 16 + 41 * n**4 / 180, 13 * n**2 / 48 - 3 * n**3 / 5 + 557 * n**4 / 1440,
             61 * n**3 / 240 - 103 * n**4 / 140, 49561 * n**4 / 161280]
    phi, lam = math.radians(latitude_deg), math.radians(longitude_deg - MERIDIAN_DEG)
    e = 2 * math.sqrt(n) / (1 + n)
    t = math.sinh(math.atanh(math.sin(phi)) - e * math.atanh(e * math.sin(phi)))
    xi, eta = math.atan2(t, math.cos(lam)), math.atanh(math.sin(lam) / math.sqrt(1 + t * t))
    east = eta + sum(a * math.cos(2 * j * xi) * math.sinh(2 * j * eta) for j, a in enumerate(alpha, 1))
    north = xi + sum(a * math.sin(2 * j * xi) * math.cosh(2 * j * eta) for j, a in enumerate(alpha, 1))
    sigma = 1 + sum(2 * j * a * math.cos(2 * j * xi) * math.cosh(2 * j * eta) for j, a in enumerate(alpha, 1))
    tau = sum(2 * j * a * math.sin(2 * j * xi) * math.sinh(2 * j * eta) for j, a in enumerate(alpha, 1))
    convergence = math.atan2(tau, sigma) + math.atan(math.tan(lam) * t / math.sqrt(1 + t * t))
    return 500_000 + radius * east, radius * north, math.degrees(convergence)


def degrees_of(x, y):
    """Latitude, longitude and convergence of a place in the field, by iteration of krueger()."""
    latitude, longitude = (NORTHING + y) / 110_900, MERIDIAN_DEG + (EASTING + x - 500_000) / 102_000
    for _ in range(20):
        easting, northing, convergence = krueger(latitude, longitude)
        latitude += (NORTHING + y - northing) / 110_700
        longitude += (EASTING + x - easting) / (111_300 * math.cos(math.radians(latitude)))
    assert abs(easting - EASTING - x) < 1e-6 and abs(northing - NORTHING - y) < 1e-6
    return latitude, longitude, convergence


def sentence(body):
    checksum = 0
    for character in body.encode():
        checksum ^= character
    return f"${body}*{checksum:02X}\r\n"


def minutes(angle, digits):
    return f"{int(angle):0{digits}d}{60 * (angle - int(angle)):011.8f}"


def gga(time_s, latitude, longitude, quality=4, talker="GN"):
    clock = f"{int(time_s // 3600):02d}{int(time_s % 3600 // 60):02d}{time_s % 60:05.2f}"
    if quality == 0:
        return sentence(f"{talker}GGA,{clock},,,,,0,00,,,M,,M,,")
    return sentence(f"{talker}GGA,{clock},{minutes(latitude, 2)},N,{minutes(longitude, 3)},E,{quality},17,0.7,30.250,M,-5.250,M,1.0,0133")


def run(command):
    print("+", " ".join(map(str, command)), flush=True)
    result = subprocess.run([str(c) for c in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if result.returncode != 0:
        sys.exit(f"{result.stdout}\nexit code {result.returncode}")


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def write_log(drive, path):
    """The fixes at the control point as an antenna would have had them."""
    spoilt = {"checksum": 0, "no_fix": 0, "back": 0}
    with open(path, "w", newline="") as file:
        for i, row in enumerate(drive):
            x, y, yaw = float(row["gnss_x_m"]), float(row["gnss_y_m"]), math.radians(float(row["yaw_deg"]))
            antenna = (x + FORWARD * math.cos(yaw) - LEFT * math.sin(yaw), y + FORWARD * math.sin(yaw) + LEFT * math.cos(yaw))
            latitude, longitude, convergence = degrees_of(*antenna)
            time_s = 36_000 + float(row["time_s"])
            if i % 100 == 50:  # right form, wrong content
                file.write(gga(time_s, latitude + 0.01, longitude).replace("*", "*F", 1)[:-3] + "\r\n")
                spoilt["checksum"] += 1
            if i % 200 == 150:
                file.write(gga(time_s - 0.04, 0, 0, quality=0))
                spoilt["no_fix"] += 1
            if i == 700:
                file.write(gga(time_s - 30, latitude, longitude))
                spoilt["back"] += 1
            file.write(gga(time_s, latitude, longitude))
            if i % 7 == 0:  # a second talker of the same receiver, of poorer quality, for the same epoch
                file.write(gga(time_s, latitude + 4e-6, longitude, quality=2, talker="GP"))
            file.write(sentence(f"GNHDT,{(90 - math.degrees(yaw) + convergence) % 360:.5f},T"))
    return spoilt


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bole", required=True)
    parser.add_argument("--work", required=True, type=pathlib.Path)
    args = parser.parse_args()
    shutil.rmtree(args.work, ignore_errors=True)
    args.work.mkdir(parents=True)
    quiet = ["--no-cache", "--set", "report.figures=false"]
    run([args.bole, "run", REPOSITORY / "pipelines/steering_test.json", "--out", args.work / "drive", *quiet, "--set", "drive.speeds=5",
         "--set", "drive.direction=25"])
    drive = rows(args.work / "drive/steering_log.csv")
    spoilt = write_log(drive, args.work / "drive.nmea")
    direction = math.radians(25)
    with open(args.work / "ab.csv", "w") as file:
        file.write("name,latitude_deg,longitude_deg\n")
        for name, along in (("A", 0), ("B", 140)):
            latitude, longitude, _ = degrees_of(along * math.cos(direction), along * math.sin(direction))
            file.write(f"{name},{latitude:.10f},{longitude:.10f}\n")
    run([args.bole, "run", REPOSITORY / "pipelines/steering_track.json", "--out", args.work / "track", *quiet,
         "--set", f"track.file={args.work / 'drive.nmea'}", "--set", f"ab.file={args.work / 'ab.csv'}", "--set", "plan.width=2.5",
         "--set", f"navigate.antenna_forward={FORWARD}", "--set", f"navigate.antenna_left={LEFT}", "--set", "navigate.position_sigma=0.01"])

    complaints = []
    summary = json.loads((args.work / "track/summary.json").read_text())
    stages = {s["id"]: s for s in summary["stages"]}
    read, navigated = stages["track"]["counts"], stages["navigate"]["counts"]
    for what, found, expected in (("bad checksums", read["bad_checksum"], spoilt["checksum"]),
                                  ("sentences without a fix", read["without_fix"], spoilt["no_fix"]),
                                  ("positions back in time", read["out_of_order"], spoilt["back"]),
                                  ("fixes", navigated["fixes"], len(drive)),
                                  ("measured headings", navigated["heading_measured"], len(drive)),
                                  ("gaps", navigated["gaps"], 0)):
        print(f"{what}: {found} (expected {expected})")
        if found != expected:
            complaints.append(f"{what}: {found}, not {expected}")
    codes = {finding["code"] for stage in summary["stages"] for finding in stage.get("findings", [])}
    if "times_run_back" not in codes:
        complaints.append(f"no finding tells that times run back: {sorted(codes)}")

    own, measured = rows(args.work / "drive/steering_passes.csv"), rows(args.work / "track/steering_passes.csv")
    if len(own) != len(measured):
        sys.exit(f"{len(measured)} passes, not {len(own)}")
    for mine, theirs in zip(own, measured):
        for name in ("mean", "sd", "max"):  # the log is what the controller knew: its own error
            a, b = float(mine[f"controller_{name}_m"]), float(theirs[f"line_{name}_m"])
            print(f"pass {mine['pass']}: {name} {a:.5f} m by the drive, {b:.5f} m from the log")
            if abs(a - b) > 0.0005:
                complaints.append(f"{name} of pass {mine['pass']}: {b} m, not {a} m")
        if mine["row"] != theirs["row"] or mine["direction"] != theirs["direction"]:
            complaints.append(f"pass {mine['pass']} is on row {theirs['row']}, direction {theirs['direction']}")
    print("\n".join(f"FAIL {c}" for c in complaints))
    if not complaints:
        shutil.rmtree(args.work, ignore_errors=True)
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
