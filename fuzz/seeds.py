#!/usr/bin/env python3
"""Writes small files of a format, for libFuzzer to begin with.

    fuzz/seeds.py FORMAT FOLDER
"""

import base64
import gzip
import json
import pathlib
import struct
import sys
import zlib

dump = """ITEM: TIMESTEP
{step}
ITEM: NUMBER OF ATOMS
3
ITEM: BOX BOUNDS {box}
{bounds}
ITEM: ATOMS {columns}
{rows}
"""
plain = dict(step=0, box="pp pp ff", bounds="0 2\n-1 1\n0 3", columns="id type x y z radius",
             rows="1 1 0 0 0 0.5\n2 2 1.5 -0.5 1e0 0.25\n3 1 nan inf -1 .5")
scaled = dict(step=100, box="xy xz yz pp pp pp", bounds="0 2 0.5\n0 2 0\n0 2 -0.5",
              columns="id element xs ys zs ix iy iz q", rows="7 Cu 0 0 0 0 0 0 1\n"
              "8 Zr 0.5 0.5 0.5 -1 0 2 -2.5e-3\n9 Cu 1 1 1 0 0 0 12345678901234567890")
pdb_atom = "ATOM  {n:5d}  CA  ALA A{n:4d}    {x:8.3f}{x:8.3f}{x:8.3f}  1.00 10.00           C"

vtk_xml = """<VTKFile type="{type}" version="1.0" byte_order="LittleEndian" header_type="UInt32">
<{type}{extent}><Piece {piece}>
{body}
</Piece></{type}>
{appended}</VTKFile>
"""


def array(name, values, type="Float32", components=1):
    return (f'<DataArray type="{type}" Name="{name}" NumberOfComponents="{components}" '
            f'format="ascii">{values}</DataArray>')


def packed(name, numbers, type="Float32", code="f", components=1):
    raw = struct.pack(f"<{len(numbers)}{code}", *numbers)
    coded = base64.b64encode(struct.pack("<I", len(raw)) + raw).decode()
    return (f'<DataArray type="{type}" Name="{name}" NumberOfComponents="{components}" '
            f'format="binary">{coded}</DataArray>')


def lammps_data(sections):
    return ("LAMMPS data file, timestep = 5, units = metal\n\n2 atoms\n2 atom types\n0 9 xlo xhi\n"
            "0 9 ylo yhi\n0 9 zlo zhi\n1 0 0 xy xz yz\n\nMasses\n\n1 28\n2 16\n\n" + sections)


corners = "0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1"
numbered = "0 1 2 3 4 5 6 7"
hexahedron = vtk_xml.format(
    type="UnstructuredGrid", extent="", piece='NumberOfPoints="8" NumberOfCells="1"', appended="",
    body="<PointData>" + array("p", numbered) + "</PointData><Points>" +
    array("Points", corners, components=3) + "</Points><Cells>" +
    array("connectivity", numbered, "Int64") + array("offsets", "8", "Int64") +
    array("types", "12", "UInt8") + "</Cells>")
tetrahedron = "0 0 0 2 0 0 0 2 0 0 0 2 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 0 1 1"
quadratic = vtk_xml.format(
    type="UnstructuredGrid", extent="", piece='NumberOfPoints="10" NumberOfCells="2"', appended="",
    body="<PointData>" + array("p", "0 1 2 3 4 5 6 7 8 9") + "</PointData>"
    '<CellData HigherOrderDegrees="d">' + array("d", "0 0 0 2 2 2", components=3) + "</CellData><Points>" +
    array("Points", tetrahedron, components=3) + "</Points><Cells>" +
    array("connectivity", "0 1 2 3 4 5 6 7 8 9 0 1 2 3 4 5 6 7 8 9", "Int64") + array("offsets", "10 20", "Int64") +
    array("types", "24 71", "UInt8") + "</Cells>")
triangles = vtk_xml.format(
    type="PolyData", extent="", piece='NumberOfPoints="8" NumberOfPolys="2"', appended="",
    body="<CellData>" + packed("c", [1, 2]) + "</CellData><Points>" +
    packed("Points", [float(n) for n in corners.split()], components=3) + "</Points><Polys>" +
    array("connectivity", "0 1 2 5 6 7", "Int64") + array("offsets", "3 6", "Int64") + "</Polys>")
