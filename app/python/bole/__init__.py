"""Bole: LiDAR forestry. From scans of a forest plot to a survey that can be signed.

    import bole
    survey = bole.run("stem_map_from_cloud", scan="plot.laz", out="survey")
    survey.stems          # a pandas DataFrame (without pandas: a dict of numpy arrays)
    survey.verdict        # "sign", "look" or "refused"
    survey.points["height_above_ground"]

    bole.pipelines()      # what can be run
    bole.stages()         # every stage with its options, units, defaults and ranges
    bole.campaign         # one pipeline on many inputs

Every stage is a VTK algorithm too (bole.vtkBoleGroundModel and so on), to be joined with other VTK filters, and
bole.vtkBolePipeline is what run() drives.
"""

from . import _build, _native

__version__ = _build.VERSION

_native.find_engine()
# `python3 -m bole` hands over to the program, which needs neither this Python nor VTK.
_classes = {} if _native.is_program() else _native.load()
globals().update(_classes)

from . import campaign
from ._documents import pipelines, stages
from ._errors import BadInput, BadOption, BoleError, Cancelled, Failed, PartialOutput
from ._results import Points, Raster, Result
from ._running import run

__all__ = [
    "BadInput", "BadOption", "BoleError", "Cancelled", "Failed", "PartialOutput", "Points", "Raster", "Result", "campaign", "pipelines", "run", "stages",
    *_classes,
]
