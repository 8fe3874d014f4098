# SPDX-License-Identifier: GPL-3.0-or-later
"""Every model, engine, radius choice and host: scripts/matrix prepares the hosts and runs this by pytest.

A run ends with finite values for all vertices or with a sentence that says why not; a crash, a time-out, values that are not
finite, or an end without a word is a failure. II_MATRIX_TABLE names the Markdown table that is written.
"""

import json
import os
import pathlib
import re
import subprocess
import sys
import time

import numpy as np
import pytest

ROOT, BUILD = pathlib.Path(__file__).parents[2], pathlib.Path(os.environ["II_BUILD"])
sys.path.insert(0, str(ROOT / "scripts/lib"))
from exported import vertex_table  # noqa: E402

MODELS = sorted(pathlib.Path(path) for path in os.environ["II_MATRIX_MODELS"].splitlines())
ENGINES = ("Surface integral", "Volume (FFT)")
RADII = {"Feature-adapted": "Published", "Fixed": "Published", "Statistical": "Bias removed"}  # with its estimator
RUNS = [(engine, radius) for engine in ENGINES for radius in RADII]
HOSTS = ("library", "2020.09", "2022.02", "2025.07", "PyMeshLab")
TIME_LIMIT = 900  # seconds, of all runs of one mesh in one host
PLUGIN = "filter_feature_adapted_ii/libfilter_feature_adapted_ii.so"


def parameters_of(engine, radius):
    """The volume engine's grid is half as fine as usual, or the table would take hours."""
    coarse = {"fft_cells_per_radius": 3.0} if engine == ENGINES[1] else {}
    return {"engine": engine, "radius_choice": radius, "estimator": RADII[radius], **coarse}


def assignments(engine, radius):
    return [f"{name}={value}" for name, value in parameters_of(engine, radius).items()]


def run(command):
    """All output of a program that ends in time and by itself."""
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          timeout=TIME_LIMIT, check=False)
    assert 0 <= done.returncode <= 128 or done.returncode == 255, f"ended by status {done.returncode}"
    return done.returncode, done.stdout.decode("utf-8", "replace")


def last_match(pattern, text):
    found = re.findall(pattern, text, re.MULTILINE)
    return found[-1].strip() if found else ""


def in_library(mesh, folder):
    for key in RUNS:
        start = time.monotonic()
        status, text = run([BUILD / "tests/hosts/core_curvature", mesh, folder / "rows", *assignments(*key)])
        if status == 0:
            assert np.isfinite(np.fromfile(folder / "rows")).all(), f"{key}: not finite"
        yield key, time.monotonic() - start if status == 0 else last_match("core_curvature: (.*)", text)


def filter_element(key, export):
    writer = [BUILD / "filter_feature_adapted_ii/write_filter_script", *assignments(*key), f"export_file={export}"]
    script = subprocess.run(writer, stdout=subprocess.PIPE, check=True).stdout.decode()
    return script[script.index(" <filter"):script.index("</FilterScript>")]


def host_command(host, mesh, script):
    if host == "2020.09":
        return ["xvfb-run", "-a", BUILD / "meshlab-2020.09/bin/meshlabserver", "-i", mesh, "-s", script]
    build = BUILD / "hosts" / host
    return [ROOT / "scripts/hosts/run_in_host", host, build / "runner/meshlab_script_runner", "--plugin", build / PLUGIN,
            "-i", mesh, "-s", script]


def host_sentence(host, text):
    if host == "2020.09":
        return (last_match("LOG: 2 (.*)$", text.split("Reading filter with name")[-1])
                or last_match("(.*(?:Unable|nable to open|not possible|rror).*)", text))
    return last_match("meshlab_script_runner: (?:the filter '[^']*' failed: )?(.*)", text)