image = vtk_xml.format(
    type="ImageData", extent=' WholeExtent="0 1 0 1 0 1" Origin="0 0 0" Spacing="1 1 1"',
    piece='Extent="0 1 0 1 0 1"', body='<PointData><DataArray type="Float64" Name="p" '
    'format="appended" offset="0"/></PointData>',
    appended='<AppendedData encoding="base64">_' +
    base64.b64encode(struct.pack("<I8d", 64, *range(8))).decode() + "</AppendedData>\n")
def zipped(name, values, type="Float32", components=1):
    code = {"Float32": "f", "Int64": "q", "UInt8": "B"}[type]
    raw = struct.pack(f"<{len(values)}{code}", *values)
    data = zlib.compress(raw)
    head = struct.pack("<4I", 1, 32768, len(raw), len(data))
    return (f'<DataArray type="{type}" Name="{name}" NumberOfComponents="{components}" format="binary">' +
            base64.b64encode(head).decode() + base64.b64encode(data).decode() + "</DataArray>")


def with_zlib(text):
    return text.replace("header_type", 'compressor="vtkZLibDataCompressor" header_type')


sides = "6 4 0 3 2 1 4 4 5 6 7 4 0 1 5 4 4 1 2 6 5 4 2 3 7 6 4 3 0 4 7"
polyhedron = with_zlib(vtk_xml.format(
    type="UnstructuredGrid", extent="", piece='NumberOfPoints="8" NumberOfCells="1"', appended="",
    body="<Points>" + zipped("Points", [float(n) for n in corners.split()], components=3) +
    "</Points><Cells>" + zipped("connectivity", range(8), "Int64") + zipped("offsets", [8], "Int64") +
    zipped("types", [42], "UInt8") + zipped("faces", [int(n) for n in sides.split()], "Int64") +
    zipped("faceoffsets", [31], "Int64") + "</Cells>"))
all_kinds = with_zlib(vtk_xml.format(
    type="PolyData", extent="", piece='NumberOfPoints="8" NumberOfVerts="1" NumberOfLines="1" '
    'NumberOfStrips="1" NumberOfPolys="1"', appended="",
    body="<Points>" + zipped("Points", [float(n) for n in corners.split()], components=3) + "</Points>" +
    "".join(f"<{kind}>" + zipped("connectivity", cell, "Int64") + zipped("offsets", [len(cell)], "Int64") +
            f"</{kind}>" for kind, cell in (("Verts", [0]), ("Lines", [0, 1, 2]), ("Strips", [0, 1, 2, 3]),
                                            ("Polys", [4, 5, 6, 7])))))
image_steps = vtk_xml.format(
    type="ImageData", extent=' TimeValues="0 1" WholeExtent="0 1 0 1 0 1" Origin="0 0 0" Spacing="1 1 1"',
    piece='Extent="0 1 0 1 0 1"', appended="",
    body="".join(f"<{kind}>" + "".join(
        array(name, values, "Int16").replace(" Name", f' TimeStep="{step}" Name')
        for step in (0, 1)) + f"</{kind}>"
        for kind, name, values in (("PointData", "p", numbered), ("CellData", "c", "1"))))
boxed = ' WholeExtent="0 1 0 1 0 1"'
structured = vtk_xml.format(
    type="StructuredGrid", extent=boxed, piece='Extent="0 1 0 1 0 1"', appended="",
    body="<PointData>" + array("p", numbered) + "</PointData><Points>" + array("Points", corners, components=3) +
    "</Points>")
rectilinear = with_zlib(vtk_xml.format(
    type="RectilinearGrid", extent=boxed, piece='Extent="0 1 0 1 0 1"', appended="",
    body="<CellData>" + zipped("c", [1], "UInt8") + "</CellData><Coordinates>" + array("x", "0 1") +
    zipped("y", [0.0, 1.0]) + array("z", "0 2") + "</Coordinates>"))
legacy = "# vtk DataFile Version 3.0\na test\n{format}\nDATASET {rest}"
facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
gltf = {
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0, "translation": [1, 0, 0]}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "mode": 4}]}],
    "accessors": [
        {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0],
         "max": [1, 1, 0]},
        {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}],
    "bufferViews": [{"buffer": 0, "byteLength": 36},
                    {"buffer": 0, "byteOffset": 36, "byteLength": 6}],
    "buffers": [{"byteLength": 42, "uri": "data:application/octet-stream;base64," +
                 base64.b64encode(struct.pack("<9f3H", 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 2)).decode()}],
}

