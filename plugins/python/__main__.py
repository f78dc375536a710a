"""python3 -m mote ...: the program."""

import sys

from . import _program

sys.exit(_program.run(["mote"] + sys.argv[1:]))
