"""Between numpy and VTK. Arrays that go out are views of Bole's own memory; what comes in is checked, and VTK copies it."""

import importlib

from . import _native
from ._errors import BadInput

# numpy's names of types that VTK has arrays for.
CLASSES = {
    "uint8": "vtkUnsignedCharArray", "int8": "vtkSignedCharArray", "uint16": "vtkUnsignedShortArray", "int16": "vtkShortArray", "uint32": "vtkUnsignedIntArray",
    "int32": "vtkIntArray", "uint64": "vtkUnsignedLongLongArray", "int64": "vtkLongLongArray", "float32": "vtkFloatArray", "float64": "vtkDoubleArray",
}
AXES = ("x", "y", "z")


def _vtk(name):
    module = "vtkCommonDataModel" if name in ("vtkPolyData", "vtkTable") else "vtkCommonCore"
    return getattr(importlib.import_module(f"vtkmodules.{module}"), name)


def view(array):
    """A VTK array as a numpy array: its own memory, read only. It keeps the memory alive. Texts are copied."""
    numpy = _native.numpy()
    if array.IsA("vtkStringArray"):
        return numpy.array([array.GetValue(i) for i in range(array.GetNumberOfValues())], dtype=object)
    components = array.GetNumberOfComponents()
    if array.GetNumberOfTuples() == 0:
        kind = next((name for name, vtk_class in CLASSES.items() if vtk_class == array.GetClassName()), "float64")
        empty = numpy.empty(0 if components == 1 else (0, components), dtype=kind)
        empty.flags.writeable = False
        return empty
    values = numpy.asarray(memoryview(array))
    values.flags.writeable = False
    return values


def _to_vtk(values, name, owners):
    """A VTK array over the memory of a numpy array, which `owners` keeps."""
    numpy = _native.numpy()
    if values.dtype == bool:
        values = values.astype("uint8")
    if values.dtype.kind == "f" and values.dtype.name not in CLASSES:
        values = values.astype("float64" if values.dtype.itemsize > 8 else "float32")
    values = numpy.ascontiguousarray(values, dtype=values.dtype.newbyteorder("="))
    array = _vtk(CLASSES[values.dtype.name])()
    array.SetName(name)
    array.SetNumberOfComponents(1 if values.ndim == 1 else values.shape[1])
    if values.size:
        owners.append(values)
        array.SetVoidArray(values, values.size, 1)
    return array


def _columns(value, what):
    """{name: numpy array} of a dict, a structured array or a data frame."""
    numpy = _native.numpy()
    if hasattr(value, "columns") and hasattr(value, "to_numpy"):
        return {str(name): value[name].to_numpy() for name in value.columns}
    if isinstance(value, dict):
        return {str(name): numpy.asarray(column) for name, column in value.items()}
    array = numpy.asarray(value)
    if array.dtype.names:
        return {name: array[name] for name in array.dtype.names}
    raise BadInput(
        f"{what} is an array of the type {array.dtype} and the shape {array.shape}; "
        "needed: columns with names (a dict of arrays, a structured array, a data frame)"
    )


def _positions(value, what):
    numpy = _native.numpy()
    array = numpy.asarray(value)
    if array.ndim != 2 or array.shape[1] != 3 or array.dtype.kind not in "fiu":
        raise BadInput(
            f"{what} is an array of the type {array.dtype} and the shape {array.shape}; needed: numbers in the shape (N, 3), in metres. "
            'Further columns have names: {"xyz": points, "intensity": values}'
        )
    return array if array.dtype.name in ("float32", "float64") else array.astype("float64")


def _is_frame(value):
    return hasattr(value, "columns") and hasattr(value, "to_numpy")


def cloud_to_vtk(value, what):
    """Points as vtkPolyData: of an (N, 3) array, of columns x, y, z (or xyz) and others, or of what is one already."""
    numpy = _native.numpy()
    if hasattr(value, "IsA"):
        return value
    if hasattr(value, "vtk") and hasattr(value, "offsets"):
        return value.vtk
    columns = {}
    if isinstance(value, dict) or _is_frame(value) or numpy.asarray(value).dtype.names:
        columns = _columns(value, what)
        if "xyz" in columns:
            positions = _positions(columns.pop("xyz"), f"{what}, xyz,")
        else:
            lower = {name.lower(): name for name in columns}
            missing = [axis for axis in AXES if axis not in lower]
            if missing:
                raise BadInput(f"{what} has the columns {', '.join(columns) or 'none'}; needed: x, y and z, or xyz in the shape (N, 3)")
            positions = _positions(numpy.column_stack([columns.pop(lower[axis]).astype("float64") for axis in AXES]), what)
    else:
        positions = _positions(value, what)
    owners = []
    points, cloud = _vtk("vtkPoints")(), _vtk("vtkPolyData")()
    points.SetData(_to_vtk(positions, "Points", owners))
    cloud.SetPoints(points)
    for name, column in columns.items():
        if column.ndim != 1 or len(column) != len(positions) or column.dtype.kind not in "fiub":
            raise BadInput(
                f"{what}: the column '{name}' has the type {column.dtype} and the shape {column.shape}; needed: {len(positions)} numbers, one for each point"
            )
        cloud.GetPointData().AddArray(_to_vtk(column, name, owners))
    cloud.bole_owners = owners
    return cloud


def table_to_vtk(value, what):
    """A vtkTable of a dict of columns, a structured array or a data frame."""
    if hasattr(value, "IsA"):
        return value
    owners, table, rows = [], _vtk("vtkTable")(), None
    for name, column in _columns(value, what).items():
        if column.ndim != 1 or (rows is not None and len(column) != rows):
            needed = "one value for each row" if rows is None else f"{rows} values, as the column before has"
            raise BadInput(f"{what}: the column '{name}' has the shape {column.shape}; needed: {needed}")
        rows = len(column)
        if column.dtype.kind in "fiub":
            table.AddColumn(_to_vtk(column, name, owners))
            continue
        texts = _vtk("vtkStringArray")()
        texts.SetName(name)
        for text in column:
            texts.InsertNextValue("" if text is None else str(text))
        table.AddColumn(texts)
    table.bole_owners = owners
    return table
