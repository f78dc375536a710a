"""Runs the Python examples of README.md as a reader would: in a folder of their own."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

README = pathlib.Path(os.environ["MOTE_SOURCE_DIR"]) / "README.md"


def examples():
    if not README.exists():
        return []
    return re.findall(r"^```python\n(.*?)^```", README.read_text(encoding="utf-8"), re.M | re.S)


class Readme(unittest.TestCase):
    def test_examples_run(self):
        for number, code in enumerate(examples(), 1):
            with self.subTest(example=number), tempfile.TemporaryDirectory() as folder:
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
                named = re.findall(r"[\"']([\w.-]+\.(?:png|exr))[\"']", code)
                for name in named:
                    self.assertGreater((pathlib.Path(folder) / name).stat().st_size, 0, name)


if __name__ == "__main__":
    if not examples():
        print("README.md has no ```python block yet: skipped")
        sys.exit(77)
    unittest.main()
