#!/usr/bin/env python3
"""fill_in.py SETTINGS.md FROM TO: puts what docs/settings.md says of settings into XML.

@help:NAME@ becomes the sentence that explains the setting --NAME; @include:FILE@ another file,
filled in, too.
"""

import pathlib
import re
import sys
from xml.sax.saxutils import escape


def helps_of(page):
    """What each option does, by its name."""
    helps = {}
    for line in page.splitlines():
        cells = [cell.replace("\\|", "|").strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
        if len(cells) < 2 or not cells[0].startswith("`-"):
            continue
        for name in re.findall(r"--([a-z-]+)", cells[0].replace("\\|", "|")):
            helps.setdefault(name, cells[1])
    return helps


def main():
    settings, source, target = map(pathlib.Path, sys.argv[1:])
    helps = helps_of(settings.read_text())

    def fill(text):
        text = re.sub(r"@include:([\w.]+)@", lambda m: fill((source.parent / m[1]).read_text()), text)

        def explain(match):
            if match[1] not in helps:
                sys.exit(f"{source}: {settings} has no --{match[1]}")
            return escape(helps[match[1]].removesuffix(".") + ".")

        return re.sub(r"@help:([a-z-]+)@", explain, text)

    filled = fill(source.read_text())
    if not target.exists() or target.read_text() != filled:
        target.write_text(filled)


if __name__ == "__main__":
    main()
