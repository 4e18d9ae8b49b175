"""Inputs at work on this machine without Dask: each attempt is a process of its own."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

LOOK_EVERY_S = 0.02
START = pathlib.Path(__file__).with_name("start.py")


def start_attempt(spec, parent):
    """A process that runs one attempt and ends with `parent`, the thread of this process that calls."""
    said = tempfile.TemporaryFile()
    process = subprocess.Popen([sys.executable, str(START), "attempt"], stdin=subprocess.PIPE, stdout=said, stderr=subprocess.STDOUT)
    try:
        process.stdin.write(json.dumps({**spec, "parent": parent}).encode())
        process.stdin.close()
    except BrokenPipeError:
        pass  # it was killed: its end tells
    return process, said


def result_of(process, said):
    """The record that an attempt printed; of one that was killed or broke off, {"state": "lost"}."""
    said.seek(0)
    text = said.read().decode(errors="replace").strip()
    said.close()
    if process.returncode == 0 and text:
        return json.loads(text.splitlines()[-1])
    return {"state": "lost", "error": text.splitlines()[-1] if text else f"the worker ended with {process.returncode}"}


class LocalWorkers:
    name = "worker processes"

    def __init__(self, workers):
        self.workers = workers
        self.running = []  # (process, output, spec)

    def start(self, spec):
        self.running.append((*start_attempt(spec, os.getpid()), spec))

    def finished(self, wait_s):
        """[(spec, result)] of attempts that ended by now, or within a time."""
        until = time.monotonic() + wait_s
        while not (ended := [entry for entry in self.running if entry[0].poll() is not None]) and time.monotonic() < until:
            time.sleep(LOOK_EVERY_S)
        self.running = [entry for entry in self.running if entry not in ended]
        return [(spec, result_of(process, said)) for process, said, spec in ended]

    def close(self):
        for process, said, _ in self.running:
            process.kill()
            process.wait()
            said.close()
        self.running = []


def run_attempt_in_process(spec):
    """An attempt from begin to end; what a worker of Dask does."""
    process, said = start_attempt(spec, os.getpid())
    process.wait()
    return result_of(process, said)
