# SPDX-License-Identifier: GPL-3.0-or-later
"""run_matrix.py TABLE.md MESH.ply ...: the runs and the table of scripts/matrix, which says what it needs.

A run is one mesh, engine, radius choice and host. It is finished (all values of all vertices finite), refused (with a
sentence), or failed: a crash, a time-out, values that are not finite, or an end without a word.
"""

import concurrent.futures
import contextlib
import dataclasses
import json
import os
import re
import subprocess
import sys
import tempfile
import threading
import time

import numpy as np

from ply import read_ply

BUILD, ROOT = os.environ["II_BUILD"], os.environ["II_ROOT"]
ENGINES = ("Surface integral", "Volume (FFT)")
RADII = {"Feature-adapted": "Published", "Fixed": "Published", "Statistical": "Bias removed"}  # with its estimator
HOSTS = ("library", "2020.09", "2022.02", "2025.07", "PyMeshLab")
AT_A_TIME = 2  # meshes
SCREEN = threading.Lock()  # xvfb-run finds a free display, but does not hold it
TIME_LIMIT = 900  # seconds, of all runs of one mesh in one host
PROPERTIES = ("ii_kmax", "ii_kmin", "ii_radius", "ii_confidence", "ii_dirmax_x", "ii_dirmax_y", "ii_dirmax_z",
              "ii_dirmin_x", "ii_dirmin_y", "ii_dirmin_z", "quality")


@dataclasses.dataclass
class Outcome:
    seconds: float = None
    sentence: str = ""
    failure: str = ""


def parameters_of(engine, radius):
    """The volume engine's grid is half as fine as usual, or the table would take hours."""
    coarse = {"fft_cells_per_radius": 3.0} if engine == ENGINES[1] else {}
    return {"engine": engine, "radius_choice": radius, "estimator": RADII[radius], **coarse}


def assignments(engine, radius):
    return [f"{name}={value}" for name, value in parameters_of(engine, radius).items()]


def run(command, limit=TIME_LIMIT):
    """Exit status (None: ended by the time limit) and all output."""
    try:
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=limit, check=False)
        return done.returncode, done.stdout.decode("utf-8", "replace")
    except subprocess.TimeoutExpired as late:
        return None, (late.stdout or b"").decode("utf-8", "replace")


def judged(status, sentence):
    """What became of a run that left no result."""
    if status is None:
        return Outcome(failure="time limit")
    if status < 0 or status > 128 and status != 255:
        return Outcome(failure=f"ended by status {status}")
    return Outcome(sentence=sentence) if sentence else Outcome(failure="ended without a word")


def in_library(mesh, folder):
    outcomes = {}
    for engine in ENGINES:
        for radius in RADII:
            out = os.path.join(folder, "rows")
            start = time.monotonic()
            status, text = run([f"{BUILD}/tests/hosts/core_curvature", mesh, out, *assignments(engine, radius)])
            seconds = time.monotonic() - start
            if status == 0:
                finite = np.isfinite(np.fromfile(out)).all()
                outcomes[engine, radius] = Outcome(seconds) if finite else Outcome(failure="not finite")
            else:
                outcomes[engine, radius] = judged(status, last_match(r"core_curvature: (.*)", text))
    return outcomes


def last_match(pattern, text):
    found = re.findall(pattern, text)
    return found[-1].strip() if found else ""


def filter_element(engine, radius, export):
    writer = [f"{BUILD}/filter_feature_adapted_ii/write_filter_script", *assignments(engine, radius), f"export_file={export}"]
    script = subprocess.run(writer, stdout=subprocess.PIPE, check=True).stdout.decode()
    return script[script.index(" <filter"):script.index("</FilterScript>")]


def host_command(host, mesh, script):
    if host == "2020.09":
        return ["xvfb-run", "-a", f"{BUILD}/meshlab-2020.09/bin/meshlabserver", "-i", mesh, "-s", script]
    folder = f"{BUILD}/hosts/{host}"
    return [f"{ROOT}/scripts/hosts/run_in_host", host, f"{folder}/runner/meshlab_script_runner", "--plugin",
            f"{folder}/filter_feature_adapted_ii/libfilter_feature_adapted_ii.so", "-i", mesh, "-s", script]


def host_sentence(host, text):
    if host == "2020.09":
        return (last_match(r"LOG: 2 (.*)\n", text.split("Reading filter with name")[-1])
                or last_match(r"(.*(?:Unable|nable to open|rror).*)", text))
    return last_match(r"meshlab_script_runner: (?:the filter '[^']*' failed: )?(.*)", text)


