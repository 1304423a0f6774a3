"""A sweep on the processors of this machine by HyperQueue from PyPI: no rights, no scheduler.

    python3 -m venv hq && hq/bin/pip install hyperqueue
    hq/bin/python hyperqueue.py sweep.json runs.csv 8
    pounding merge runs.csv

Workers on other machines can join the same server; the script shows how tasks are made.
"""

import os
import sys
from pathlib import Path

# This file has the name of the package: its folder must not be searched for it.
sys.path = [path for path in sys.path if Path(path or ".").resolve() != Path(__file__).resolve().parent]

from hyperqueue import Job
from hyperqueue.cluster import LocalCluster, WorkerConfig

sweep, table, shards = sys.argv[1], sys.argv[2], int(sys.argv[3])
script = Path(__file__).resolve().with_suffix(".sh")
environment = {name: os.environ[name] for name in ("PATH", "POUNDING") if name in os.environ}

with LocalCluster() as cluster:
    for _ in range(os.cpu_count() or 1):
        cluster.start_worker(WorkerConfig(cores=1))
    job = Job()
    for _ in range(shards):
        # Tasks count from 0 here.
        job.program(
            ["bash", str(script), sweep, table],
            env={**environment, "SHARDS": str(shards)},
            cwd=os.getcwd(),
        )
    client = cluster.client()
    if not client.wait_for_jobs([client.submit(job)], raise_on_error=False):
        sys.exit("a task failed; run this again for what is missing")