def moving_gltf():
    """With a skin, animations, morph targets, colours and lines."""
    def floats(*values):
        return struct.pack(f"<{len(values)}f", *values)
    one = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
    kinds = [  # what is in a view, its type, its kind of numbers, how many
        (floats(0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0), "VEC3", 5126, 4),
        (floats(*[1, 0, 0, 1] * 4), "VEC4", 5126, 4), (struct.pack("<6H", 0, 1, 2, 1, 3, 2), "SCALAR", 5123, 6),
        (bytes([0, 1, 0, 0] * 4), "VEC4", 5121, 4), (floats(*[0.5, 0.5, 0, 0] * 4), "VEC4", 5126, 4),
        (floats(*one * 2), "MAT4", 5126, 2), (floats(0, 1), "SCALAR", 5126, 2),
        (floats(0, 0, 0, 1, 1, 1), "VEC3", 5126, 2), (floats(*[0, 0, 0.1] * 4), "VEC3", 5126, 4)]
    places, data = [], b""
    for values, *_ in kinds:
        places.append(len(data))
        data += values
    skinned = {"attributes": {"POSITION": 0, "COLOR_0": 1, "JOINTS_0": 3, "WEIGHTS_0": 4}, "indices": 2,
               "targets": [{"POSITION": 8}]}
    return {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 3]}],
        "nodes": [{"mesh": 0, "skin": 0, "children": [1, 2]}, {"rotation": [0, 0, 0, 1]},
                  {"translation": [0, 1, 0]}, {"mesh": 1}],
        "meshes": [{"weights": [0.5], "primitives": [skinned]},
                   {"primitives": [{"attributes": {"POSITION": 0}, "mode": mode} for mode in (0, 1, 5)]}],
        "skins": [{"joints": [1, 2], "inverseBindMatrices": 5}],
        "animations": [{"channels": [{"sampler": 0, "target": {"node": 2, "path": "translation"}}],
                        "samplers": [{"input": 6, "output": 7, "interpolation": "LINEAR"}]}],
        "accessors": [{"bufferView": i, "componentType": number, "count": count, "type": kind}
                      for i, (_, kind, number, count) in enumerate(kinds)],
        "bufferViews": [{"buffer": 0, "byteOffset": place, "byteLength": len(values)}
                        for place, (values, *_) in zip(places, kinds)],
        "buffers": [{"byteLength": len(data), "uri": "data:application/octet-stream;base64," +
                     base64.b64encode(data).decode()}],
    }


def record(data):
    length = struct.pack("<I", len(data))
    return length + data + length


gadget = record(
    struct.pack("<6I6d2d10Id", 2, 0, 0, 0, 1, 0, 0, 0, 0, 0, 7.5, 0, 0.25, 0, 0, 0, 2, 0, 0, 0, 1, 0,
                0, 1, 100).ljust(256, b"\0"))
gadget += b"".join(
    record(struct.pack(f"<{len(values)}{code}", *values))
    for code, values in [("f", range(9)), ("f", range(9)), ("I", [1, 2, 3]), ("f", [0.5, 1.5]),
                         ("f", [20, 30]), ("f", [2, 3])])


def houdini_attribute(name, kind, components, rest):
    return struct.pack(">H", len(name)) + name + struct.pack(">Hi", components, kind) + rest


bgeo = (b"BgeoV" + struct.pack(">9i", 5, 2, 1, 0, 0, 3, 0, 0, 0) +
        houdini_attribute(b"v", 5, 3, struct.pack(">3f", 0, 0, 0)) +
        houdini_attribute(b"id", 1, 1, struct.pack(">i", 0)) +
        houdini_attribute(b"phase", 4, 1, struct.pack(">iH5sH3s", 2, 5, b"water", 3, b"oil")) +
        b"".join(struct.pack(">7f2i", i, 0, 0, 1, 1, 0, 0, 7 + i, i) for i in range(2)))
