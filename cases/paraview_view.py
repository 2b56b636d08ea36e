"""Draws what fix output/vtk wrote, in ParaView: velocity as blue arrows, outlines black, contact-detection spheres red.

    pvpython cases/paraview_view.py FOLDER [TIME PICTURE.png]     draws one time (default: the last) into a picture
    paraview --script=cases/paraview_view.py                      shows the folder `post` of the working directory
"""

import sys
from pathlib import Path

from paraview import simple


def opened(folder, name):
    """The reader of one data set, or None when the run did not write it."""
    file = folder / f"{name}.pvd"
    return simple.PVDReader(registrationName=name, FileName=str(file)) if file.exists() else None


def one_colour(display, colour):
    display.ColorArrayName = ["POINTS", ""]
    display.AmbientColor = display.DiffuseColor = colour


def show_fields(fields, view):
    simple.Show(fields, view).SetRepresentationType("Outline")
    fields.UpdatePipeline(fields.TimestepValues[-1] if len(fields.TimestepValues) > 1 else 0.0)
    bounds = fields.GetDataInformation().GetBounds()
    fastest = fields.CellData["velocity"].GetRange(-1)[1]
    centres = simple.CellCenters(registrationName="cell centres", Input=fields)
    arrows = simple.Glyph(registrationName="velocity", Input=centres, GlyphType="2D Glyph")
    arrows.OrientationArray = ["POINTS", "velocity"]
    arrows.ScaleArray = ["POINTS", "velocity"]
    arrows.ScaleFactor = 0.1 * max(bounds[1] - bounds[0], bounds[3] - bounds[2]) / max(fastest, 1e-300)
    arrows.GlyphMode = "Every Nth Point"
    arrows.Stride = 7
    one_colour(simple.Show(arrows, view), [0.1, 0.3, 0.9])


def show_outlines(outlines, view):
    display = simple.Show(outlines, view)
    display.SetRepresentationType("Wireframe")
    display.LineWidth = 2.0
    one_colour(display, [0.0, 0.0, 0.0])


def show_spheres(spheres, view):
    circles = simple.Glyph(registrationName="contact-detection spheres", Input=spheres, GlyphType="2D Glyph")
    circles.GlyphType.GlyphType = "Circle"
    circles.OrientationArray = ["POINTS", "No orientation array"]
    circles.ScaleArray = ["POINTS", "radius"]
    circles.ScaleFactor = 2.0  # the circle that is scaled has radius 1/2
    circles.GlyphMode = "All Points"
    one_colour(simple.Show(circles, view), [0.9, 0.1, 0.1])


def show_all(folder):
    view = simple.GetActiveViewOrCreate("RenderView")
    view.InteractionMode = "2D"
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    found = [(opened(folder, name), show) for name, show in
             (("fields", show_fields), ("cds", show_spheres), ("outline", show_outlines))]
    if not any(reader for reader, _ in found):
        sys.exit(f"no fields.pvd, cds.pvd or outline.pvd in '{folder}': name the folder of fix output/vtk")
    for reader, show in found:
        if reader:
            show(reader, view)
    scene = simple.GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    scene.GoToLast()
    view.ResetCamera()
    return view


def main(words):
    view = show_all(Path(words[0] if words else "post"))
    if len(words) == 3:
        view.ViewTime = float(words[1])
    simple.Render(view)
    if len(words) == 3:
        simple.SaveScreenshot(words[2], view, ImageResolution=[1000, 1000])


main(sys.argv[1:])
