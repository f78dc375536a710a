#!/usr/bin/env bash
# Runs the swirling flow in a pipe that widens, and writes its last times as .vtu files.
#   data/make-swirl.sh     swirl.0.vtu and swirl.1.vtu in the current folder, in a minute
# Needs OpenFOAM (Debian package openfoam, 1912) and VTK's Python package (python3-vtk9).
set -euo pipefail

for tool in blockMesh icoFoam checkMesh; do
  if ! command -v $tool >/dev/null; then
    echo "data/make-swirl.sh: $tool is missing; on Debian: apt-get install openfoam" >&2
    exit 1
  fi
done
# Debian's package keeps OpenFOAM's own settings here and does not say so.
export WM_PROJECT_DIR=${WM_PROJECT_DIR:-/usr/share/openfoam}
python=/usr/bin/python3
[[ -x $python ]] || python=python3
out=$PWD
case=$(mktemp -d)
trap 'rm -rf "$case"' EXIT
cd "$case"
mkdir 0 constant system

# dict FOLDER/FILE [CLASS]: a file of OpenFOAM with its header, from standard input.
dict() {
  {
    echo "FoamFile { version 2.0; format ascii; class ${2:-dictionary}; object ${1##*/}; }"
    cat
  } >"$1"
}

dict system/controlDict <<'END'
application icoFoam; startFrom startTime; startTime 0; stopAt endTime; endTime 8; deltaT 0.005;
writeControl timeStep; writeInterval 100; purgeWrite 2; writeFormat binary; writePrecision 8;
timePrecision 6;
END

dict system/fvSchemes <<'END'
ddtSchemes { default backward; }
gradSchemes { default Gauss linear; }
divSchemes { default none; div(phi,U) Gauss linearUpwind grad(U); }
laplacianSchemes { default Gauss linear corrected; }
interpolationSchemes { default linear; }
snGradSchemes { default corrected; }
END

dict system/fvSolution <<'END'
solvers
{
  p { solver PCG; preconditioner DIC; tolerance 1e-6; relTol 0.02; }
  pFinal { $p; relTol 0; }
  U { solver PBiCGStab; preconditioner DILU; tolerance 1e-7; relTol 0; }
}
PISO { nCorrectors 2; nNonOrthogonalCorrectors 1; }
END

dict constant/transportProperties <<'END'
nu 2.5e-6;
END

# Vertices: at each of three places along z a square around the axis, the small pipe's circle and
# the large one's, four corners each. Cells hold the axis, which no face or edge lies on.
blocks() {
  local corners=(0 1 2 3) rings=$1 from=$2 to=$3 n=$4 k next a b
  if ((rings == 0)); then
    echo "hex ($((from)) $((from + 1)) $((from + 2)) $((from + 3)) $((to)) $((to + 1)) $((to + 2)) $((to + 3)))" \
      "(7 7 $n) simpleGrading (1 1 $5)"
    return
  fi
  for k in "${corners[@]}"; do
    next=$(((k + 1) % 4))
    a=$((from + 4 * (rings - 1))) b=$((to + 4 * (rings - 1)))
    echo "hex ($((a + k)) $((a + 4 + k)) $((a + 4 + next)) $((a + next))" \
      "$((b + k)) $((b + 4 + k)) $((b + 4 + next)) $((b + next)))" \
      "(4 7 $n) simpleGrading ($([[ $rings == 1 ]] && echo 0.6 || echo 0.7) 1 $5)"
  done
}
{
  echo 'scale 0.01; vertices ('
  for z in -3 0 10; do
    for r in 0.6 1 2; do
      awk -v r="$r" -v z="$z" 'BEGIN { h = r * sqrt(0.5)
        printf "(%.9g %.9g %g) (%.9g %.9g %g) (%.9g %.9g %g) (%.9g %.9g %g)\n",
          -h, -h, z, h, -h, z, h, h, z, -h, h, z }'
    done
  done
  echo '); blocks ('
  blocks 0 0 12 9 0.5
  blocks 1 0 12 9 0.5
  for rings in 0 1 2; do blocks $rings 12 24 26 3; done
  echo '); edges ('
  for level in 0 12 24; do
    for ring in 1 2; do
      ((level > 0 || ring == 1)) || continue # the large pipe has not begun
      for k in 0 1 2 3; do
        awk -v a=$((level + 4 * ring + k)) -v b=$((level + 4 * ring + (k + 1) % 4)) -v k=$k \
          -v r=$ring -v z=$((level == 0 ? -3 : level == 12 ? 0 : 10)) 'BEGIN {
            x = k == 1 ? r : k == 3 ? -r : 0; y = k == 0 ? -r : k == 2 ? r : 0
            printf "arc %d %d (%d %d %d)\n", a, b, x, y, z }'
      done
    done
  done
  echo '); boundary ('
  echo 'inlet { type patch; faces ((0 1 2 3)'
  for k in 0 1 2 3; do echo "($k $((4 + k)) $((4 + (k + 1) % 4)) $(((k + 1) % 4)))"; done
  echo '); } outlet { type patch; faces ((24 25 26 27)'
  for ring in 0 1; do
    for k in 0 1 2 3; do
      a=$((24 + 4 * ring)) next=$(((k + 1) % 4))
      echo "($((a + k)) $((a + 4 + k)) $((a + 4 + next)) $((a + next)))"
    done
  done
  echo '); } ); defaultPatch { name walls; type wall; } mergePatchPairs ();'
} | dict system/blockMeshDict

