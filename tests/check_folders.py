"""Which folder includes which: prints every pair, and fails where they go round in a circle.

    python3 tests/check_folders.py [ROOT]

A header is known by the end of its path, as to the compiler, and looked for nearby first.
"""

import collections
import pathlib
import re
import sys

PROGRAMS = ["app", "benchmarks"]
ROOMS = [*PROGRAMS, "filters", "rendering"]
# Each counts as one folder; in the kernels each room does, with its private headers.
WHOLE = ["benchmarks", *(f"rendering/kernels/{room}" for room in
                      ("core", "hexahedra", "imaging", "meshes", "occlusion", "particles", "scene",
                       "shading", "tracing"))]
INCLUDE = re.compile(r'^\s*#include\s*[<"]([^>"]+)[>"]', re.MULTILINE)


def folder_of(path):
    name = path.parent.as_posix()
    return next((whole for whole in WHOLE if name == whole or name.startswith(whole + "/")), name)


def find_header(name, includer, headers):
    tail = pathlib.PurePosixPath(*[part for part in name.split("/") if part != ".."])
    found = [h for h in headers[tail.name] if ("/" + h.as_posix()).endswith("/" + tail.as_posix())]

    def distance(header):
        # Headers of programs are for themselves.
        return (header.parent != includer.parent, folder_of(header) != folder_of(includer),
                header.parts[0] in PROGRAMS)

    return min(found, key=distance, default=None)


def find_circle(edges):
    """The folders that are left when those are gone that include, or are included by, no other."""
    while True:
        first, second = {a for a, _ in edges}, {b for _, b in edges}
        inner = {(a, b) for a, b in edges if a in second and b in first}
        if inner == edges:
            return sorted(first)
        edges = inner


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve()
    files = [
        path.relative_to(root)
        for room in ROOMS
        for path in sorted((root / room).rglob("*"))
        if path.suffix in {".h", ".cxx", ".cpp"}
    ]
    headers = collections.defaultdict(list)
    for path in files:
        headers[path.name].append(path)
    edges = set()
    for path in files:
        for name in INCLUDE.findall((root / path).read_text()):
            header = find_header(name, path, headers)
            if header and folder_of(header) != folder_of(path):
                edges.add((folder_of(path), folder_of(header)))
    for folder in sorted({a for a, _ in edges}):
        print(f"{folder} -> {', '.join(sorted(b for a, b in edges if a == folder))}")
    rooms = {(a.split("/")[0], b.split("/")[0]) for a, b in edges}
    for pairs in edges, {(a, b) for a, b in rooms if a != b}:
        if circle := find_circle(pairs):
            sys.exit("a circle of folders: " + ", ".join(circle))


if __name__ == "__main__":
    main()
