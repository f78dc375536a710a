"""The table of settings, and values for them at random."""

import collections
import re

TEXTS = ["3", "-1", "0", "0.5", "1e300", "nan", "inf", "x > 0", "type == 1", "speed=vx*2", "depth=z-20",
         "a=gradient(p).x", "U", "p", "v", "type", "radius", "viridis", "0:10", ":5", "1=0.5", "none",
         "x=0", "2,2,1", "0,0,1", "10%", "0.5px", "hello", "#ff0000", "navy", "4", "100000", "%s%n",
         "type=1", "z=0:10", "p=-0.001:", "r=0.06", "first", "last", "all", "", "-", "--", "\u00e4\u2603",
         "a b", "a\nb", "1,2,3,4,5,6"]
NO_OPTIONS = {"--output", "--save-session", "--all-steps", "--key-frames", "--record", "--play"}

# What a word of the table stands for.
SAMPLES = {
    "NAME": ["p", "U", "U:0", "U:magnitude", "v", "v:2", "type", "id", "x", "z", "radius", "none",
             "c_pe", "pressure", "velocity", "cell:velocity"],
    "N": ["1", "2", "3", "16"], "F": ["0.5", "1", "2"], "LO": ["0", "-1", "-0.001"],
    "HI": ["1", "0.001", "10"], "X,Y,Z": ["1,0,0", "0,0,1", "0.3,-2,1", "0,0,0"],
    "LENGTH": ["0.01", "1", "1%"], "DEG": ["30", "-90", "360"],
    "COLOUR": ["navy", "#ff8000", "white"], "COLOUR[,TOP]": ["navy", "black,white"],
    "TEXT": ["A title", "t = 3 \u00b5s", ""], "SIZE": ["64K", "2M", "1G"], "R": ["0.01", "0.5", "3"],
    "PIXELS": ["1", "4"], "OPACITY": ["0.3", "1"], "A": ["20", "30"], "D": ["0.1", "10"],
    "W": ["1", "0.2"], "T": ["0", "7.5", "100"], "STEP": ["1%", "0.01"], "FACTOR": ["2"],
    "ID,LO:HI,...": ["7", "1:100", "0:5000,7"], "EXPRESSION": ["x > 0", "type == 1", "p < 0 && z > 0"],
    "NAME=EXPRESSION": ["s=sqrt(vx^2+vy^2)", "d=z*2", "w=vorticity(U).z", "h=mag(U)"],
    "NAME=LO:HI,...": ["x=0:", "type=1", "p=-0.001:0.001", "z=0:1,2:3"], "NAME=LO:HI": ["p=0:1"],
    "NAME=PLACE,...": ["x=0", "z=0.05,0.06", "r=0.01"], "TYPE=COLOUR,...": ["1=red,2=#00ff00"],
    "TYPE=NAME,...": ["1=Cu,2=Zr"], "TYPE=R,...": ["1=0.5,2=1"], "TYPE,...": ["2,1"],
    "VALUE=OPACITY,...": ["0=0,1=1", "-0.001=0.5,0.001=0"], "VALUE,...": ["0", "0,0.0005"],
    "N,...": ["1", "1,2"], "NAME,...": ["p", "p,U"], "BUDGET": ["1%", "0.5px"], "FORMAT": ["%.2f"],
    "X,Y,Z,...": ["0,0,0.05"], "A:B[:STRIDE]": ["1:1", "all"], "LEVEL": ["0.1"], "HEIGHT": ["1"]}

Option = collections.namedtuple("Option", "name words values")


def options_of(text):
    """The options of each group of the table, as markdown has it."""
    groups, group = {}, None
    for line in text.split("\n"):
        if line.startswith("## "):
            group = line[3:]
            groups[group] = []
        row = re.match(r"\| `(?:-\w, )?(--[a-z-]+)([^`]*)` \| .*? \| (.*?) \|", line)
        if row and row.group(1) not in NO_OPTIONS:
            groups[group].append(Option(row.group(1), row.group(2).split(), row.group(3)))
    return groups


def value(option, chance):
    """Words for an option: mostly such as its row allows."""
    if chance.random() < 0.1:
        return [chance.choice(TEXTS) for _ in option.words]
    choices = [w for w in re.split(r",\s*", option.values) if re.fullmatch(r"[a-z-]+", w)]
    bounds = re.search(r"from ([0-9.e+-]+) to ([0-9.e+-]+)", option.values)
    found = []
    for word in option.words:
        if choices:
            found.append(chance.choice(choices))
        elif word in SAMPLES and chance.random() < 0.9:
            found.append(chance.choice(SAMPLES[word]))
        elif bounds:
            low, high = float(bounds.group(1)), min(float(bounds.group(2)), 40.0)
            number = chance.uniform(low, max(low, high))
            found.append(str(int(number)) if chance.random() < 0.7 else "%.3g" % number)
        else:
            found.append(chance.choice(TEXTS))
    return found
