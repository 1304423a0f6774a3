"""Solves the scenes of scenes.json by other programs, one request a line, in the time that the benchmark gives it.

The first line that it writes says which programs there are. A request names tool, method, setting and law; the answer has the CPU
time of a scene [s], without imports and compilation, and peak displacements and impulse of each, or why there are none. Only
answers go to the standard output.
"""

import importlib
import importlib.metadata
import json
import os
import pathlib
import shutil
import sys
import time

# One core, as for the others.
for name in ("OMP", "OPENBLAS", "MKL", "NUMBA"):
    os.environ[f"{name}_NUM_THREADS"] = "1"

import exchange  # noqa: E402  (threads are counted when numpy is imported)

# What answers a request, and the package whose version is told.
TOOLS = {
    "numba": ("loops", "numba"),
    "c": ("c_loops", None),
    "scipy": ("scipy_ivp", "scipy"),
    "sundials": ("cvode", "scikit-sundae"),
    "opensees": ("opensees", "openseespy"),
}
# A measurement repeats what is shorter.
LEAST_SECONDS = 0.02
# Methods that have run a law once, and are compiled.
WARM = set()


def present():
    """Versions of what is there; of other programs only whether they are."""
    found, modules = {}, {}
    for tool, (module, package) in TOOLS.items():
        try:
            modules[tool] = importlib.import_module(module)
            found[tool] = importlib.metadata.version(package) if package else modules[tool].COMPILER
        except Exception as error:  # whatever an import may do, the others go on
            print(f"{tool}: {error!r}", file=sys.stderr)
            found[tool] = None
    found["octave"] = shutil.which("octave")
    found["siconos"] = shutil.which("siconos")
    return found, modules


def measured(module, request, study, law):
    run, warm = module.prepared(request["method"], request["setting"], study, law)
    if (name := (request["tool"], request["method"], law.name)) not in WARM:
        warm()
        WARM.add(name)
    runs, start = 0, time.process_time()
    while runs == 0 or time.process_time() - start < LEAST_SECONDS:
        found = run()
        runs += 1
    return (time.process_time() - start) / runs / len(law.scenes), found


def answer(modules, request, study):
    module, law = modules[request["tool"]], study.laws[request["law"]]
    try:
        how = getattr(module, "measured", None)
        arguments = request["method"], request["setting"], study, law
        seconds, found = how(*arguments) if how else measured(module, request, study, law)
    except Exception as error:  # told instead of shown, so that the others go on
        return {"failed": repr(error)}
    # A number that is not finite has no place in JSON.
    text = [[repr(float(value)) for value in line] for line in found]
    return {"seconds": seconds, "found": text}


def main():
    # Programs of others print: what is ours keeps the pipe, all else goes where errors go.
    pipe = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)
    study = exchange.Study(pathlib.Path(__file__).with_name("scenes.json"))
    found, modules = present()
    print(json.dumps(found), file=pipe, flush=True)
    for line in sys.stdin:
        print(json.dumps(answer(modules, json.loads(line), study)), file=pipe, flush=True)


if __name__ == "__main__":
    main()