names = b"id type xs ys zs"
binary_head = struct.pack("<qqi6i6d", 4, 2, 0, 0, 0, 1, 1, 2, 3, 0, 10, 0, 10, 0, 10)
binary_rows = struct.pack("<ii10d", 1, 10, 1, 1, 0, 0, 0, 2, 1, 0.5, 0.5, 1)
named_dump = (struct.pack("<q", -8) + b"DUMPATOM" + struct.pack("<ii", 1, 2) + binary_head +
              struct.pack("<ii5sbd", 5, 5, b"metal", 1, 0.5) + struct.pack("<i", len(names)) + names +
              binary_rows)


def png(width, height, kind, depth, channels, pixel):
    def chunk(name, data):
        return (struct.pack(">I", len(data)) + name + data +
                struct.pack(">I", zlib.crc32(name + data)))
    row = b"\0" + pixel * width * channels
    return (b"\x89PNG\r\n\x1a\n" +
            chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, depth, kind, 0, 0, 0)) +
            chunk(b"tEXt", b"Software\0a test") + chunk(b"IDAT", zlib.compress(row * height)) +
            chunk(b"IEND", b""))


def exr(width, height, compression):
    """Channels R as half and Z as float, one scan line a block; 0 stands for none, 2 for zip."""
    def attribute(name, kind, data):
        return name + b"\0" + kind + b"\0" + struct.pack("<I", len(data)) + data
    channels = b"".join(name + b"\0" + struct.pack("<IIII", kind, 0, 1, 1)
                        for name, kind in ((b"R", 1), (b"Z", 2))) + b"\0"
    window = struct.pack("<4i", 0, 0, width - 1, height - 1)
    head = (struct.pack("<II", 20000630, 2) + attribute(b"channels", b"chlist", channels) +
            attribute(b"compression", b"compression", bytes([compression])) +
            attribute(b"dataWindow", b"box2i", window) +
            attribute(b"displayWindow", b"box2i", window) +
            attribute(b"lineOrder", b"lineOrder", b"\0") +
            attribute(b"pixelAspectRatio", b"float", struct.pack("<f", 1)) +
            attribute(b"screenWindowCenter", b"v2f", struct.pack("<2f", 0, 0)) +
            attribute(b"screenWindowWidth", b"float", struct.pack("<f", 1)) + b"\0")
    lines = []
    for y in range(height):
        data = struct.pack(f"<{width}e{width}f", *[0.5] * width, *[2.0 + y] * width)
        if compression:
            halves = data[0::2] + data[1::2]
            packed = zlib.compress(bytes([halves[0]]) + bytes(
                (b - a + 128) & 255 for a, b in zip(halves, halves[1:])))
            data = packed if len(packed) < len(data) else data
        lines.append(struct.pack("<iI", y, len(data)) + data)
    places, at = [], len(head) + 8 * height
    for line in lines:
        places.append(at)
        at += len(line)
    return head + struct.pack(f"<{height}Q", *places) + b"".join(lines)


