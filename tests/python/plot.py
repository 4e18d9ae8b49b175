"""What the tests of the Python package share: a small plot with known stems, and where things are."""

import contextlib
import os
import pathlib
import subprocess
import sys

TOP = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ["BOLE_PROGRAM"]
PACKAGE = os.environ["PYTHONPATH"].split(os.pathsep)[0]

# Without figures and clouds, which have tests of their own.
QUICK = {"report.figures": False, "report.cloud": False}
SIDE_M = 14.0
# x, y, diameter at 1.30 m, all in metres.
STEMS = ((3.0, 3.0, 0.30), (7.0, 2.5, 0.24), (11.0, 4.0, 0.36), (4.0, 8.0, 0.20), (8.0, 9.0, 0.28), (11.5, 10.5, 0.32))


def height(x, y):
    return 0.05 * x + 0.02 * y


def plot_points(density=1):
    """(N, 3) points of a slope with six cylinders, metres; the same for every call. `density` multiplies their number."""
    import numpy

    rng = numpy.random.default_rng(7)
    ground = rng.uniform(0, SIDE_M, (int(25000 * density), 2))
    parts = [numpy.column_stack([ground, height(*ground.T) + rng.normal(0, 0.004, len(ground))])]
    for x, y, diameter in STEMS:
        count = int(12000 * density)
        angle, up = rng.uniform(0, 2 * numpy.pi, count), rng.uniform(0.0, 6.0, count)
        radius = diameter / 2 + rng.normal(0, 0.004, count)
        parts.append(numpy.column_stack([x + radius * numpy.cos(angle), y + radius * numpy.sin(angle), height(x, y) + up]))
    return numpy.round(numpy.vstack(parts), 4)


def written(points, path):
    """The points in a text file, and as a reader of the file gets them."""
    import numpy

    path.write_text("".join("%.4f %.4f %.4f\n" % tuple(p) for p in points))
    return numpy.loadtxt(path)


def python(code, *arguments, interpreter=sys.executable, **more):
    """A finished process of Python that ran the code."""
    return subprocess.run([interpreter, "-c", code, *map(str, arguments)], capture_output=True, text=True, timeout=120, check=False, **more)


@contextlib.contextmanager
def hidden(*names):
    """As if these modules were not installed."""
    before = {name: sys.modules.get(name) for name in names}
    sys.modules.update(dict.fromkeys(names))
    try:
        yield
    finally:
        for name, module in before.items():
            sys.modules.pop(name)
            if module is not None:
                sys.modules[name] = module
