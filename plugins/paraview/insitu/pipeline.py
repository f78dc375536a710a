# script-version: 2.0
"""What Catalyst makes of a simulation's points: a picture of spheres each 100 steps, by Mote."""

import os

from paraview import catalyst, simple

simple._DisableFirstRenderCameraReset()
simple.LoadPlugin(os.environ["MOTE_PLUGIN"], remote=False, ns=vars(simple))

balls = simple.TrivialProducer(registrationName="input")
view = simple.CreateView("MoteRenderView")
view.ViewSize = [640, 480]
view.UseColorPaletteForBackground = 0
view.Background = [0.2, 0.22, 0.25]
view.OrientationAxesVisibility = 0
view.MoteSamples = 4
view.MoteShadows = 1
view.CameraPosition = [5.0, -6.6, 4.0]
view.CameraFocalPoint = [0.5, 0.5, 1.2]
view.CameraViewUp = [0, 0, 1]

display = simple.Show(balls, view)
display.SetRepresentationType("Mote Particles")
simple.ColorBy(display, ("POINTS", "speed"))
colors = simple.GetColorTransferFunction("speed")
colors.RescaleTransferFunction(0.0, 5.0)
display.SetScalarBarVisibility(view, True)

pictures = simple.CreateExtractor("PNG", view, registrationName="pictures")
pictures.Trigger.Frequency = 100
pictures.Writer.FileName = "balls_{timestep:06d}{camera}.png"
pictures.Writer.ImageResolution = [640, 480]

options = catalyst.Options()
options.ExtractsOutputDirectory = os.environ.get("INSITU_FOLDER", "insitu")
options.GlobalTrigger.Frequency = 1