seeds = {
    "png": [png(3, 2, 2, 8, 3, b"\x40"), png(2, 2, 0, 16, 1, b"\x40\1"), png(1, 1, 6, 8, 4, b"\x80")],
    "exr": [exr(4, 3, 0), exr(16, 2, 2)],
    "session": [
        pathlib.Path(__file__).with_name("session.json").read_text(),
        '{"mote-session": 1, "files": ["pump:0.02"], "colour": {"color-by": "p", "range": [0, 1]}, '
        '"cuts": {"cut": ["x=0", "r=:0.1"]}, "volume": {"opacity": ["0=0", "50%=0.5"], "iso": [1, 2]}}'
    ],
    "bin": [named_dump * 2, binary_head + struct.pack("<i", 5) + binary_rows],
    "gadget": [gadget],
    "bgeo": [bgeo],
    "gro": [
        "water, t= 1.5\n2\n    1SOL     OW    1   0.230   0.628   0.113  0.1000 -0.2000  0.3000\n"
        "    1SOL    HW1    2   0.137   0.626   0.150  0.0000  0.0000  0.0000\n  1.8 1.8 1.8\n",
        "a title\n1\n    1SOL     OW    1    .230    .628    .113\n1 1 1 0 0 0.5 0 0.5 0.5\n"
    ],
    "cfg": [
        "Number of particles = 2\nA = 1.0 Angstrom\nH0(1,1) = 4 A\nH0(2,2) = 5 A\nH0(3,3) = 6 A\n"
        ".NO_VELOCITY.\nentry_count = 4\nauxiliary[0] = pe [eV]\n63.5\nCu\n.5 .5 .5 -1\n0 0 0 2\n",
        "Number of particles = 1\nH0(1,1) = 4 A\nR = 2\n63.5 Cu 0.5 0.5 0.5 1 0 0\n"
    ],
    "dump": [
        lammps_data("Atoms # full\n\n2 1 1 0.5 1 2 3 0 0 0\n1 1 2 -0.5 4 5 6 0 0 0 # a comment\n\n"
                    "Velocities\n\n1 1 0 0\n2 0 1 0\n"),
        lammps_data("Velocities\n\n1 1 0 0\n2 0 1 0\n\nAtoms\n\n1 1 0.5 2600 1 2 3\n2 1 0.5 2600 4 5 6\n"),
        lammps_data("Atoms # atomic\n\n1 Si 1 2 3\n2 O 4 5 6\n\nBonds\n\n1 1 1 2\n"),
        dump.format(**plain), dump.format(**plain) + dump.format(**scaled),
        "ITEM: UNITS\nmetal\nITEM: TIME\n0.25\n" + dump.format(**scaled),
        dump.format(**{**plain, "rows": ""}).replace("\n3\n", "\n0\n"),
        gzip.compress(dump.format(**plain).encode(), mtime=0)
    ],
    "xyz": [
        "2\na comment\nCu 0 0 0\nO 1.5 2 -3e1\n",
        "1\nfirst\n1 0 0 0\n1\nsecond\n1 1 0 0\n",
        '2\nLattice="2 0 0 0 2 0 0.5 0 2" Properties=species:S:1:pos:R:3:f:R:3:id:I:1 Time=0.5 '
        'pbc="T F T"\nH 0 0 0 1 2 3 7\nHe 1 1 1 -1 -2 -3 8\n'
    ],
    "pts": ["0 0 0\n1 2 3\n-1e3 nan 5\n", "1,2,3\n4,5,6\n"],
    "csv": [
        "x,y,z,v\n0,0,0,1\n1,2,3,-1e5\n", 'x;y;z;"a name"\n0;0;0;one\n1;1;1;two\n',
        "a\tb\tc\n1\t2\t3\n", "x,y,z\n1,2\n3,4,5,6\n",
        '"Points:0","Points:1","Points:2","U:0","U:1"\n1,2,3,4,0.5\n"4",5,6,,7\n',
        "[Name]\nPlane 1\n\n[Data]\nX [ m ], Y [ m ], Z [ m ], p\n1, 2, 3, 4\n\n,,,\n5, 6, 7, N/A,\n",
        "x;y;z;T\n1,5;2;3;4,25\n-1;2;3;\n", "# x y z T\n1 2 3 4\n5 6 7 3000000000\n",
        "1 2 3 4\n5 6 7 1.5D2\n"
    ],
    "pdb": [
        "\n".join(pdb_atom.format(n=n, x=0.5 * n) for n in (1, 2, 3)) + "\nEND\n",
        "HEADER    A TEST\nHETATM    1  O   HOH A   1       1.000   2.000   3.000\nTER\nEND\n",
        "CRYST1   10.000   20.000   30.500  90.00  90.00  60.00 P 1           1\n" + "".join(
            f"MODEL     {n:4d}\n" + pdb_atom.format(n=n, x=0.5) + "\nENDMDL\n" for n in (1, 2))
    ],
    "ply": [
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nproperty uchar red\nelement face 1\n"
        "property list uchar int vertex_indices\nend_header\n0 0 0 1\n1 0 0 2\n0 1 0 3\n3 0 1 2\n",
        b"ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\n"
        b"property float y\nproperty float z\nend_header\n" + bytes(12)
    ],
    "obj": [
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 1 2\np 3\n",
        "# a comment\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvn 0 0 1\nusemtl a\ng b\n"
        "f 1/1/1 2/2/1 -1/1/-1\nf 1//1 2//1 \\\n3//1\nusemtl c\nf 1/2 2/2 3/1\n",
        "o a\nv 0 0 0 1 0 0\nv 1 0 0 0 0.5 1\nv 0 1 0\nvn 0 0 1\nvn 1 0 0\nf 1//1 2//1 3//1\n"
        "o b\nf 1//2 2//1 3//2\n"
    ],
    "vtk": [
        legacy.format(format="ASCII", rest="POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\n"
                      "POLYGONS 1 4\n3 0 1 2\nPOINT_DATA 3\nSCALARS s float 1\n"
                      "LOOKUP_TABLE default\n0 1 2\n"),
        legacy.format(format="ASCII", rest="UNSTRUCTURED_GRID\nPOINTS 8 double\n" + corners +
                      "\nCELLS 1 9\n8 " + numbered + "\nCELL_TYPES 1\n12\nCELL_DATA 1\n"
                      "FIELD FieldData 1\nv 3 1 int\n1 2 3\n"),
        legacy.format(format="BINARY", rest="STRUCTURED_POINTS\nDIMENSIONS 2 2 2\nORIGIN 0 0 0\n"
                      "SPACING 1 1 1\nPOINT_DATA 8\nSCALARS s unsigned_char\n"
                      "LOOKUP_TABLE default\n").encode() + bytes(range(8)) + b"\n",
        legacy.format(format="ASCII", rest="STRUCTURED_GRID\nDIMENSIONS 2 2 2\nPOINTS 8 float\n" +
                      corners + "\nPOINT_DATA 8\nVECTORS v float\n" + corners + "\n"),
        legacy.format(format="ASCII", rest="MULTIBLOCK\nCHILDREN 1\nCHILD 0 [a]\n" +
                      legacy.format(format="ASCII", rest="POLYDATA\nPOINTS 1 float\n0 0 0\n") +
                      "ENDCHILD\n"),
        legacy.format(format="ASCII", rest="UNSTRUCTURED_GRID\nPOINTS 8 double\n" + corners +
                      "\nCELLS 1 32\n31 " + sides + "\nCELL_TYPES 1\n42\n"),
        legacy.format(format="ASCII", rest="UNSTRUCTURED_GRID\nPOINTS 8 double\n" + corners +
                      "\nCELLS 3 39\nOFFSETS vtktypeint64\n0 31 39\nCONNECTIVITY vtktypeint64\n" + sides +
                      " " + numbered + "\nCELL_TYPES 2\n42 12\n").replace("3.0", "5.1")
    ],
    "vtp": [triangles, all_kinds],
    "vtu": [hexahedron, quadratic, polyhedron],
    "vti": [image, image_steps],
    "vts": [structured],
    "vtr": [rectilinear],
    "stl": [
        "solid a\n" + facet + "endsolid a\n",
        b"a binary file".ljust(80) + struct.pack("<I12fH", 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0)
    ],
    "gltf": [json.dumps(gltf), json.dumps(moving_gltf())],
    "colormap": [
        json.dumps([{"Name": "a", "ColorSpace": space, "NanColor": [1, 1, 0],
                     "RGBPoints": [0, 0, 0, 1, 0.5, 1, 1, 1, 1, 1, 0, 0]}])
        for space in ("RGB", "HSV", "Lab", "CIEDE2000", "Diverging", "Step")
    ] + [
        json.dumps({"IndexedColors": [1, 0, 0, 0, 1, 0]}), "# a map\n0 0 0\n0.5 1e-1 .25 1\n1 1 1\n",
        "0,0,0\r\n12;34;56\n", "#ff0000\n#0f0\n"
    ],
    "expression": [
        "x + 2*y^2 - z", "v.x > 0.5 && mag(v) <= 2 || !(y == 1)", "'v'.1 ? sqrt(abs(z)) : -pi",
        "max(1, 2, min(x, y)) + sum(x, y, z) + rint(1e-3)", "gradient(v).x", '"v" * 0.1e+2'
    ],
}


def main():
    if len(sys.argv) != 3 or sys.argv[1] not in seeds:
        sys.exit("usage: fuzz/seeds.py " + "|".join(seeds) + " FOLDER")
    folder = pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    for number, seed in enumerate(seeds[sys.argv[1]]):
        data = seed if isinstance(seed, bytes) else seed.encode()
        (folder / f"seed-{number}").write_bytes(data)


if __name__ == "__main__":
    main()
