"""What the tests in pvbatch share: checks, and how they say that they passed. The first process alone runs them."""

import sys
import traceback

import bole_paraview
from paraview import servermanager

failures = []


class Skipped(Exception):
    """Says what is missing."""


def check(good, text):
    if not good:
        failures.append(text)
        print("FAIL", text, flush=True)


def equal(found, expected, what):
    check(found == expected, f"{what}: {found!r}, expected {expected!r}")


def processes():
    return servermanager.vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions()


def run(test, load=True):
    """Loads the plugin and runs the test. pvbatch's own exit code says nothing of the script."""
    try:
        if load:
            bole_paraview.load_plugin()
        test(*sys.argv[1:])
        word = "failed" if failures else "passed"
    except Skipped as reason:
        word = f"skipped: {reason}"
    except BaseException:  # noqa: BLE001: also what ends the interpreter
        traceback.print_exc()
        word = "failed"
    print(f"\nbole-test: {word}", flush=True)