dict 0/p volScalarField <<'END'
dimensions [0 2 -2 0 0 0 0]; internalField uniform 0;
boundaryField
{
  inlet { type zeroGradient; } walls { type zeroGradient; } outlet { type fixedValue; value uniform 0; }
}
END
dict 0/U volVectorField <<'END'
dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0);
boundaryField
{
  // 0.05 m/s through the small pipe, turning like a solid body, 0.07 m/s at its
  // wall, about a place beside the axis: what follows is not symmetric
  inlet { type swirlFlowRateInletVelocity; origin (5e-4 3e-4 0); axis (0 0 1); flowRate constant 1.5708e-5;
    rpm constant 66.8; value uniform (0 0 0.05); }
  walls { type noSlip; }
  outlet { type inletOutlet; inletValue uniform (0 0 0); value uniform (0 0 0); }
}
END

blockMesh >log.blockMesh || { tail -20 log.blockMesh >&2; exit 1; }
checkMesh >log.checkMesh || { tail -20 log.checkMesh >&2; exit 1; }
icoFoam >log.icoFoam || { tail -20 log.icoFoam >&2; exit 1; }
touch swirl.foam
"$python" - "$out" <<'END'
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid
from vtkmodules.vtkIOGeometry import vtkOpenFOAMReader
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter


def rounded(values):
    """Multiples of a power of two, about 1/2000 of each array's largest value: they pack well."""
    step = 2.0 ** (np.ceil(np.log2(np.abs(values).max())) - 11)
    return (np.round(values / step) * step).astype(np.float32)


reader = vtkOpenFOAMReader()
reader.SetFileName("swirl.foam")
reader.UpdateInformation()
times = [reader.GetTimeValues().GetValue(i) for i in range(reader.GetTimeValues().GetNumberOfTuples())]
for number, time in enumerate([t for t in times if t > 0][-2:]):
    reader.UpdateTimeStep(time)
    mesh = reader.GetOutput().GetBlock(0)
    grid = vtkUnstructuredGrid()
    grid.CopyStructure(mesh)
    for name in ("p", "U"):
        array = numpy_to_vtk(rounded(vtk_to_numpy(mesh.GetPointData().GetArray(name))), deep=True)
        array.SetName(name)
        grid.GetPointData().AddArray(array)
    stamp = numpy_to_vtk(np.array([time]), deep=True)
    stamp.SetName("TimeValue")
    grid.GetFieldData().AddArray(stamp)
    writer = vtkXMLUnstructuredGridWriter()
    writer.SetFileName(f"{sys.argv[1]}/swirl.{number}.vtu")
    writer.SetInputData(grid)
    writer.SetCompressionLevel(9)
    writer.SetHeaderTypeToUInt32()
    writer.EncodeAppendedDataOff()
    writer.Write()
    print(f"swirl.{number}.vtu: {grid.GetNumberOfCells()} cells at {time:g} s")
END