def in_host(host, mesh, folder):
    """One start of the host for all runs, one after the other; after a refusal, which ends it, one for those left."""
    left = list(RUNS)
    while left:
        exports = {key: folder / f"{i}.ply" for i, key in enumerate(left)}
        script = folder / "script.mlx"
        elements = "".join(filter_element(key, export) for key, export in exports.items())
        script.write_text(f"<!DOCTYPE FilterScript>\n<FilterScript>\n{elements}</FilterScript>\n", encoding="utf-8")
        _, text = run(host_command(host, mesh, script))
        times = [float(t) for t in re.findall("^(?:LOG: 2 )?Time: ([0-9.]+) s", text, re.MULTILINE)]
        done = [key for key in left if exports[key].exists()]
        for key, seconds in zip(done, times[-len(done):] if done else []):  # 2020.09 prints each twice
            values = vertex_table(exports[key])
            assert all(np.isfinite(values[name]).all() for name in values.dtype.names), f"{key}: not finite"
            exports[key].unlink()
            yield key, seconds
        left = left[len(done):]
        if left:
            yield left.pop(0), host_sentence(host, text)


def in_pymeshlab(mesh, _folder):
    plugin = BUILD / "hosts/2025.07-double" / PLUGIN
    _, text = run([os.environ["II_PYMESHLAB_PYTHON"], ROOT / "tests/hosts/matrix_pymeshlab.py", plugin, mesh, json.dumps([parameters_of(*key) for key in RUNS])])
    answers = [json.loads(line[5:]) for line in text.splitlines() if line.startswith("JSON ")]
    assert len(answers) == len(RUNS), "PyMeshLab ended without a word"
    yield from zip(RUNS, answers)


@pytest.fixture(scope="module")
def table():
    """From (model, host) to {(engine, radius): seconds or sentence}; written at the end."""
    found = {}
    yield found
    if "II_MATRIX_TABLE" in os.environ:
        pathlib.Path(os.environ["II_MATRIX_TABLE"]).write_text(table_text(found), encoding="utf-8")


def table_text(found):
    sentences = []

    def cell(outcome):
        if isinstance(outcome, float):
            return f"{outcome:.2f}"
        general = re.sub(r"\d+", "…", re.sub(r"/\S*/", "", outcome))
        if general not in sentences:
            sentences.append(general)
        return f"[{sentences.index(general) + 1}]"

    rows = []
    for model in MODELS:
        for engine in ENGINES:
            outcomes = [[found.get((model, host), {}).get((engine, radius), "failed") for radius in RADII] for host in HOSTS]
            rows.append(f"| {model.parent.name}/{model.stem} | {engine.split()[0].lower()} | "
                        + " | ".join(" ".join(cell(outcome) for outcome in column) for column in outcomes) + " |")
    numbers = sum(isinstance(outcome, float) for runs in found.values() for outcome in runs.values())
    refused = sum(len(runs) for runs in found.values()) - numbers
    failed = len(MODELS) * len(HOSTS) * len(RUNS) - numbers - refused
    head = ["# Every model, engine, radius choice and host", "",
            f"Made by `scripts/matrix` on {time.strftime('%Y-%m-%d')}. Seconds of a run, as the filter logs them (library: of the "
            "process, the mesh read and all written), for the radius choices " + ", ".join(r.lower() for r in RADII)
            + " in this order; each with all other parameters at their defaults, the first two with the published estimator, the "
            "volume engine at 3 cells a radius. [n]: refused, with the sentence below.", "",
            f"{len(MODELS)} models, {numbers + refused + failed} runs: {numbers} finished with finite values for all vertices, "
            f"{refused} refused with a sentence, {failed} failed.", "",
            "| model | engine | " + " | ".join(HOSTS) + " |", "|---" * (2 + len(HOSTS)) + "|"]
    return "\n".join(head + rows + [""] + [f"[{i}] {sentence}\n" for i, sentence in enumerate(sentences, 1)])


@pytest.mark.parametrize("host", HOSTS)
@pytest.mark.parametrize("model", MODELS, ids=lambda path: f"{path.parent.name}/{path.stem}")
def test_every_run_ends_with_values_or_a_sentence(model, host, table, tmp_path):
    runner = {"library": in_library, "PyMeshLab": in_pymeshlab}.get(host, lambda m, f: in_host(host, m, f))
    outcomes = table[model, host] = {}
    for key, outcome in runner(model, tmp_path):
        assert outcome != "", f"{key}: ended without a word"
        outcomes[key] = outcome

