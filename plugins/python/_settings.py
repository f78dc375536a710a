"""Settings of the table as keyword arguments: names, and values as JSON has them."""

import difflib
import json
import math
import os

import numpy as np

from . import _program

_ROWS = {row["name"]: row for row in json.loads(_program.settings())}


def _sentence(row):
    text = row["help"]
    if row["values"]:
        text += ". Values: " + row["values"]
    if row["usual"]:
        text += ". Default: " + row["usual"]
    return text


def _plain(value):
    """A value as JSON has it: numbers of NumPy as Python's, pairs of a dict as "NAME=VALUE"."""
    if isinstance(value, dict):
        return [f"{name}={_range(one)}" for name, one in value.items()]
    if isinstance(value, (np.bool_, np.integer, np.floating)):
        value = value.item()
    if isinstance(value, float) and not math.isfinite(value):
        return str(value)  # which JSON has no number for
    if isinstance(value, (str, bool, int, float)) or value is None:
        return value
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if hasattr(value, "__iter__"):
        return [_plain(one) for one in value]
    raise TypeError(f"a setting is a text, a number, True or False, or a list of them, not {value!r}")


def _range(value):
    """(1, 2) as "1:2", (1, None) and (1, inf) as "1:"; else the value itself."""
    if isinstance(value, (tuple, list)):
        if len(value) != 2:
            raise ValueError(f"a range has two ends, unlike {value!r}")
        return ":".join(
            "" if end is None or end == free else str(_plain(end))
            for end, free in zip(value, (-math.inf, math.inf))
        )
    return str(_plain(value))


def _size(value):
    """(800, 600) as "800x600"."""
    width, height = value
    return f"{int(width)}x{int(height)}"


def _checked(given, of):
    """Settings by the names of the table. TypeError for a name that it does not have."""
    known = {}
    for name, value in given.items():
        row = name.replace("_", "-")
        if row in ("step", "time"):
            raise TypeError(f"{of}() takes no {name}: a scene of files is one of a time step; see Scene.at()")
        if row not in _ROWS:
            near = difflib.get_close_matches(row, _ROWS, 1)
            hint = f"; did you mean {near[0].replace('-', '_')}?" if near else "; see mote.settings()"
            raise TypeError(f"{of}() knows no setting {name}{hint}")
        is_size = row in ("size", "picture-size") and not isinstance(value, str)
        known[row] = _size(value) if is_size else _plain(value)
    return known
