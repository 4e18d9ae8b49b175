"""What a run gives back."""

import collections.abc
import html
import pathlib

from . import _arrays, _native
from ._errors import NoSuchName, of_code


class Points(collections.abc.Mapping):
    """A cloud: coordinates, and a column for every array (docs/stages/arrays.md lists their names, units and meanings).

        points["height_above_ground"]   a view of Bole's memory, without a copy and read only
        points.offsets                  float32 offsets from points.origin, metres, (N, 3), without a copy
        points.xyz                      coordinates in metres, (N, 3): offsets where the origin is 0, else a new float64 array
        numpy.asarray(points)           the same
        points.to_pandas()              x, y, z and all columns as a data frame (a copy)

    What was read stays valid as long as an array of it is there. It can be given to another run as a cloud.
    """

    def __init__(self, vtk):
        self.vtk = vtk  # vtkPolyData
        data = vtk.GetPointData()
        self._names = [data.GetArrayName(i) for i in range(data.GetNumberOfArrays())]

    def _vector(self, name):
        array = self.vtk.GetFieldData().GetArray(name)
        return tuple(array.GetComponent(0, i) if array.GetNumberOfComponents() == 3 else array.GetValue(i) for i in range(3)) if array else (0.0, 0.0, 0.0)

    @property
    def count(self):
        return self.vtk.GetNumberOfPoints()

    @property
    def origin(self):
        """(x, y, z), metres: coordinates are origin + offsets."""
        return self._vector("origin")

    @property
    def axes(self):
        """sensor, map, plot (x to the east, y to the north of the plot centre), global or unknown."""
        array = self.vtk.GetFieldData().GetAbstractArray("axes")
        return array.GetValue(0) if array else "unknown"

    @property
    def crs(self):
        """The coordinate reference system of global coordinates as WKT, or an empty text."""
        array = self.vtk.GetFieldData().GetAbstractArray("crs")
        return array.GetValue(0) if array else ""

    @property
    def offsets(self):
        if not self.vtk.GetPoints():
            return _native.numpy().empty((0, 3), "float32")
        return _arrays.view(self.vtk.GetPoints().GetData()).reshape(-1, 3)

    @property
    def xyz(self):
        return self.offsets + _native.numpy().array(self.origin) if any(self.origin) else self.offsets

    def __array__(self, dtype=None, copy=None):
        values = self.xyz
        return values if dtype is None and not copy else _native.numpy().array(values, dtype=dtype)

    def __getitem__(self, name):
        if name not in self._names:
            from bole_campaign.errors import did_you_mean

            raise NoSuchName(f"there is no array '{name}'; needed: one of {', '.join(self._names)}. {did_you_mean(name, self._names)}".rstrip())
        return _arrays.view(self.vtk.GetPointData().GetArray(name))

    def __iter__(self):
        return iter(self._names)

    def __len__(self):
        return len(self._names)

    def to_pandas(self):
        import pandas

        x, y, z = self.xyz.T
        return pandas.DataFrame({"x": x, "y": y, "z": z, **self})

    def __repr__(self):
        return f"<Points: {self.count} points, axes {self.axes}, origin {self.origin}, arrays: {', '.join(self._names)}>"


class Raster:
    """A grid: `values` (rows from south to north, columns from west to east, NaN where nothing is known; a view without a copy),
    `x` and `y` of the columns and rows (cell centres, metres), `cell` (metres)."""

    def __init__(self, vtk):
        numpy = _native.numpy()
        self.vtk = vtk  # vtkImageData
        columns, rows, _ = vtk.GetDimensions()
        origin, spacing = vtk.GetOrigin(), vtk.GetSpacing()
        self.cell = spacing[0]
        self.x, self.y = origin[0] + spacing[0] * numpy.arange(columns), origin[1] + spacing[1] * numpy.arange(rows)
        array = vtk.GetPointData().GetArray(0)
        self.name = array.GetName() if array else ""
        self.values = _arrays.view(array).reshape(rows, columns) if array else numpy.empty((0, 0), "float32")

    def __repr__(self):
        return f"<Raster {self.name}: {self.values.shape[0]} x {self.values.shape[1]} cells of {self.cell:g} m>"


def table_of(vtk):
    """A pandas DataFrame, or a dict of numpy arrays where pandas is not installed."""
    columns = {vtk.GetColumnName(i): _arrays.view(vtk.GetColumn(i)) for i in range(vtk.GetNumberOfColumns())}
    try:
        import pandas
    except ImportError:
        return columns
    return pandas.DataFrame(columns)


def trajectory_of(vtk):
    """As table_of(): time_s, x_m, y_m, z_m, and the quaternion qw, qx, qy, qz."""
    columns = {}
    time, turn = (vtk.GetPointData().GetArray(name) for name in ("time", "orientation"))
    if time:
        columns["time_s"] = _arrays.view(time)
    if vtk.GetPoints():
        columns.update(zip(("x_m", "y_m", "z_m"), _arrays.view(vtk.GetPoints().GetData()).reshape(-1, 3).T))
    if turn:
        columns.update(zip(("qw", "qx", "qy", "qz"), _arrays.view(turn).reshape(-1, 4).T))
    try:
        import pandas
    except ImportError:
        return columns
    return pandas.DataFrame(columns)


