#!/bin/sh
# smoke.sh: whether installed packages work, on a machine without compiler and display.
set -e
cd "$(mktemp -d)"
fail() {
  echo "smoke.sh: $*" >&2
  exit 1
}
! command -v cc >/dev/null || fail "there is a compiler"

mote --version
mote render /usr/share/mote/data/hopper.dump.gz -o heap.png --size 320x240
[ "$(head -c 8 heap.png | od -An -tx1 | tr -d ' \n')" = 89504e470d0a1a0a ] || fail "heap.png is no PNG"
mote render /usr/share/mote/data/swirl.1.vtu -o swirl.png --size 320x240
for file in applications/mote.desktop icons/hicolor/scalable/apps/mote.svg mime/packages/mote.xml \
  bash-completion/completions/mote; do
  [ -s "/usr/share/$file" ] || fail "there is no /usr/share/$file"
done
if dpkg -s python3-mote >/dev/null 2>&1; then
  python3 - <<'PYTHON'
import numpy
import mote

points = numpy.random.default_rng(1).random((1000, 3))
image = mote.render(mote.particles(points, radius=0.02), size=(200, 150))
pixels = numpy.asarray(image)
assert pixels.shape[:2] == (150, 200) and pixels.std() > 5, pixels.shape
PYTHON
  python3 -m mote render pump:0.002 -o pump.png --size 200x150
fi
if dpkg -s paraview-mote >/dev/null 2>&1; then
  [ -n "$(find /usr/lib -path '*paraview*' -name 'Mote.so')" ] || fail "ParaView does not find the plugin"
fi
echo "smoke.sh: all is well"