def apply_in_host(host, mesh, folder, runs):
    """One start of the host for these runs, one after the other; those after a refusal are not reached."""
    exports = {key: os.path.join(folder, f"{i}.ply") for i, key in enumerate(runs)}
    script = os.path.join(folder, "script.mlx")
    with open(script, "w", encoding="utf-8") as file:
        elements = "".join(filter_element(*key, exports[key]) for key in runs)
        file.write(f"<!DOCTYPE FilterScript>\n<FilterScript>\n{elements}</FilterScript>\n")
    with SCREEN if host == "2020.09" else contextlib.nullcontext():
        status, text = run(host_command(host, mesh, script))
    times = [float(t) for t in re.findall(r"^(?:LOG: 2 )?Time: ([0-9.]+) s", text, re.MULTILINE)]
    if host == "2020.09":
        times = times[-len([e for e in exports.values() if os.path.exists(e)]):]  # each is printed twice
    outcomes = {}
    for key, export in exports.items():
        if not os.path.exists(export):
            break
        vertices, _ = read_ply(export)
        finite = all(np.isfinite(vertices[name]).all() for name in PROPERTIES)
        outcomes[key] = Outcome(times[len(outcomes)]) if finite else Outcome(failure="not finite")
        os.remove(export)
    return outcomes, judged(status, host_sentence(host, text))


def in_host(host, mesh, folder):
    outcomes = {}
    left = [(engine, radius) for engine in ENGINES for radius in RADII]
    while left:
        done, refusal = apply_in_host(host, mesh, folder, left)
        outcomes.update(done)
        left = left[len(done):]
        if left:
            outcomes[left.pop(0)] = refusal
    return outcomes


def in_pymeshlab(mesh, _folder):
    runs = [(engine, radius) for engine in ENGINES for radius in RADII]
    plugin = f"{BUILD}/hosts/2025.07-double/filter_feature_adapted_ii/libfilter_feature_adapted_ii.so"
    status, text = run([os.environ["II_PYMESHLAB_PYTHON"], f"{ROOT}/scripts/apply_in_pymeshlab.py", plugin, mesh,
                        json.dumps([parameters_of(*key) for key in runs])])
    rows = [json.loads(line[5:]) for line in text.splitlines() if line.startswith("JSON ")]
    outcomes = {key: Outcome(**row) for key, row in zip(runs, rows)}
    for key in runs[len(rows):]:
        outcomes[key] = judged(status, "")
    return outcomes


def outcomes_of(mesh):
    """From (host, engine, radius) to Outcome."""
    found = {}
    for host in HOSTS:
        with tempfile.TemporaryDirectory() as folder:
            runner = {"library": in_library, "PyMeshLab": in_pymeshlab}.get(host, lambda m, f, h=host: in_host(h, m, f))
            for (engine, radius), outcome in runner(mesh, folder).items():
                found[host, engine, radius] = outcome
    return found


class Table:
    def __init__(self):
        self.rows, self.sentences, self.finished, self.refused, self.failed = [], [], 0, 0, []

    def add(self, mesh, found):
        name = "/".join(mesh.split("/")[-2:]).removesuffix(".ply")
        for engine in ENGINES:
            cells = [" ".join(self._cell(name, host, engine, radius, found[host, engine, radius]) for radius in RADII)
                     for host in HOSTS]
            self.rows.append(f"| {name} | {engine.split()[0].lower()} | " + " | ".join(cells) + " |")

    def _cell(self, name, host, engine, radius, outcome):
        if outcome.failure:
            self.failed.append(f"{name}, {engine}, {radius}, {host}: {outcome.failure}")
            return "**failed**"
        if outcome.sentence:
            self.refused += 1
            general = re.sub(r"\d+", "…", re.sub(r"/\S*/", "", outcome.sentence))
            if general not in self.sentences:
                self.sentences.append(general)
            return f"[{self.sentences.index(general) + 1}]"
        self.finished += 1
        return f"{outcome.seconds:.2f}"

    def text(self, meshes):
        lines = ["# Every model, engine, radius choice and host", "", f"Made by `scripts/matrix` on {time.strftime('%Y-%m-%d')}. "
                 f"{AT_A_TIME} models at a time. Seconds of a run, as the filter logs them (library: of the process, the mesh read and all written), for the "
                 "radius choices " + ", ".join(r.lower() for r in RADII) + " in this order; each with all other parameters at "
                 "their defaults, the first two with the published estimator, the volume engine at 3 cells a radius. [n]: refused, with the sentence below.", "",
                 f"{meshes} models, {self.finished + self.refused + len(self.failed)} runs: {self.finished} finished with finite "
                 f"values for all vertices, {self.refused} refused with a sentence, {len(self.failed)} failed.", "",
                 "| model | engine | " + " | ".join(HOSTS) + " |", "|---" * (2 + len(HOSTS)) + "|", *self.rows, ""]
        lines += [f"[{i}] {sentence}\n" for i, sentence in enumerate(self.sentences, 1)]
        return "\n".join(lines)


def main(table_file, meshes):
    table = Table()
    with concurrent.futures.ThreadPoolExecutor(AT_A_TIME) as pool:
        for i, (mesh, found) in enumerate(zip(meshes, pool.map(outcomes_of, meshes)), 1):
            print(f"matrix: {i} of {len(meshes)}: {mesh}", file=sys.stderr)
            table.add(mesh, found)
            with open(table_file, "w", encoding="utf-8") as file:  # after each, because all of them take long
                file.write(table.text(i))
    print("\n".join(table.failed), file=sys.stderr)
    print(f"{table.finished + table.refused} passed, {len(table.failed)} failed")
    return 1 if table.failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2:]))
