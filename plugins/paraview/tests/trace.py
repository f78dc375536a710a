"""What ParaView's trace records of Mote's representations is a script that draws the same."""

import os
import tempfile

import numpy as np
from checks import check, covered, end, picture, simple, view_of
from paraview import smtrace

data = os.path.join(os.environ["MOTE_DATA"], "copper-scratch.dump.gz")


def change(proxy, **properties):
    """As the panel of properties does, which tells the trace of it."""
    item = smtrace._create_trace_item_internal("PropertiesModified", kwargs={"proxy": proxy})
    for name, value in properties.items():
        setattr(proxy, name, value)
    item.finalize()


smtrace.start_trace()
dump = simple.OpenDataFile(data)
view = simple.CreateView("MoteRenderView")
view.ViewSize = [300, 300]
display = simple.Show(dump, view)
simple.ColorBy(display, ("POINTS", "c_centro"))
display.RescaleTransferFunctionToDataRange(True, False)
change(display, MoteRadiusScale=0.8)
change(view, MoteShadows=1, MoteLightSize=3.0)
simple.ResetCamera(view)
simple.Render(view)
script = smtrace.stop_trace()
for words in ("MoteRadiusScale = 0.8", "MoteShadows = 1", "MoteRenderView"):
    check(words in script, f"the trace has {words}")
first = picture(view)
check(covered(first) > 0.05, "there is a picture")
name = os.path.join(tempfile.mkdtemp(), "trace.py")
with open(name, "w") as file:
    file.write(script)
for view in simple.GetViews():
    simple.Delete(view)
for source in list(simple.GetSources().values()):
    simple.Delete(source)
with open(name) as file:
    exec(compile(file.read(), name, "exec"), {"__name__": "traced"})
view = simple.GetViews()[0]
view.ViewSize = [300, 300]  # which traces leave to the window
again = picture(view)
check(again.shape == first.shape and np.abs(again - first).max() <= 2, "the trace draws the same")
end()
