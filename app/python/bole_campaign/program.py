"""What the program `bole` knows: its version, the options of its stages, the pipelines that come with it."""

import functools
import json
import os
import pathlib
import shutil
import subprocess

from .errors import bad_input, did_you_mean, failure

# Options that may be a name or a file (base/option.cpp, is_input_path).
FILE_ENDINGS = (".json", ".csv", ".txt", ".xml")


def find_program():
    """Of a Python program; the command line gives its own place."""
    beside = pathlib.Path(__file__).resolve().parents[4] / "bin" / "bole"  # in an installation
    program = os.environ.get("BOLE_PROGRAM") or (str(beside) if beside.is_file() else shutil.which("bole"))
    if not program:
        raise failure("the program bole is not in the PATH", "its place", "Set the environment variable BOLE_PROGRAM")
    return os.path.abspath(program)


def ask(program, *arguments):
    done = subprocess.run([program, *arguments], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise failure(f"'{program} {' '.join(arguments)}' ended with {done.returncode}", remedy=done.stderr.strip())
    return done.stdout


@functools.lru_cache
def stage_options(program):
    """{stage type: {option: declaration}}"""
    return {stage["type"]: {o["name"]: o for o in stage["options"]} for stage in json.loads(ask(program, "stages", "--json"))}


@functools.lru_cache
def cloud_endings(program):
    """{ending: name of the format} of the files that are read as one point cloud."""
    formats = json.loads(ask(program, "info", "--formats", "--json"))
    return {ending: f["name"] for f in formats if f["stage"] == "io.read_cloud" and not f["folder"] for ending in f["endings"]}


@functools.lru_cache
def version_of(program):
    return ask(program, "--version").split()[-1]


def pipelines_folder():
    """Beside the engine: share/bole/pipelines in an installation, pipelines in the source tree."""
    here = pathlib.Path(__file__).resolve()
    return next((p for p in (here.parents[2] / "pipelines", here.parents[3] / "pipelines") if p.is_dir()), here.parents[2])


def find_pipeline(name, base):
    """The path of a document: a file, taken from the folder of the campaign, or one that comes with Bole."""
    for folder in (base, pathlib.Path.cwd()):
        if (path := folder / os.path.expanduser(name)).is_file():
            return path.resolve()
    shipped = {p.stem: p for p in pipelines_folder().glob("*.json")}
    if name.removesuffix(".json") in shipped:
        return shipped[name.removesuffix(".json")]
    raise bad_input(f"there is no pipeline '{name}'", "a pipeline document (JSON), or one that comes with Bole: " + ", ".join(sorted(shipped)),
                    did_you_mean(name, shipped))


class Pipeline:
    """A pipeline document and what may be set in it."""

    def __init__(self, path, program):
        self.path, self.program = path, program
        try:
            self.document = json.loads(path.read_text(encoding="utf-8"))
            self.stages = {stage["id"]: stage for stage in self.document["stages"]}
            types = {stage_id: stage["type"] for stage_id, stage in self.stages.items()}
        except (json.JSONDecodeError, UnicodeDecodeError, KeyError, TypeError) as error:
            raise bad_input(f"'{path}' is not a pipeline document ({error})", "stages with id and type", f"bole validate {path} tells more") from None
        known = stage_options(program)
        unknown = next((t for t in types.values() if t not in known), None)
        if unknown is not None:
            raise bad_input(f"'{path}' has a stage of the type '{unknown}', which there is not", "a type that bole stages lists", did_you_mean(unknown, known))
        self.options = {f"{stage_id}.{name}": o for stage_id, stage_type in types.items() for name, o in known[stage_type].items()}

    def check_name(self, name, place):
        if name not in self.options:
            stage = name.split(".")[0]
            near = [o for o in self.options if o.startswith(stage + ".")] if stage in self.stages else self.options
            raise bad_input(f"{place}: the pipeline has no option '{name}'", "STAGE.OPTION of a stage of " + ", ".join(self.stages), did_you_mean(name, near))

    def is_path(self, name, value):
        """Whether this value names a file or folder that is read."""
        return value != "" and (self.options[name]["type"] == "path" or (self.options[name]["type"] == "text" and value.endswith(FILE_ENDINGS)))

    def paths_in(self, name, value):
        """The paths of a value with is_path(): several where the option takes a list (base/core/path_list.h)."""
        separator = self.options[name].get("choices") if self.options[name]["type"] == "path" else None
        if not separator:
            return [value]
        return [path.strip() for path in value.split(separator[0]) if path.strip()]

    def reader(self):
        """The option that takes an input: of the first stage without inputs."""
        for stage_id, stage in self.stages.items():
            if not stage.get("inputs") and not stage.get("optional"):
                for name, option in self.options.items():
                    if name.split(".")[0] == stage_id and option["type"] == "path":
                        return name
        raise bad_input(f"no stage of '{self.path}' reads a file", "the option that takes the input", 'Name it with "option": "STAGE.OPTION"')

    def files_in_document(self):
        """{option: [path, ...]} of the files that the document itself names."""
        found = {}
        for stage_id, stage in self.stages.items():
            for name, value in (stage.get("options") or {}).items():
                option = f"{stage_id}.{name}"
                if isinstance(value, str) and option in self.options and self.is_path(option, value):
                    found[option] = [str((self.path.parent / os.path.expanduser(path)).resolve()) for path in self.paths_in(option, value)]
        return {option: paths for option, paths in found.items() if all(map(os.path.exists, paths))}