MAKERS = {"table": table_of, "cloud": Points, "raster": Raster, "trajectory": trajectory_of}


class Outputs(collections.abc.Mapping):
    """Outputs of one kind by "stage.port"; a port alone means that of the last stage that has one. Read when asked for."""

    def __init__(self, result, kind):
        self._result, self._kind = result, kind
        self._places = [place for place, port_kind in result.outputs.items() if port_kind == kind]
        self._kept = {}

    def __getitem__(self, name):
        place = next((p for p in reversed(self._places) if p == name or p.split(".")[1] == name), None)
        if place is None:
            from bole_campaign.errors import did_you_mean

            near = did_you_mean(name, self._places)
            raise NoSuchName(f"this run has no {self._kind} '{name}'; needed: one of {', '.join(self._places) or 'none'}" + (f". {near}" if near else ""))
        if place not in self._kept:
            self._kept[place] = MAKERS[self._kind](self._result.vtk(place))
        return self._kept[place]

    def __iter__(self):
        return iter(self._places)

    def __len__(self):
        return len(self._places)

    def __repr__(self):
        return f"<{self._kind}: {', '.join(self._places) or 'none'}>"


class Result:
    """What a run gave.

    stems         the stems that the report shows: a pandas DataFrame (without pandas: a dict of numpy arrays), columns as in stems.csv,
                  but for `counted`: tables["tree_values"] has the trees that count
    points        the points after the last stage that hands them on: Points, views without a copy
    tables        all tables by "stage.port" or by port: result.tables["plot_values"]
    clouds        all clouds, rasters: all grids (terrain model), trajectories: all paths
    verdict       "sign", "look" or "refused"
    findings      what decides it: [{"code", "severity", "text", "stage"}], the worst first
    report        path of report.html, or None where no files were written
    folder        where the files are, or None; files: their paths
    summary       what summary.json has: counts, metrics, seconds and memory of every stage (dict)
    finished_early   whether the run was asked to finish early
    vtk(place)    the VTK object of an output, for VTK, PyVista or ParaView
    """

    def __init__(self, pipeline, summary, folder):
        from ._documents import declarations

        self._pipeline, self.summary = pipeline, summary
        self.folder = pathlib.Path(folder) if folder else None
        self.exit_code = summary["exit_code"]
        self.finished_early = self.exit_code == 4
        self.verdict, self.findings, self.seconds = summary["verdict"], summary["findings"], summary["seconds"]
        self.files = [self.folder / name for name in summary["files"]] if self.folder else []
        self.report = next((path for path in self.files if path.name == "report.html"), None)
        ran = [(stage["id"], stage["type"]) for stage in summary["stages"] if stage["state"] in ("done", "from_cache")]
        self.outputs = {f"{stage_id}.{port['name']}": port["kind"] for stage_id, stage_type in ran for port in declarations()[stage_type]["outputs"]}
        self.tables, self.clouds, self.rasters, self.trajectories = (Outputs(self, kind) for kind in ("table", "cloud", "raster", "trajectory"))

    def vtk(self, place):
        stage_id, _, port = place.partition(".")
        stage = self._pipeline.GetStage(stage_id)
        number = stage.FindOutputPort(port) if stage else -1
        if number < 0:
            raise NoSuchName(f"this run has no output '{place}'; needed: one of {', '.join(self.outputs)}")
        if stage.GetExitCode() != 0:  # what was stored of it cannot be read any more
            raise of_code(stage.GetExitCode(), stage.GetErrorText())
        return stage.GetOutputDataObject(number)

    @property
    def stems(self):
        return self.tables["stems"]

    @property
    def points(self):
        return self.clouds["points"]

    def _facts(self):
        facts = [("verdict", self.verdict), ("findings", str(sum(f["severity"] != "note" for f in self.findings)))]
        for stage in reversed(self.summary["stages"]):
            if stage["type"] == "stems.measure" and stage.get("message"):
                facts.append(("stems", stage["message"]))
                break
        facts.append(("time", f"{self.seconds:.1f} s"))
        if self.folder:
            facts.append(("results", str(self.folder)))
        return facts

    def __repr__(self):
        told = [f["text"] for f in self.findings if f["severity"] != "note"]
        return "\n".join([f"{name + ':':<10} {value}" for name, value in self._facts()] + [f"  {text}" for text in told])

    def _repr_html_(self):
        left = " style='text-align:left'"
        rows = "".join(f"<tr><th{left}>{html.escape(name)}</th><td{left}>{html.escape(value)}</td></tr>" for name, value in self._facts())
        items = "".join(f"<li>{html.escape(f['severity'])}: {html.escape(f['text'])}</li>" for f in self.findings if f["severity"] != "note")
        link = f"<p><a href='{html.escape(self.report.resolve().as_uri())}'>report.html</a></p>" if self.report else ""
        return f"<table>{rows}</table><ul>{items}</ul>{link}"
