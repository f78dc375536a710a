"""Runs the Python examples of README.md and of pages in docs as a reader would: in a folder of their own,
which has the project's data."""

import ast
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(os.environ["MOTE_SOURCE_DIR"])
PAGES = [ROOT / "README.md", ROOT / "docs/volumes.md", *sorted((ROOT / "docs/guide").glob("*.md"))]


def examples():
    texts = [page.read_text(encoding="utf-8") for page in PAGES if page.exists()]
    return re.findall(r"^```python\n(.*?)^```", "\n".join(texts), re.M | re.S)


def notebook_cells():
    notebook = json.loads((ROOT / "docs/guide/python.ipynb").read_text(encoding="utf-8"))
    return [cell["source"] for cell in notebook["cells"] if cell["cell_type"] == "code"]


class Notebook(unittest.TestCase):
    def test_cells_run_and_show_their_last_value(self):
        names = {}
        shown = []
        here = os.getcwd()
        os.chdir(ROOT)
        try:
            for cell in notebook_cells():
                *before, last = ast.parse(cell).body
                exec(compile(ast.Module(before, []), "cell", "exec"), names)
                if isinstance(last, ast.Expr):
                    value = eval(compile(ast.Expression(last.value), "cell", "eval"), names)
                    shown.append(value)
        finally:
            os.chdir(here)
        pictures = [value._repr_png_() for value in shown if hasattr(value, "_repr_png_")]
        self.assertEqual(len(pictures), 2)
        self.assertTrue(all(picture.startswith(b"\x89PNG") for picture in pictures))
        self.assertEqual(shown[-1], (300, 800, 3))


class Readme(unittest.TestCase):
    def test_examples_run(self):
        for number, code in enumerate(examples(), 1):
            with self.subTest(example=number), tempfile.TemporaryDirectory() as folder:
                (pathlib.Path(folder) / "data").symlink_to(ROOT / "data")
                done = subprocess.run(
                    [sys.executable, "-c", code],
                    cwd=folder,
                    capture_output=True,
                    text=True,
                    timeout=240,
                    check=False,
                )
                said = done.stdout + done.stderr
                self.assertEqual(done.returncode, 0, said)
                self.assertNotRegex(said, r"ERR\||ERROR|Traceback")
                named = re.findall(r"[\"']([\w.-]+\.(?:png|exr|ogv))[\"']", code)
                for name in named:
                    self.assertGreater((pathlib.Path(folder) / name).stat().st_size, 0, name)


if __name__ == "__main__":
    if not examples():
        print("there is no ```python block yet: skipped")
        sys.exit(77)
    unittest.main()
