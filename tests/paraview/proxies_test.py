"""Every stage is a source or filter whose ports, options, defaults, units, help and tiers are those of `bole stages`."""

import json
import pathlib
import subprocess

import bole_paraview
import paraview_test as t
from paraview import servermanager


def default_of(prop):
    values = [prop.GetElement(i) for i in range(prop.GetNumberOfElements())]
    return values[0] if values else None


def words_of(prop, domain):
    found = prop.GetDomain(domain)
    return [found.GetString(i) for i in range(found.GetNumberOfStrings())] if found else None


def same_value(found, option):
    expected = option["default"]
    if isinstance(expected, bool):
        return found == int(expected)
    if isinstance(expected, (int, float)):
        return found is not None and float(found) == float(expected)
    return found == expected


def check_option(stage, proxy, option):
    where = f"{stage['type']}.{option['name']}"
    prop = proxy.SMProxy.GetProperty(option["name"])
    t.check(prop is not None, f"{where}: there is no such property")
    if prop is None:
        return
    t.check(same_value(default_of(prop), option), f"{where}: default {default_of(prop)!r}, expected {option['default']!r}")
    if option.get("unit"):
        t.check(f"({option['unit']})" in prop.GetXMLLabel(), f"{where}: the label '{prop.GetXMLLabel()}' lacks the unit {option['unit']}")
    expected = "default" if option["tier"] == "basic" else "advanced"
    t.equal(prop.GetPanelVisibility(), expected, f"{where}: panel visibility")
    text = prop.GetDocumentation().GetDescription() if prop.GetDocumentation() else ""
    t.check(" ".join(option["help"].split()) in " ".join(text.split()), f"{where}: help is '{text}'")
    if option["type"] == "choice":
        t.equal(words_of(prop, "choices"), option["choices"], f"{where}: choices")
    if option["type"] == "number" and "min" in option and prop.GetDomain("range"):
        t.equal(prop.GetDomain("range").GetMinimum(0, servermanager.vtk.mutable(0)), option["min"], f"{where}: minimum")


def test(stages_file, program):
    stages = json.loads(pathlib.Path(stages_file).read_text(encoding="utf-8"))
    options = 0
    for stage in stages:
        group, name = bole_paraview._group_and_name(stage["type"])
        t.equal(group, "filters" if stage["inputs"] else "sources", f"{stage['type']}: group")
        if group is None:
            continue
        proxy = bole_paraview._new(group, name)
        proxy.UpdateVTKObjects()
        names = [proxy.SMProxy.GetOutputPortName(i) for i in range(proxy.SMProxy.GetNumberOfOutputPorts())]
        t.equal(names, [port["name"] for port in stage["outputs"]], f"{stage['type']}: outputs")
        for port in stage["inputs"]:
            prop = proxy.SMProxy.GetProperty(bole_paraview.input_name(proxy, port["name"]))
            t.check(prop is not None and prop.IsA("vtkSMInputProperty"), f"{stage['type']}: no input {port['name']}")
        for option in stage["options"]:
            check_option(stage, proxy, option)
            options += 1
        t.equal(proxy.SMProxy.GetVTKClassName(), stage["vtk_class"], f"{stage['type']}: class")
    print(f"{len(stages)} stages, {options} options")
    t.check(len(stages) > 40, "too few stages")

    # The command line program has the same stages, and those that write reports.
    if pathlib.Path(program).is_file():
        text = subprocess.run([program, "stages", "--json"], check=True, capture_output=True, text=True).stdout
        ours = {stage["type"]: stage for stage in stages}
        for stage in json.loads(text):
            if not stage["type"].startswith("report."):
                t.check(ours.get(stage["type"]) == stage, f"{stage['type']} is another one in {program}")
    else:
        print(f"not compared with {program}, which is not there")


t.run(test)
