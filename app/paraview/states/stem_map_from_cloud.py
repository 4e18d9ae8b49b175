"""A stem map of a point cloud in ParaView: the shipped pipeline stem_map_from_cloud as sources and filters.

    pvbatch stem_map_from_cloud.py plot.laz [picture.png [stems.csv]]

In ParaView's window: Tools > Python Shell > Run Script, after `import sys; sys.argv = ["", "plot.laz"]`. The points are coloured by
their tree, and a disc of the measured diameter stands at breast height of each stem. Needs BOLE_PARAVIEW_PLUGIN (the path of
Bole.so) and this repository's app/paraview/python on PYTHONPATH.
"""

import sys

import bole_paraview
from paraview import simple


def show_terrain(stages, view):
    terrain = simple.OutputPort(stages["ground"], bole_paraview.output_index(stages["ground"], "dem"))
    raised = simple.WarpByScalar(Input=terrain, Scalars=["POINTS", "elevation"])
    shown = simple.Show(raised, view)
    shown.ColorArrayName = ["POINTS", ""]
    shown.DiffuseColor = [0.62, 0.58, 0.5]


def show_points(stages, view):
    index = bole_paraview.output_index(stages["edit"], "points")
    points = simple.OutputPort(stages["edit"], index)
    shown = simple.Show(points, view)
    shown.Representation = "Points"
    shown.PointSize = 1.5
    simple.ColorBy(shown, ("POINTS", "tree_id"))
    first, last = stages["edit"][index].PointData["tree_id"].GetRange()
    colours = simple.GetColorTransferFunction("tree_id")
    colours.InterpretValuesAsCategories = 1
    colours.Annotations = [str(i) for tree in range(int(first), int(last) + 1) for i in (tree, tree)]
    colours.ApplyPreset("KAAMS", True)
    shown.SetScalarBarVisibility(view, False)


def show_stems(stages, view):
    """The stems as discs of their diameter, at breast height."""
    table = simple.OutputPort(stages["edit"], bole_paraview.output_index(stages["edit"], "stems"))
    in_metres = simple.Calculator(Input=simple.TableToPoints(Input=table, XColumn="x_m", YColumn="y_m", ZColumn="z_m"))
    in_metres.ResultArrayName = "dbh_m"
    in_metres.Function = "dbh_cm / 100"
    discs = simple.Glyph(Input=in_metres, GlyphType="Cylinder")
    discs.GlyphType.Radius = 0.5
    discs.GlyphType.Height = 0.3
    discs.GlyphTransform.Rotate = [90, 0, 0]  # upright
    discs.ScaleArray = ["POINTS", "dbh_m"]
    discs.ScaleFactor = 1.0
    discs.GlyphMode = "All Points"
    shown = simple.Show(discs, view)
    shown.ColorArrayName = ["POINTS", ""]
    shown.DiffuseColor = [0.85, 0.1, 0.1]


def main(cloud, picture=None, table=None):
    bole_paraview.load_plugin()
    stages = bole_paraview.open_document("stem_map_from_cloud", {"scan.file": cloud})
    view = simple.CreateRenderView()
    view.ViewSize = [1400, 900]
    view.Background = [1, 1, 1]
    view.UseColorPaletteForBackground = 0
    view.OrientationAxesLabelColor = [0, 0, 0]
    stages["edit"].UpdatePipeline()
    show_terrain(stages, view)
    show_points(stages, view)
    show_stems(stages, view)
    simple.SetActiveView(view)
    simple.ResetCamera(view)
    view.ResetActiveCameraToDirection(0.5, 0.8, -0.35, 0, 0, 1)
    view.ResetCamera(True)
    simple.GetActiveCamera().Dolly(1.1)
    if picture:
        simple.SaveScreenshot(picture, view)
    if table:
        bole_paraview.write(stages["georeference"], "stems", table)


main(*sys.argv[1:])
