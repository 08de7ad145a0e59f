#!/usr/bin/env python3
"""The same studies on a local HyperQueue cluster: 1, 2 and 16 tasks, and a task killed in the middle; the bytes must be the same.

    python3 -m venv venv && venv/bin/pip install hyperqueue
    cargo build -p truegap-cli
    venv/bin/python validation/cluster/hyperqueue.py

TRUEGAP names another program, SAMPLES another size of the batch, DESIGNS that of the space, STUDIES which to run ("tolerance optimise", or audit).
"""

import filecmp
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

# this file is called like the package
sys.path[:] = [path for path in sys.path if Path(path or ".").resolve() != Path(__file__).resolve().parent]
from hyperqueue import Job, LocalCluster  # noqa: E402
from hyperqueue.cluster import WorkerConfig  # noqa: E402

TRUEGAP = str(Path(os.environ.get("TRUEGAP", "target/debug/truegap")).resolve())
SAMPLES = os.environ.get("SAMPLES", "3000000")
DESIGNS = os.environ.get("DESIGNS", "32")
SPACE = f'schema = "truegap.space/1"\nsensor = "singletact-s15-4.5n"\ndesigns = {DESIGNS}\nseed = 7\n'
STUDIES = {
    "tolerance": ["tolerance", "--samples", SAMPLES, "--limit", "span=2.3:2.6", "--seed", "7", "-q"],
    "optimise": ["optimise", "--searches", "8", "--seed", "7", "-q"],
    "audit": ["audit", "--space", "space.toml", "-q"],
}
CHOSEN = os.environ.get("STUDIES", "tolerance optimise").split()


def files(folder):
    return sorted(str(p.relative_to(folder)) for p in folder.rglob("*") if p.is_file() and p.suffix != ".part")


def same(one, other):
    """Whether both folders hold the same bytes, half-written files of a killed process aside."""
    if files(one) != files(other):
        return f"DIFFERENT: {set(files(one)) ^ set(files(other))}"
    different = [name for name in files(one) if not filecmp.cmp(one / name, other / name, shallow=False)]
    return f"DIFFERENT: {different}" if different else f"same bytes: {len(files(one))} files"


def cases(folder):
    return len(list((folder / "cases").glob("*.json")))


def job(study, folder, tasks, pids):
    job = Job(max_fails=None)
    for index in range(1, tasks + 1):
        # the shell's process id becomes the program's
        line = f'echo $$ > {pids}/{index}; exec "$@"'
        words = ["bash", "-c", line, "bash", TRUEGAP, *STUDIES[study], "-o", str(folder), "--shard", f"{index}/{tasks}"]
        job.program(words, env={"RAYON_NUM_THREADS": "1"}, stdout=str(pids / f"{index}.out"), stderr=str(pids / f"{index}.err"))
    return job


def main():
    failed = False
    with tempfile.TemporaryDirectory(prefix="truegap-hq-") as work, LocalCluster(worker_config=WorkerConfig(cores=os.cpu_count())) as cluster:
        work, client = Path(work), cluster.client()
        pids = work / "pids"
        pids.mkdir()
        (work / "space.toml").write_text(SPACE)
        STUDIES["audit"][2] = str(work / "space.toml")
        # exit code 1 says that a study found something to look at; what counts is its bytes
        well = lambda done: done.returncode <= 1
        merge = lambda folder: subprocess.run([TRUEGAP, "merge", str(folder), "-q"], capture_output=True, text=True)
        for study in CHOSEN:
            words, begin = STUDIES[study], time.perf_counter()
            failed |= not well(subprocess.run([TRUEGAP, *words, "-o", str(work / study)], capture_output=True))
            print(f"{study}, one process, all cores: {time.perf_counter() - begin:.1f} s, {cases(work / study)} cases", flush=True)
            for tasks in (1, 2, 16):
                folder, begin = work / f"{study}-{tasks}", time.perf_counter()
                client.wait_for_jobs([client.submit(job(study, folder, tasks, pids))], raise_on_error=False)
                took = time.perf_counter() - begin
                merged = merge(folder)
                told = same(work / study, folder)
                failed |= not well(merged) or not told.startswith("same")
                print(f"{study}, HyperQueue, {tasks} tasks, 1 core a task: {took:.1f} s; {told}", flush=True)

        study, folder = CHOSEN[0], work / "killed"
        for old in pids.iterdir():
            old.unlink()

        def kill():
            while cases(folder) < 5 or not (pids / "1").exists():
                time.sleep(0.05)
            os.kill(int((pids / "1").read_text()), signal.SIGKILL)
            print(f"{study}: killed task 1 by kill -9 with {cases(folder)} cases done", flush=True)

        killer = threading.Thread(target=kill)
        killer.start()
        finished = client.wait_for_jobs([client.submit(job(study, folder, 2, pids))], raise_on_error=False)
        killer.join()
        before, refused = cases(folder), merge(folder)
        print(f"all tasks well: {finished}; merge says ({refused.returncode}): {refused.stderr[:120]}...")
        client.wait_for_jobs([client.submit(job(study, folder, 2, pids))], raise_on_error=False)
        merged = merge(folder)
        told = same(work / study, folder)
        halves = len(list((folder / "cases").glob("*.part")))
        print(f"submitted again: {before} cases were there, {cases(folder)} now, {halves} half-written files left aside; {told}")
        failed |= finished or refused.returncode != 2 or not well(merged) or not told.startswith("same")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
