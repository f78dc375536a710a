"""make_stubs.py PACKAGE: writes what editors and type checkers read of the package mote, beside it: the
functions with their settings as the table has them, and the classes of VTK's wrapping."""

import inspect
import os
import pathlib
import re
import sys

import mote

try:
    from mote import functions
except ModuleNotFoundError:  # there is no NumPy, and so there are classes alone
    functions = None

SETTING = {"flag": "bool", "one": "_One", "optional": "_One | bool", "many": "_Many"}


def settings_of(window):
    """The keywords of render(), or of show() too."""
    for name, row in functions._ROWS.items():
        if name != "size" and (window or not row["command"]):
            yield name.replace("-", "_"), f"{SETTING[row['shape']]} | None"


def with_settings(signature, window):
    """A signature whose **settings are named."""
    taken = set(signature.parameters)
    named = [f"{n}: {kind} = ..." for n, kind in settings_of(window) if n not in taken]
    text = str(signature)
    if "**settings" not in text:
        return text
    star = "" if re.search(r"\*, |\*paths", text) else "*, "
    return text.replace("**settings", star + ", ".join(named))


def stub_of_function(name, value):
    signature = with_settings(inspect.signature(value), name == "show")
    return f"def {name}{signature}: ...\n"


def stub_of_class(name, value):
    lines = [f"class {name}:\n"]
    for part, what in vars(value).items():
        if isinstance(what, property):
            lines.append(f"    @property\n    def {part}(self): ...\n")
        elif inspect.isfunction(what):
            lines.append(f"    def {part}{inspect.signature(what)}: ...\n")
    return "".join(lines)


def functions_stub():
    if functions is None:
        return ""
    text = [
        "from typing import Any, Iterable\n\n",
        "_One = str | float | int\n_Many = str | float | int | Iterable[Any] | dict[str, Any]\n\n",
        "class Error(RuntimeError): ...\n\n",
    ]
    for name, value in vars(functions).items():
        if name.startswith("_") or getattr(value, "__module__", "") != "mote.functions":
            continue
        text.append((stub_of_class if inspect.isclass(value) else stub_of_function)(name, value) + "\n")
    return "".join(text)


def package_stub():
    text = ["__version__: str\n\n"]
    if functions is not None:
        public = [n for n in dir(functions) if not n.startswith("_") and hasattr(mote, n)]
        public = [n for n in public if getattr(functions, n).__module__.startswith("mote")]
        text.insert(0, "from .functions import " + ", ".join(f"{n} as {n}" for n in public) + "\n\n")
    for name in sorted(n for n in dir(mote) if n.startswith("vtkMote")):
        text.append(f"class {name}:\n")
        for part in sorted(vars(getattr(mote, name))):
            if re.fullmatch(r"[A-Z]\w*", part):
                is_method = callable(getattr(getattr(mote, name), part))
                text.append(f"    def {part}(self, *args): ...\n" if is_method else f"    {part}: int\n")
        text.append("    def __init__(self) -> None: ...\n    def __getattr__(self, name: str): ...\n\n")
    return "".join(text)


package = pathlib.Path(sys.argv[1])
for name, text in [("functions.pyi", functions_stub()), ("__init__.pyi", package_stub()), ("py.typed", "")]:
    temporary = package / f"{name}.part"
    temporary.write_text(text)
    os.replace(temporary, package / name)
