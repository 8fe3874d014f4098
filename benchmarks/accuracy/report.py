#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the tables of docs/accuracy.md and docs/accuracy_tables.md and the figures docs/figures/accuracy_*.svg.

    report.py RESULTS_FOLDER DOCS_FOLDER

The text of the pages stays as it is; the lines between '<!-- table: NAME -->' and '<!-- end -->' are replaced, for every
table whose results are in the folder. Needs nothing but Python's standard library.
"""
import csv
import math
import pathlib
import re
import sys

SHAPES = ["sphere", "torus", "ellipsoid", "harmonic", "two_scale", "capsule", "saddle", "quadric", "pair_1_8"]
SHORT = {"cgal_jet_2": "jet 2", "cgal_jet_3": "jet 3", "cgal_jet_4": "jet 4", "vcg_quadric": "VCG quadric",
         "vcg_quadric_1ring": "VCG 1-ring", "vcg_taubin": "VCG Taubin", "vcg_normal_cycle": "VCG normal cycle",
         "vcg_pca": "VCG PCA"}


def read(path):
    rows = list(csv.DictReader(open(path)))
    for row in rows:
        for key, value in row.items():
            if key not in ("shape", "meshing", "method"):
                row[key] = float(value)
        row["cell"] = (row["shape"], row["meshing"], row["sigma"])
    return rows


def best_peers(rows, measure):
    best = {}
    for row in rows:
        if row["cell"] not in best or row[measure] < best[row["cell"]][measure]:
            best[row["cell"]] = row
    return best


def geometric_mean(values):
    return math.exp(sum(map(math.log, values)) / len(values)) if values else float("nan")


def percent(value):
    return f"{100 * value:.2f}" if value < 0.1 else f"{100 * value:.1f}"


def ratio(ours, peer):
    return f"{ours / peer:.2f}" if peer > 0 else "–"


def name_of(row):
    radius = f" {row['radius']:g}ē" if row["radius"] else ""
    return SHORT.get(row["method"], row["method"]) + radius


def table(header, lines):
    rule = "|" + "---|" * len(header)
    return "\n".join(["| " + " | ".join(header) + " |", rule] + ["| " + " | ".join(line) + " |" for line in lines])


def cells_table(ours, peers, chosen):
    by_mean, by_direction = best_peers(peers, "mean"), best_peers(peers, "direction")
    header = ["shape", "meshing", "σ/ē", "mean %", "RMS %", "median %", "p95 %", "p99 %", "within 10 %",
              "best peer: mean %", "at", "ratio", "direction °", "best peer °", "at", "ratio", "coverage 1, 2", "σ̂/ē", "s"]
    lines = []
    for row in filter(chosen, ours):
        peer, turn = by_mean.get(row["cell"]), by_direction.get(row["cell"])
        if not peer:
            continue
        lines.append([row["shape"], row["meshing"], f"{row['sigma']:g}", percent(row["mean"]), percent(row["rms"]),
                      percent(row["median"]), percent(row["p95"]), percent(row["p99"]), f"{row['within_tenth']:.2f}",
                      percent(peer["mean"]), name_of(peer), ratio(row["mean"], peer["mean"]),
                      f"{row['direction']:.2f}", f"{turn['direction']:.2f}", name_of(turn),
                      ratio(row["direction"], turn["direction"]),
                      f"{row['within_one']:.2f}, {row['within_two']:.2f}", f"{row['noise']:.3f}", f"{row['seconds']:.1f}"])
    return table(header, lines)


def ratios(ours, peers, measure, chosen):
    best = best_peers(peers, measure)
    pairs = [(row[measure], best[row["cell"]][measure]) for row in filter(chosen, ours) if row["cell"] in best]
    return [mine / peer for mine, peer in pairs if peer > 0 and mine > 0]


def summary_table(ours, peers):
    groups = [("all noisy cells", lambda r: r["sigma"] > 0)]
    groups += [(f"σ = {s:g} ē", lambda r, s=s: r["sigma"] == s) for s in (0.05, 0.1, 0.2, 0.5, 1)]
    groups += [(m, lambda r, m=m: r["sigma"] > 0 and r["meshing"] == m)
               for m in ("regular", "irregular", "graded", "slivers", "cad")]
    groups += [(s, lambda r, s=s: r["sigma"] > 0 and r["shape"] == s) for s in SHAPES]
    lines = []
    for name, chosen in groups:
        mean, turn = ratios(ours, peers, "mean", chosen), ratios(ours, peers, "direction", chosen)
        if not mean:
            continue
        rows = [r for r in ours if chosen(r)]
        lines.append([name, str(len(mean)), f"{geometric_mean(mean):.2f}", f"{max(mean):.2f}",
                      f"{geometric_mean(turn):.2f}" if turn else "–", f"{max(turn):.2f}" if turn else "–",
                      f"{sum(r['within_one'] for r in rows) / len(rows):.2f}",
                      f"{sum(r['within_two'] for r in rows) / len(rows):.2f}"])
    return table(["cells", "count", "κ: geometric mean of ratios", "largest", "directions: geometric mean", "largest",
                  "coverage at 1", "at 2"], lines)


def peers_table(ours, peers):
    """Each peer against the best one of the cell, both at their best radius."""
    best = best_peers([r for r in peers if r["sigma"] > 0], "mean")
    lines = []
    for method in sorted({r["method"] for r in peers}):
        own = best_peers([r for r in peers if r["method"] == method and r["sigma"] > 0], "mean")
        own_ratios = [own[c]["mean"] / best[c]["mean"] for c in own]
        lines.append((geometric_mean(own_ratios), [SHORT.get(method, method), f"{geometric_mean(own_ratios):.3g}",
                                                   str(sum(r == 1 for r in own_ratios))]))
    mine = ratios(ours, peers, "mean", lambda r: r["sigma"] > 0)
    lines.append((geometric_mean(mine), ["**this library, default settings**", f"**{geometric_mean(mine):.3g}**",
                                         f"better than all in {sum(r < 1 for r in mine)} of {len(mine)}"]))
    return table(["estimator", "mean error over the best peer's, geometric mean", "cells in which it is the best peer"],
                 [line for _, line in sorted(lines, key=lambda pair: pair[0])])


def cost_table(rows):
    columns = ["published_seconds", "same_balls_seconds"]
    lines = [[row["shape"], f"{row['sigma']:g}", f"{row['vertices']:g}", f"{row['default_seconds']:.2f}"] +
             [f"{row[c]:.2f}" for c in columns] + [f"{row['default_seconds'] / row[c]:.2f}" for c in columns]
             for row in rows]
    means = [geometric_mean([row["default_seconds"] / row[c] for row in rows]) for c in columns]
    lines.append(["geometric mean"] + [""] * 5 + [f"{m:.2f}" for m in means])
    return table(["shape", "σ/ē", "vertices", "default, s", "published settings, s", "published, default's radii, s",
                  "ratio", "ratio, same radii"], lines)


def radius_figure(ours, peers, cell):
    """Error of each peer against its radius, ours as a line: an SVG of 480 × 320."""
    series = {}
    for row in peers:
        if row["cell"] == cell and row["radius"] and row["method"] != "vcg_pca":
            series.setdefault(row["method"], []).append((row["radius"], row["mean"]))
    mine = next(row["mean"] for row in ours if row["cell"] == cell)
    low, high = math.log10(mine / 2), math.log10(min(3.0, max(v for s in series.values() for _, v in s)))

    def place(radius, value):
        y = (min(max(math.log10(value), low), high) - low) / (high - low)
        return 60 + 300 * math.log(radius) / math.log(40), 270 - 240 * y

    parts = ['<svg xmlns="http://www.w3.org/2000/svg" width="520" height="320" font-family="sans-serif" font-size="12">',
             '<rect width="520" height="320" fill="white"/>',
             f'<text x="60" y="18">{cell[0]}, {cell[1]}, σ = {cell[2]:g} ē: mean error of κ</text>']
    for radius in (1, 2, 4, 8, 16, 40):
        x, _ = place(radius, mine)
        parts.append(f'<line x1="{x:.0f}" y1="30" x2="{x:.0f}" y2="270" stroke="#ddd"/>'
                     f'<text x="{x:.0f}" y="286" text-anchor="middle">{radius}</text>')
    for exponent in range(math.ceil(low), math.floor(high) + 1):
        _, y = place(1, 10 ** exponent)
        parts.append(f'<line x1="60" y1="{y:.0f}" x2="360" y2="{y:.0f}" stroke="#ddd"/>'
                     f'<text x="54" y="{y + 4:.0f}" text-anchor="end">{10.0 ** exponent * 100:g} %</text>')
    parts.append('<text x="210" y="306" text-anchor="middle">radius / ē</text>')
    colours = ["#1b9e77", "#d95f02", "#7570b3", "#e7298a", "#66a61e"]
    for index, (method, points) in enumerate(sorted(series.items())):
        path = " ".join("{:.1f},{:.1f}".format(*place(r, v)) for r, v in sorted(points))
        y = 50 + 20 * index
        parts.append(f'<polyline points="{path}" fill="none" stroke="{colours[index % 5]}" stroke-width="2"/>'
                     f'<text x="372" y="{y}" fill="{colours[index % 5]}">{SHORT.get(method, method)}</text>')
    _, y = place(1, mine)
    parts.append(f'<line x1="60" y1="{y:.1f}" x2="360" y2="{y:.1f}" stroke="black" stroke-width="2" stroke-dasharray="6 3"/>'
                 f'<text x="372" y="{y + 4:.0f}">default, no radius</text></svg>')
    return "\n".join(parts) + "\n"


def cell_tables(results):
    """The tables of docs/accuracy_tables.md that are computed from one line a cell."""
    if not (results / "peers.csv").exists() or not (results / "ours.csv").exists():
        return {}
    peers, ours = read(results / "peers.csv"), read(results / "ours.csv")
    return {
        "summary": summary_table(ours, peers),
        "peers": peers_table(ours, peers),
        "regular": cells_table(ours, peers, lambda r: r["meshing"] == "regular"),
        "meshing": cells_table(ours, peers, lambda r: r["meshing"] in ("irregular", "graded", "slivers")),
        "cad": cells_table(ours, peers, lambda r: r["meshing"] == "cad"),
    }


def printed_tables(results):
    """The tables that the benchmark prints itself; a file with two of them has an empty line between."""
    names = {"families": ["families"], "family_peers": ["family_peers", "family_peer_cells"], "scans": ["scans"],
             "frame": ["frame"], "creases": ["creases"]}
    tables = {}
    for stem, parts in names.items():
        if (results / f"{stem}.md").exists():
            text = (results / f"{stem}.md").read_text().strip()
            tables.update(zip(parts, text.split("\n\n") if len(parts) > 1 else [text]))
    return tables


def fill_pages(docs, tables):
    pages = {docs / name: (docs / name).read_text() for name in ("accuracy.md", "accuracy_tables.md")}
    for name, content in tables.items():
        place = re.compile(rf"(<!-- table: {name} -->\n).*?(<!-- end -->)", flags=re.S)
        if not any(place.search(text) for text in pages.values()):
            sys.exit(f"report.py: no page has a place for the table '{name}'")
        for page, text in pages.items():
            pages[page] = place.sub(lambda m: m[1] + content + "\n" + m[2], text)
    for page, text in pages.items():
        page.write_text(text)


def draw_figures(results, docs):
    peers, ours = read(results / "peers.csv"), read(results / "ours.csv")
    (docs / "figures").mkdir(exist_ok=True)
    for cell in (("harmonic", "regular", 0.1), ("ellipsoid", "irregular", 0.2), ("pair_1_8", "regular", 0.1)):
        figure = docs / "figures" / ("accuracy_{}_{}_{:g}.svg".format(*cell).replace("0.", "0"))
        figure.write_text(radius_figure(ours, peers, cell))


def main():
    results, docs = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    tables = {**cell_tables(results), **printed_tables(results)}
    if (results / "cost.csv").exists():
        tables["cost"] = cost_table(read(results / "cost.csv"))
    fill_pages(docs, tables)
    if "regular" in tables:
        draw_figures(results, docs)


if __name__ == "__main__":
    main()
