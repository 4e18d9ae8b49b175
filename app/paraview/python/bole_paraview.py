"""Pipelines of Bole as pipelines of ParaView, for pvbatch and the Python shell.

    import bole_paraview
    bole_paraview.load_plugin()
    stages = bole_paraview.open_document("stem_map_from_cloud", {"scan.file": "plot.laz"})
    bole_paraview.write(stages["edit"], "stems", "stems.csv")
"""

import json
import os
import pathlib

from paraview import servermanager, simple

_HERE = pathlib.Path(__file__).resolve().parent


def load_plugin(path=None):
    """Loads Bole's plugin on this process and its server. `path`: of Bole.so, where it lies elsewhere than in this build."""
    path = path or os.environ.get("BOLE_PARAVIEW_PLUGIN")
    if not path:
        raise RuntimeError("Where is Bole.so? Give load_plugin() its path, or set BOLE_PARAVIEW_PLUGIN")
    if servermanager.ActiveConnection.IsRemote():
        simple.LoadPlugin(str(path), remote=True)
    simple.LoadPlugin(str(path), remote=False)
    if not has_stage("io.read_cloud"):
        raise RuntimeError(f"{path} did not bring the stages of Bole")


def _group_and_name(stage_type):
    name = "Bole_" + stage_type.replace(".", "_")
    manager = servermanager.ProxyManager()
    for group in ("sources", "filters"):
        if manager.SMProxyManager.GetPrototypeProxy(group, name):
            return group, name
    return None, name


def has_stage(stage_type):
    """Whether the plugin has a stage, such as "stems.measure"."""
    return _group_and_name(stage_type)[0] is not None


def _new(group, name):
    return servermanager._getPyProxy(servermanager.ProxyManager().SMProxyManager.NewProxy(group, name))


def stage(stage_type, options=None, inputs=None, name=None):
    """A stage as a source or filter. options: by name, as in a document; inputs: {port: (proxy, "output port")}."""
    group, xml_name = _group_and_name(stage_type)
    if group is None:
        raise ValueError(f"the plugin has no stage {stage_type}")
    proxy = _new(group, xml_name)
    controller = servermanager.ParaViewPipelineController()
    controller.PreInitializeProxy(proxy)
    for port, (producer, output) in (inputs or {}).items():
        proxy.SetPropertyWithName(input_name(proxy, port), servermanager.OutputPort(producer, output_index(producer, output)))
    for option, value in (options or {}).items():
        set_option(proxy, option, value)
    controller.PostInitializeProxy(proxy)
    controller.RegisterPipelineProxy(proxy, name or stage_type)
    return proxy


def input_name(proxy, port):
    """The property of an input: the name of the port, with _input behind it where an option has that name."""
    prop = getattr(proxy, "SMProxy", proxy).GetProperty(port)
    return port if prop is not None and prop.IsA("vtkSMInputProperty") else port + "_input"


def output_index(proxy, name):
    """The number of an output port from its name."""
    names = [proxy.SMProxy.GetOutputPortName(i) for i in range(proxy.SMProxy.GetNumberOfOutputPorts())]
    if name not in names:
        raise ValueError(f"there is no output '{name}', but {', '.join(names)}")
    return names.index(name)


def set_option(proxy, name, value):
    """Sets an option by its name in Bole, with a value as documents have it."""
    prop = proxy.SMProxy.GetProperty(name)
    if prop is None:
        raise ValueError(f"{proxy.SMProxy.GetXMLName()} has no option '{name}'")
    kind = prop.GetClassName()
    if "String" in kind:
        if isinstance(value, bool):
            value = "true" if value else "false"
        value = str(value)
    elif "Int" in kind:
        value = int({"true": 1, "false": 0}.get(value, value))
    else:
        value = float(value)
    proxy.SetPropertyWithName(name, value)


def _is_optional(prop):
    hints = prop.GetHints()
    return hints is not None and hints.FindNestedElementByName("Optional") is not None


def _missing_inputs(stage_type, given):
    group, name = _group_and_name(stage_type)
    prototype = servermanager.ProxyManager().SMProxyManager.GetPrototypeProxy(group, name)
    missing = []
    given = {input_name(prototype, port) for port in given}
    iterator = prototype.NewPropertyIterator()
    iterator.Begin()
    while not iterator.IsAtEnd():
        prop = iterator.GetProperty()
        if prop.IsA("vtkSMInputProperty") and iterator.GetKey() not in given and not _is_optional(prop):
            missing.append(iterator.GetKey())
        iterator.Next()
    return missing


def find_document(path_or_name):
    """A path, or the name of a pipeline that comes with Bole."""
    path = pathlib.Path(path_or_name)
    if path.is_file():
        return path
    for folder in (_HERE.parents[2] / "pipelines", _HERE.parent / "pipelines"):
        if (folder / f"{path_or_name}.json").is_file():
            return folder / f"{path_or_name}.json"
    raise FileNotFoundError(f"there is no pipeline '{path_or_name}'")


def open_document(path_or_name, settings=None):
    """The stages of a document as proxies, joined as the document says: {id: proxy}. settings: {"stage.option": value}.

    Left out, as `bole run` would: optional readers without a file. Left out too: stages that the plugin does not have
    (the reports), and those whose inputs are missing then.
    """
    document = json.loads(pathlib.Path(find_document(path_or_name)).read_text(encoding="utf-8"))
    values = {entry["id"]: dict(entry.get("options", {})) for entry in document["stages"]}
    for setting, value in (settings or {}).items():
        stage_id, option = setting.split(".", 1)
        values[stage_id][option] = value
    proxies = {}
    for entry in document["stages"]:
        options = values[entry["id"]]
        if not has_stage(entry["type"]) or (entry.get("optional") and not options):
            continue
        inputs = {}
        for port, source in entry.get("inputs", {}).items():
            producer, output = source.split(".", 1)
            if producer in proxies:
                inputs[port] = (proxies[producer], output)
        if not _missing_inputs(entry["type"], inputs):
            proxies[entry["id"]] = stage(entry["type"], options, inputs, entry["id"])
    return proxies


def write(proxy, output, path):
    """Writes an output as `bole run` would: a table as CSV, points as LAS, LAZ, COPC or PLY, a trajectory as TUM."""
    is_table = proxy.SMProxy.GetDataInformation(output_index(proxy, output)).GetDataSetType() == servermanager.vtk.VTK_TABLE
    writer = _new("writers", "Bole_table_writer" if is_table else "Bole_cloud_writer")
    writer.SetPropertyWithName("Input", servermanager.OutputPort(proxy, output_index(proxy, output)))
    writer.SetPropertyWithName("FileName", str(path))
    writer.UpdatePipeline()


def error(proxy):
    """Why a stage failed when it ran last; empty where it did not."""
    proxy.UpdatePropertyInformation()
    return proxy.SMProxy.GetProperty("Error").GetElement(0)


def report(proxy):
    """Counts, measures and findings of a stage that has run."""
    proxy.UpdatePropertyInformation()
    return json.loads(proxy.SMProxy.GetProperty("Report").GetElement(0) or "{}")
