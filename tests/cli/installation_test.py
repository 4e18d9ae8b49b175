#!/usr/bin/env python3
"""Installs a build (cmake and the folder of the build are the arguments) and runs what was installed from another place."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

cmake, build = sys.argv[1:]
with tempfile.TemporaryDirectory(prefix="bole_install_") as temporary:
    prefix = pathlib.Path(temporary) / "first"
    subprocess.run([cmake, "--install", build, "--prefix", prefix, "--strip"], check=True, stdout=subprocess.DEVNULL)
    moved = pathlib.Path(temporary) / "moved"
    shutil.move(prefix, moved)
    environment = {k: v for k, v in os.environ.items() if k not in {"BOLE_RESOURCE_DIR", "LD_LIBRARY_PATH", "PYTHONDONTWRITEBYTECODE", "PYTHONPYCACHEPREFIX"}}
    bole = moved / "bin" / "bole"

    def run(*arguments):
        return subprocess.run([bole, *map(str, arguments)], env=environment, capture_output=True, text=True, timeout=60)

    libraries = subprocess.run(["ldd", bole], env=environment, capture_output=True, text=True, check=True).stdout
    ours = [line.split()[2] for line in libraries.splitlines() if "libbole_" in line or "libvtkBole" in line]
    assert ours and all(pathlib.Path(p).is_relative_to(moved) for p in ours), libraries
    listed = run("stages")
    assert listed.returncode == 0 and "stems.measure" in listed.stdout, listed
    # The resources are those of the installation, not of the folder that it was built from.
    plots = moved / "share" / "bole" / "resources" / "plots"
    shutil.copy(plots / "demo.json", plots / "only_installed.json")
    told = run("simulate", "--plot", "no_such_plot", "--out", moved / "scan")
    assert told.returncode == 2 and "only_installed" in told.stderr, told
    assert (moved / "share" / "bole" / "pipelines" / "forest_plot.json").is_file()
    validated = run("validate", moved / "share" / "bole" / "pipelines" / "forest_plot.json", "--set", f"scan.file={moved}")
    assert "report.plot" in validated.stderr + validated.stdout or validated.returncode == 0, validated
    # The engine of campaigns is that of the installation too.
    campaign = moved / "campaign.json"
    campaign.write_text('{"pipeline": "forest_plot", "inputs": [{"id": "p1", "set": {"scan.file": "walk.pcap"}}]}')
    planned = run("campaign", "plan", campaign, "--out", moved / "out")
    assert planned.returncode == 0 and "1 of 1 inputs run" in planned.stdout, planned
    assert (moved / "share" / "bole" / "python" / "bole_campaign" / "__pycache__").is_dir(), "another engine ran"
    # The Python module finds the libraries of its installation too.
    python = moved / "lib" / "python3" / "dist-packages"
    if python.is_dir():
        told = subprocess.run([sys.executable, "-c", "import bole, bole.campaign; assert 'moved' in bole.campaign.__file__; print(open('/proc/self/maps').read())"], env={**environment, "PYTHONPATH": str(python)},
                              capture_output=True, text=True, timeout=60, cwd=temporary)
        assert told.returncode == 0, told.stderr
        loaded = {line.split()[-1] for line in told.stdout.splitlines() if "libbole_" in line or "libvtkBole" in line}
        assert loaded and all(pathlib.Path(p).is_relative_to(moved) for p in loaded), loaded
