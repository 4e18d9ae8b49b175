"""bole.run: the pipeline objects of Bole in this process (docs/adr/0014-python.md). Nothing is computed here."""

import json
import os
import threading
import time

from . import _arrays, _errors, _progress
from ._documents import declarations, document_of
from ._errors import BadInput, BadOption, Cancelled, PartialOutput
from ._results import Result

# Who takes arrays, and how they become VTK objects: the readers that have StageType::take.
TAKERS = {"io.read_cloud": _arrays.cloud_to_vtk, "io.read_table": _arrays.table_to_vtk}
LONGEST_PAUSE_S = 0.05

_one_at_a_time = threading.Lock()
_left = []  # pipelines of runs that nobody waits for any more


def _is_list_of_paths(value):
    return isinstance(value, (list, tuple)) and bool(value) and all(isinstance(v, (str, os.PathLike)) for v in value)


def text_of(value, name):
    """A value of an option as the command line takes it. Lists of texts are lists of paths."""
    if hasattr(value, "item") and getattr(value, "ndim", None) == 0:
        value = value.item()  # a number of numpy
    if isinstance(value, os.PathLike):
        value = os.fspath(value)
    if _is_list_of_paths(value):
        value = ",".join(map(os.fspath, value))
    if isinstance(value, tuple):
        value = list(value)
    from bole_campaign.document import text_of as engine_text

    with _errors.translated():
        return engine_text(value, f"option {name}")


class _Inputs:
    """What was given by name, brought to options and data of the stages of a pipeline."""

    def __init__(self, pipeline, name):
        self.pipeline, self.name = pipeline, name
        self.stages = {}
        for i in range(pipeline.GetNumberOfStages()):
            stage_id = pipeline.GetStageId(i)
            self.stages[stage_id] = declarations()[pipeline.GetStage(stage_id).GetStageType()]

    def set(self, option, value):
        if not self.pipeline.SetOption(option, text_of(value, option)):
            text = self.pipeline.GetErrorText()
            raise BadOption(_errors.in_python(text), option=option, suggestions=_errors.suggested(text))

    def give(self, name, value):
        """A keyword that is no argument of run(): an option, or what a stage is to have."""
        if "." in name:
            return self.set(name, value)
        if name not in self.stages:
            self._refuse(name)
        stage = self.stages[name]
        taker = TAKERS.get(stage["type"])
        if isinstance(value, dict) and value and not (taker and any(hasattr(v, "__len__") and not isinstance(v, (str, dict)) for v in value.values())):
            for option, option_value in value.items():
                self.set(f"{name}.{option}", option_value)
            return None
        reads = not stage["inputs"]
        path_option = next((o["name"] for o in stage["options"] if reads and o["type"] == "path"), None)
        is_path = isinstance(value, (str, os.PathLike)) or _is_list_of_paths(value)
        if is_path and path_option:
            return self.set(f"{name}.{path_option}", value)
        if is_path or taker is None:
            takes = [f"the path of its {path_option} as a text"] if path_option else []
            raise BadInput(f"{name} is {type(value).__name__}, and stage '{name}' ({stage['type']}) does not take that; needed: "
                           + ", or ".join([*takes, "a dict of its options: " + ", ".join(o["name"] for o in stage["options"][:6])]))
        data = taker(value, f"{name}")
        if not self.pipeline.TakeData(name, data):
            raise BadInput(_errors.in_python(self.pipeline.GetErrorText()))
        return None

    def _refuse(self, name):
        from bole_campaign.errors import did_you_mean

        own = ["out", "set", "force", "accept_partial", "cache", "threads", "progress", "on_interrupt"]
        options = {f"{stage_id}.{o['name']}" for stage_id, stage in self.stages.items() for o in stage["options"]}
        of_that_name = sorted(option for option in options if option.split(".")[1] == name)
        near = f"Did you mean {' or '.join(of_that_name[:3])}?" if of_that_name else did_you_mean(name, [*self.stages, *own, *options])
        raise BadOption(
            f"{self.name} has no stage or argument '{name}'; needed: one of its stages ({', '.join(self.stages)}), "
            f'or an option as **{{"stage.option": value}}' + (f". {near}" if near else ""),
            option=name, suggestions=_errors.suggested(near),
        )


def _poll(pipeline, shown):
    pause = 0.002
    while not pipeline.Wait(0):
        shown.update(pipeline.GetCurrentStage(), pipeline.GetProgress(), pipeline.GetProgressText())
        time.sleep(pause)
        pause = min(1.3 * pause, LONGEST_PAUSE_S)


def _wait(pipeline, shown, finishes):
    """Until the run has ended. Ctrl-C cancels it (or, once, lets it finish); once more leaves it to end by itself."""
    cancelling = False
    while True:
        try:
            return _poll(pipeline, shown)
        except KeyboardInterrupt:
            if cancelling:
                _left.append(pipeline)
                raise Cancelled("cancelled; the stage that runs ends by itself") from None
            if finishes:
                finishes = False
                pipeline.Finish()
            else:
                cancelling = True
                pipeline.Cancel()
        except BaseException:  # of the function that shows the progress
            pipeline.Cancel()
            while not pipeline.Wait(LONGEST_PAUSE_S):
                pass
            raise


