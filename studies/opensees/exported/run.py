"""Runs scripts that `pounding export --opensees` wrote, and writes what OpenSees finds as a table.

    pounding export --opensees towers.toml --out towers.py      # and the others
    python3 run.py 2e-5 towers.py travelling.py bouc-wen.py links.py > exported.csv
"""

import csv
import pathlib
import runpy
import sys

step = float(sys.argv[1])
writer = csv.writer(sys.stdout, lineterminator="\n")
writer.writerow(["scene", "quantity", "place", "value"])
for name in sys.argv[2:]:
    script = runpy.run_path(name)
    script["ops"].logFile("/dev/null", "-noEcho")
    for quantity, values in script["run"](step).items():
        for place, value in enumerate(values):
            writer.writerow([pathlib.Path(name).stem, quantity, place, "" if value is None else repr(value)])
