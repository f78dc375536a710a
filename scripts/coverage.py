"""Adds up what gcov tells of a build: coverage.py ROOT BUILD LEAST; scripts/coverage runs it."""

import collections
import gzip
import json
import pathlib
import subprocess
import sys
import tempfile

ROOT, BUILD, LEAST = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve(), float(sys.argv[3])
FOLDERS = ("filters/io/",)
KERNELS = ("AtomicFile", "MappedFile", "ScratchSpace", "PkdTreeFile", "RlodTreeFile", "OcclusionFile")


def counts():
    """How often each line of each source file ran, of all objects together."""
    lines = collections.defaultdict(lambda: collections.defaultdict(int))
    notes = [str(note) for note in BUILD.rglob("*.gcno") if "/tests/" not in str(note.relative_to(BUILD))]
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(["gcov", "--json-format", "--preserve-paths", *notes], cwd=folder, check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        for report in pathlib.Path(folder).glob("*.gcov.json.gz"):
            data = json.loads(gzip.decompress(report.read_bytes()))
            for file in data["files"]:
                path = (pathlib.Path(data["current_working_directory"]) / file["file"]).resolve()
                if path.is_relative_to(ROOT):
                    for line in file["lines"]:
                        lines[str(path.relative_to(ROOT))][line["line_number"]] += line["count"]
    return lines


def is_counted(name):
    return name.startswith(FOLDERS) or name.startswith("rendering/kernels/") and pathlib.Path(name).stem in KERNELS


def main():
    rows = {name: found for name, found in sorted(counts().items()) if is_counted(name)}
    total = hit = 0
    missed = []
    for name, found in rows.items():
        reached = sum(count > 0 for count in found.values())
        total, hit = total + len(found), hit + reached
        if reached < len(found):
            print(f"{reached:5} of {len(found):5}  {100 * reached / len(found):5.1f} %  {name}")
        text = (ROOT / name).read_text().splitlines()
        missed += [f"{name}:{line}: {text[line - 1].strip()}" for line, count in sorted(found.items()) if count == 0]
    (BUILD / "missed.txt").write_text("\n".join(missed) + "\n")
    share = 100 * hit / max(total, 1)
    print(f"{hit:5} of {total:5}  {share:5.1f} %  of all lines; files with none missed are left out")
    sys.exit(share < LEAST)


main()