def _word(pipeline):
    if pipeline.GetExitCode() == 0:
        early = json.loads(pipeline.GetSummaryJSON() or "{}").get("exit_code") == PartialOutput.exit_code
        return "finished early" if early else "done"
    return "cancelled" if pipeline.GetExitCode() == Cancelled.exit_code else "failed"


def _outcome(pipeline, out):
    """The result, or the error that the run ended with."""
    code, text = pipeline.GetExitCode(), pipeline.GetErrorText()
    summary = json.loads(pipeline.GetSummaryJSON() or "null")
    folder = pipeline.GetResultsDirectory()
    if code == 0:
        result = Result(pipeline, summary, folder)
        if result.finished_early:
            raise PartialOutput(
                "the run was asked to finish early: the result is not complete; needed: a run to its end",
                result=result, summary=summary, findings=result.findings, results=result.folder,
            )
        return result
    if code == 3:
        kept = pipeline.GetSurveyKept()
        told = f"The results before are still in {out}, unchanged" if kept else "There are no results"
        raise Cancelled(f"the run was cancelled. {told}", summary=summary, survey_kept=kept)
    raise _errors.of_code(code, text, summary=summary, findings=(summary or {}).get("findings", []), results=_errors.path_or_none(folder),
                          survey_kept=pipeline.GetSurveyKept())


def run(pipeline, out=None, *, set=None, force=False, accept_partial=False, cache=None, threads=None, progress=None, on_interrupt="cancel", **inputs):
    """Runs a pipeline in this process, as `bole run` does, and returns a Result.

        survey = bole.run("forest_plot", scan="walk.pcap", out="survey", **{"slam.preset": "loam"})
        survey = bole.run("stem_map_from_cloud", scan=points)        # an (N, 3) array of metres; nothing is written

    pipeline        name of one that comes with Bole (bole.pipelines()), path of a document, or a document as a dict
    out             folder for results. They take its place whole, when the run ends. None: nothing is written
    STAGE=value     what a stage is to have: a path (its file), a dict of its options, or, for stages that read clouds or tables, data:
                    an (N, 3) array of metres; a dict, structured array or data frame with x, y, z (or xyz) and other columns,
                    such as intensity; Points of another result; a vtkPolyData. Tables: a dict of columns or a data frame
    set             {"STAGE.OPTION": value}; the same as keywords: **{"STAGE.OPTION": value}. bole.stages() has units and ranges
    force           write over files in `out` that have names of results and are not Bole's
    accept_partial  go on with an input of which a part cannot be read (it is a finding then)
    cache           folder of stored stage results (None: `cache` in `out`), or False: run every stage, store nothing
    threads         threads that work at the same time (None: one per processor)
    progress        None: shown in a terminal and in a notebook; True: lines elsewhere too; False: not at all;
                    or a function of stage, fraction (0 to 1) and text
    on_interrupt    what the first Ctrl-C does: "cancel" throws the work away (Cancelled), "finish" keeps what there is so far
                    (PartialOutput, with the result)

    Throws BadInput (with BadOption), Failed, Cancelled and PartialOutput: see bole.BoleError. One run at a time in a process; several at a time: bole.campaign.
    """
    import bole

    if on_interrupt not in ("cancel", "finish"):
        raise BadOption(f"on_interrupt is {on_interrupt!r}; needed: \"cancel\" or \"finish\"", option="on_interrupt", suggestions=("cancel", "finish"))
    path, text = document_of(pipeline)
    native = bole.vtkBolePipeline()
    native.AddObserver("ErrorEvent", lambda *_: None)  # errors are raised; VTK shall not print them as well
    if not (native.LoadDocument(path) if path else native.ParseDocument(text)):
        raise BadInput(_errors.in_python(native.GetErrorText()))
    name = "the pipeline" if text else os.path.basename(path).removesuffix(".json")
    given = _Inputs(native, name)
    for option, value in (set or {}).items():
        given.give(option, value) if "." not in option else given.set(option, value)
    for key, value in inputs.items():
        given.give(key, value)
    if out is not None:
        native.SetOutputDirectory(os.path.abspath(os.path.expanduser(os.fspath(out))))
    native.SetUseCache(cache is not False)
    if cache not in (None, False, True):
        native.SetCacheDirectory(os.path.abspath(os.path.expanduser(os.fspath(cache))))
    native.SetNumberOfThreads(0 if threads is None else int(threads))
    native.SetAcceptPartial(bool(accept_partial))
    native.SetReplaceForeign(bool(force))
    with _one_at_a_time:
        shown = _progress.shown(progress, name)
        word = "failed"
        try:
            native.Start()
            _wait(native, shown, on_interrupt == "finish")
            word = _word(native)
        finally:
            shown.end(word)
    return _outcome(native, out)
