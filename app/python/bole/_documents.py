"""What can be run: pipelines that come with Bole, and the stages with their options, from the declarations of the program."""

import functools
import json
import pathlib
import textwrap

from ._errors import BadInput, translated


def _native_pipeline():
    import bole

    return bole.vtkBolePipeline


@functools.lru_cache(maxsize=1)
def declarations():
    """{stage type: declaration}, as `bole stages --json` prints them."""
    return {stage["type"]: stage for stage in json.loads(_native_pipeline().GetStagesJSON())}


def facts_of(option):
    """Type, unit, range and default of an option in one line."""
    words = [option["type"]]
    if option["type"] == "choice":
        words = [" | ".join(option.get("choices", []))]
    if option["unit"]:
        words.append(option["unit"])
    low, high = option.get("min"), option.get("max")
    if low is not None or high is not None:
        words.append(f"{low:.15g} to {high:.15g}" if None not in (low, high) else f"from {low:.15g}" if high is None else f"to {high:.15g}")
    default = option["default"]
    words.append("default " + ("empty" if default == "" else json.dumps(default) if not isinstance(default, str) else default))
    return ", ".join(words)


def help_of(option):
    """The help of an option, with what must hold for it to mean anything."""
    text = option["help"]
    for condition in option.get("conditions", []):
        word, values = ("is", condition["is"]) if "is" in condition else ("is not", condition["is_not"])
        text += f" Only if {condition['option']} {word} {' or '.join(value or 'empty' for value in values)}."
    return text


def page_of(declaration):
    """The docstring of a stage."""
    wrapped = functools.partial(textwrap.fill, width=100, break_on_hyphens=False, break_long_words=False)
    lines = [f"{declaration['type']}: {declaration['title']}", "", wrapped(declaration["help"])]

    def section(title, entries):
        if entries:
            lines.extend(["", title, "-" * len(title)])
        for heading, text in entries:
            lines.extend([heading, wrapped(text, initial_indent="    ", subsequent_indent="    ")])

    def port(declared, optional):
        arrays = f" ({', '.join(declared['arrays'])})" if declared["arrays"] else ""
        return f"{declared['name']} : {declared['kind']}{', optional' if optional else ''}{arrays}", declared["help"]

    section("Inputs", [port(p, p["optional"]) for p in declaration["inputs"]])
    section("Outputs", [port(p, False) for p in declaration["outputs"]])
    section("Options", [(f"{o['name']} : {facts_of(o)}", help_of(o)) for o in declaration["options"]])
    if declaration["source"]:
        lines.extend(["", f"Source: {declaration['source']}"])
    return "\n".join(lines)


class Option:
    """name, type, default, unit, min, max, choices, tier and help of an option. min, max, choices: None where there are none."""

    def __init__(self, declaration):
        self.min = self.max = self.choices = None
        for key, value in declaration.items():
            setattr(self, key, value)
        self.__doc__ = f"{self.name} : {facts_of(declaration)}\n    {help_of(declaration)}"

    def __repr__(self):
        return self.__doc__


class Stage:
    """A stage as it is declared: type, title, help, source, inputs, outputs, and options by name."""

    def __init__(self, declaration):
        self.type, self.title, self.help, self.source = (declaration[key] for key in ("type", "title", "help", "source"))
        self.inputs, self.outputs, self.vtk_class = declaration["inputs"], declaration["outputs"], declaration["vtk_class"]
        self.options = {o["name"]: Option(o) for o in declaration["options"]}

    def __repr__(self):
        return type(self).__doc__

    def _repr_markdown_(self):
        return _native_pipeline().GetStagePage(self.type)


class Listing(dict):
    """A dict that prints as a table of names and titles."""

    def __init__(self, entries, kind, nearest):
        super().__init__(entries)
        self._kind, self._nearest = kind, nearest

    def __missing__(self, name):
        near = self._nearest(name, self)
        raise BadInput(f"there is no {self._kind} '{name}'; needed: one of {', '.join(self)}" + (f". {near}" if near else ""))

    def __repr__(self):
        width = max(map(len, self), default=0)
        return "\n".join(f"{name:<{width}}  {entry.title}" for name, entry in self.items())


def _listing(entries, kind):
    from bole_campaign.errors import did_you_mean

    return Listing(entries, kind, did_you_mean)


def stages():
    """Every stage by its type: what it does, its inputs and outputs, and its options with units, defaults and ranges.

        print(bole.stages())                                 # all of them
        help(bole.stages()["stems.measure"])                 # everything about one
        bole.stages()["stems.slice"].options["height"].unit  # "m"

    All of it comes from the declarations that the program itself works with.
    """
    # A class for each, so that help() shows its own text.
    return _listing({name: type(name.replace(".", "_"), (Stage,), {"__doc__": page_of(d)})(d) for name, d in declarations().items()}, "stage")


class Pipeline:
    """A pipeline that comes with Bole: name, title, description, path, document (dict), and stages: {id: type}."""

    def __init__(self, path):
        self.path = pathlib.Path(path)
        self.name, self.document = self.path.stem, json.loads(self.path.read_text(encoding="utf-8"))
        self.title, self.description = self.document.get("title", ""), self.document.get("description", "")
        self.stages = {stage["id"]: stage["type"] for stage in self.document["stages"]}

    def __repr__(self):
        from ._errors import in_python

        stages = "\n".join(f"  {stage_id:<16} {stage_type}" for stage_id, stage_type in self.stages.items())
        return f"{self.name}: {self.title}\n\n{textwrap.fill(in_python(self.description), width=100)}\n\n{stages}"


def pipelines():
    """The pipelines that come with Bole, by name: what run() takes as its first argument beside documents of your own."""
    from bole_campaign.program import pipelines_folder

    return _listing({path.stem: Pipeline(path) for path in sorted(pipelines_folder().glob("*.json"))}, "pipeline")


def document_of(pipeline):
    """(path, None) or (None, JSON text) of a pipeline as a person names it. Throws BadInput."""
    if isinstance(pipeline, dict):
        return None, json.dumps(pipeline)
    from bole_campaign.program import find_pipeline

    with translated():
        path = find_pipeline(str(pipeline), pathlib.Path.cwd())
    if path.suffix.lower() != ".json":
        raise BadInput(
            f"'{pipeline}' is no pipeline; needed: the name of one that bole.pipelines() lists, or a document (JSON). "
            f'For a point cloud: bole.run("stem_map_from_cloud", scan="{pipeline}"), for a recording: bole.run("forest_plot", scan="{pipeline}")'
        )
    return str(path), None
