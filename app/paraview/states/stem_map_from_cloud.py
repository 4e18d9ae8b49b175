"""A stem map of a point cloud in ParaView: the shipped pipeline stem_map_from_cloud as sources and filters.

    pvbatch stem_map_from_cloud.py plot.laz [picture.png [stems.csv]]

In ParaView's window: Tools > Python Shell > Run Script, after `import sys; sys.argv = ["", "plot.laz"]`. The points are coloured by
their tree, the terrain lies below, and a red band marks breast height of each stem that was measured. Needs BOLE_PARAVIEW_PLUGIN (the path of
Bole.so) and this repository's app/paraview/python on PYTHONPATH.
"""

import colorsys
import sys

import bole_paraview
from paraview import simple

BREAST_HEIGHT_M = 1.3


def show_terrain(stages, view):
    terrain = simple.OutputPort(stages["ground"], bole_paraview.output_index(stages["ground"], "dem"))
    raised = simple.WarpByScalar(Input=terrain, Scalars=["POINTS", "elevation_m"])
    shown = simple.Show(raised, view)
    shown.Representation = "Surface"
    shown.ColorArrayName = ["POINTS", ""]
    shown.AmbientColor = shown.DiffuseColor = [0.72, 0.66, 0.55]


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
    trees = range(int(first), int(last) + 1)
    colours.Annotations = [str(word) for tree in trees for word in (tree, tree)]
    # 0 is no tree; neighbours in number get colours far apart.
    colours.IndexedColors = [part for tree in trees for part in ((0.6, 0.6, 0.6) if tree <= 0 else colorsys.hsv_to_rgb(tree * 0.382 % 1, 0.8, 0.75))]
    shown.SetScalarBarVisibility(view, False)


def show_stems(stages, view):
    """The stems as red bands at breast height, drawn wider than they are so that the points do not hide them."""
    table = simple.OutputPort(stages["edit"], bole_paraview.output_index(stages["edit"], "stems"))
    in_metres = simple.Calculator(Input=simple.TableToPoints(Input=table, XColumn="x_m", YColumn="y_m", ZColumn="z_m"))
    in_metres.ResultArrayName = "dbh_m"
    in_metres.Function = "dbh_cm / 100"
    raised = simple.Transform(Input=in_metres)
    raised.Transform.Translate = [0, 0, BREAST_HEIGHT_M]  # z_m is the ground
    discs = simple.Glyph(Input=raised, GlyphType="Cylinder")
    discs.GlyphType.Radius = 0.5
    discs.GlyphType.Height = 0.8
    discs.GlyphTransform.Rotate = [90, 0, 0]  # upright
    discs.ScaleArray = ["POINTS", "dbh_m"]
    discs.ScaleFactor = 1.3
    discs.GlyphMode = "All Points"
    shown = simple.Show(discs, view)
    shown.ColorArrayName = ["POINTS", ""]
    shown.AmbientColor = shown.DiffuseColor = [0.9, 0.1, 0.1]


def main(cloud, picture=None, table=None):
    bole_paraview.load_plugin()
    stages = bole_paraview.open_document("stem_map_from_cloud", {"scan.file": cloud})
    view = simple.GetActiveViewOrCreate("RenderView")
    view.ViewSize = [1000, 1000]
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
