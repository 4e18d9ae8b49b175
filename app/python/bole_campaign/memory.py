"""How much memory an input needs, and how much there is."""

import os
import pathlib
import re

from . import keys
from .program import cloud_endings

GIB = 1 << 30
# Peak of a run = BASE_GIB + factor * size of the input, generous: measured in docs/dev/campaigns.md. A limit that is hit
# costs an attempt, one that is too high only a place for another input.
BASE_GIB = 0.5
FACTORS = {"COPC": 25.0, "LAZ": 25.0, "LAS": 6.0, "E57": 8.0, "PLY": 6.0, "PCD": 6.0, "PTX": 3.0, "PTS": 3.0, "XYZ": 3.0, "CSV": 3.0}
FACTOR_OF_CLOUDS = 8.0  # of any other format of point clouds
# Recordings and folders of frames are streamed: the map grows with them at first, then most of it lies on file.
FACTOR_OF_RECORDINGS, FULL_GIB, FACTOR_BEYOND = 8.0, 0.3, 0.8
RESERVE = 0.1


def factor_of(path, program):
    """Memory over size of a point cloud; None of anything else. The program knows the endings."""
    name = pathlib.Path(path).name.lower()
    found = next((f for ending, f in cloud_endings(program).items() if name.endswith(ending)), None)
    return FACTORS.get(found, FACTOR_OF_CLOUDS) if found else None


def declared_gib(entry, program):
    """What the document says, else an estimate from the sizes of the files."""
    if entry["memory_gib"] is not None:
        return entry["memory_gib"]
    needed = BASE_GIB
    for path in {path for paths in entry["files"].values() for path in paths}:
        size = keys.size_of(path) / GIB
        factor = factor_of(path, program)
        needed += factor * size if factor else FACTOR_OF_RECORDINGS * min(size, FULL_GIB) + FACTOR_BEYOND * max(0.0, size - FULL_GIB)
    return round(needed, 2)


def _cgroup_limits():
    """Limits of the control groups of this process, bytes (version 2, and version 1 as SLURM and Docker set it)."""
    try:
        with open("/proc/self/cgroup", encoding="ascii") as file:
            groups = [line.rstrip("\n").split(":", 2) for line in file]
    except OSError:
        return
    for _, controllers, group in groups:
        root, name = ("/sys/fs/cgroup", "memory.max") if controllers == "" else ("/sys/fs/cgroup/memory", "memory.limit_in_bytes")
        if controllers not in ("", "memory"):
            continue
        folder = pathlib.PurePosixPath(group)
        for part in [folder, *folder.parents]:
            try:
                text = pathlib.Path(root + str(part), name).read_text().strip()
            except OSError:
                continue
            if text.isdigit():
                yield int(text)


def machine_gib():
    """What workers of this machine may take together: what is available now or allowed, less a reserve."""
    limits = list(_cgroup_limits())
    try:
        with open("/proc/meminfo", encoding="ascii") as file:
            limits.append(1024 * int(re.search(r"MemAvailable:\s+(\d+)", file.read()).group(1)))
    except (OSError, AttributeError):
        limits.append(os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES"))
    if os.environ.get("SLURM_MEM_PER_NODE", "").isdigit():
        limits.append(int(os.environ["SLURM_MEM_PER_NODE"]) << 20)
    return round((1 - RESERVE) * min(limits) / GIB, 2)


def processors():
    """Those that this process may use."""
    return len(os.sched_getaffinity(0))
