"""A pipeline document as a form: its parameters follow from the document and the declarations that the program prints. Knows no QGIS."""

import dataclasses
import json

READERS = ("io.read_cloud", "io.read_scan", "io.read_table", "io.read_track")


@dataclasses.dataclass
class Parameter:
    """One option of one stage. kind: file, boolean, integer, number, choice or text."""

    name: str  # in QGIS: INPUT, or stage__option
    option: str  # in the program: stage.option
    label: str
    help: str
    kind: str
    default: object
    optional: bool
    advanced: bool
    choices: list = dataclasses.field(default_factory=list)
    low: object = None
    high: object = None


def read_document(path):
    return json.loads(path.read_text(encoding="utf-8"))


def input_stage(document):
    """The stage that reads what is surveyed: the first reader that must be given a file."""
    for stage in document["stages"]:
        if stage["type"] in READERS and not stage.get("optional"):
            return stage
    return None


def kind_of(option):
    if option["type"] == "path":
        return "file"
    return option["type"] if option["type"] in ("boolean", "integer", "number", "choice") else "text"


def parameters(document, stages):
    """The form of a document: its input first, then the options of every stage in their order. Edits are made in the window, not here."""
    read = input_stage(document)
    found = []
    for stage in document["stages"]:
        declared = stages[stage["type"]]
        for option in declared["options"]:
            if option["type"] == "json":
                continue
            is_input = stage is read and option["name"] == "file"
            default = stage.get("options", {}).get(option["name"], option["default"])
            number = option["type"] in ("integer", "number")
            # A word (auto, preset, cloud) stands for a number that is found: the field is then left empty.
            word = default if number and isinstance(default, str) else None
            title = declared["title"] if not stage.get("optional") else f"{declared['title']} ({stage['id']})"
            unit = f" [{option['unit']}]" if option["unit"] else ""
            found.append(
                Parameter(
                    name="INPUT" if is_input else f"{stage['id']}__{option['name']}",
                    option=f"{stage['id']}.{option['name']}",
                    label=f"{title}: {option['name'].replace('_', ' ')}{unit}",
                    help=option["help"] + (f" Empty: {word}." if word else ""),
                    kind=kind_of(option),
                    default=None if word or (number and default == "") else default,
                    optional=not is_input,
                    advanced=option["tier"] != "basic",
                    choices=option.get("choices", []),
                    low=option.get("min"),
                    high=option.get("max"),
                ))
    found.sort(key=lambda p: p.name != "INPUT")
    return found


def as_text(value):
    if isinstance(value, bool):
        return "true" if value else "false"
    return f"{value:.12g}" if isinstance(value, float) else str(value)


def command(program, document_path, form, values, folder):
    """The command that runs a document with the values that differ from the defaults. values: by parameter name."""
    arguments = [program, "run", document_path, "--out", folder]
    for p in form:
        value = values.get(p.name)
        if value is None or value == p.default or (value == "" and p.default in (None, "")):
            continue
        arguments += ["--set", f"{p.option}={as_text(value)}"]
    return arguments


def stage_ids(document):
    return [stage["id"] for stage in document["stages"]]
