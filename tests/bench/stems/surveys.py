"""Scans that are simulated and surveyed once and kept by folder, for the benches beside this file."""

import pathlib
import shutil
import subprocess
import sys

REPOSITORY = pathlib.Path(__file__).resolve().parents[3]
# Tables are all that is looked at.
QUICK = ["report.figures=false", "report.page=false", "report.cloud=false"]
ENDED_EARLY = 4  # exit code of a run whose track was lost: its results stand, but are not of the whole walk


def run(command, log, allowed=(0,)):
    """Runs a program with its words in the file `log`; ends all where its exit code is none of those allowed."""
    with open(log, "w", encoding="utf-8") as out:
        code = subprocess.run([str(c) for c in command], stdout=out, stderr=subprocess.STDOUT, check=False).returncode
    if code not in allowed:
        sys.exit(f"{' '.join(str(c) for c in command)} failed ({code}), see {log}")


def recording_of(scan):
    return scan / "walk.pcap" if (scan / "walk.pcap").exists() else scan / "frames"


def simulate(bole, flags, folder):
    """The folder of a scan, which is simulated with these options where its recording is not there yet."""
    scan, unfinished = folder / "scan", folder / "unfinished"
    if not recording_of(scan).exists():
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        run([bole, "simulate", *flags, "--out", unfinished], folder / "simulate.log")
        unfinished.rename(scan)
    return scan


def survey(bole, scan, settings, out, flags=("--no-cache",), allowed=(0,)):
    """Surveys the recording of a scan with pipelines/forest_plot.json into `out`."""
    settings = [f"scan.file={recording_of(scan)}", *QUICK, *settings]
    run([bole, "run", REPOSITORY / "pipelines/forest_plot.json", *flags, *[p for s in settings for p in ("--set", s)], "--out", out],
        out.parent / "run.log", allowed)


def remove_recording(scan, out):
    """What is large and no longer needed."""
    shutil.rmtree(scan / "frames", ignore_errors=True)
    for file in [*scan.glob("*.pcap"), *out.glob("*.la[sz]")]:
        file.unlink()
