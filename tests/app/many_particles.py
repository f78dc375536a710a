"""many_particles.py FILE [SIDE]: SIDE^3 particles (200^3: eight million) in a cube as .vtp, in the
order of a simulation."""

import array, struct, sys
side = int(sys.argv[2]) if len(sys.argv) > 2 else 200
n = side ** 3
row = array.array("f", [0.0] * (3 * side))
row[0::3] = array.array("f", range(side))
with open(sys.argv[1], "wb") as f:
    f.write(f'''<?xml version="1.0"?>
<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64"><PolyData>
<Piece NumberOfPoints="{n}" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="0">
<PointData><DataArray type="Float32" Name="height" format="appended" offset="{8 + 12 * n}"/></PointData>
<Points><DataArray type="Float32" NumberOfComponents="3" Name="Points" format="appended" offset="0"/></Points>
</Piece></PolyData><AppendedData encoding="raw">_'''.encode())
    f.write(struct.pack("<Q", 12 * n))
    for z in range(side):
        row[2::3] = array.array("f", [z] * side)
        for y in range(side):
            row[1::3] = array.array("f", [y] * side)
            row.tofile(f)
    f.write(struct.pack("<Q", 4 * n))
    for z in range(side):
        array.array("f", [z] * (side * side)).tofile(f)
    f.write(b"</AppendedData></VTKFile>")
