#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How far a regression gets that was taught the truth on half of the very surface it is judged on.

    learned_bound.py VERTICES.csv SHAPE/MESHING/SIGMA > line.csv

A network sees the noisy heights within 5.2 ē of a vertex over the true tangent plane, on a hexagonal grid turned by
chance, and says the principal curvatures. It is taught with the true ones of the blocks of one colour of a chessboard of
15 ē, under fresh noise in every epoch, and judged at the others under the noise of the benchmark; then the colours change
places. So it knows what no estimator may know: the noise's level, the tangent plane, and how this surface bends. What it
misses is not in the data, as far as a network of this size can tell.

One network learns the least mean error, one the largest share of small errors, which the median is about. VERTICES.csv
is what `accuracy vertices` prints. Needs numpy, scipy and torch; five to fifteen minutes on two processors.
"""
import csv
import math
import sys

import numpy as np
import torch
from scipy.spatial import cKDTree

REACH = 5.2  # of the grid
MARGIN = 1.2  # vertices beyond it that still carry a height to its rim
BLOCK = 15.0
MOST_NEIGHBOURS = 128
MOST_TAUGHT = 10000
EPOCHS = 300
BATCH = 512
SMALL_ERROR = 0.1  # of the reference: what the second network counts


class Surface:
    """The table's columns, lengths in ē: n × 3 positions, noisy positions and normals, n × 2 curvatures over the reference."""

    def __init__(self, path):
        with open(path, newline="") as file:
            rows = list(csv.DictReader(file))
        column = {name: np.array([float(row[name]) for row in rows]) for name in rows[0]}
        stack = lambda *names: np.stack([column[name] for name in names], axis=1)
        self.role = column["role"].astype(int)
        self.position, self.normal = stack("x", "y", "z"), stack("nx", "ny", "nz")
        self.noisy = self.position + column["offset"][:, None] * self.normal
        self.kappa = stack("kappa_max", "kappa_min") / column["reference"][:, None]
        self.colour = np.floor(self.position / BLOCK).astype(int).sum(axis=1) % 2
        self.tree = cKDTree(self.position)


def hexagonal_grid():
    rows = [(i + 0.5 * k, k * math.sqrt(3) / 2) for i in range(-9, 10) for k in range(-9, 10)]
    return np.array([p for p in rows if math.hypot(*p) <= REACH])


def symmetries(grid):
    """The permutations of the grid that its six turns and their mirror images are."""
    found = []
    for mirror in (1, -1):
        for turn in range(6):
            angle = turn * math.pi / 3
            c, s = math.cos(angle), math.sin(angle)
            image = grid @ np.array([[c, -s * mirror], [s, c * mirror]]).T
            found.append(((image[:, None] - grid[None]) ** 2).sum(axis=2).argmin(axis=1))
    return torch.tensor(np.array(found))


def tangent_axes(normal, angle):
    u = np.cross(normal, np.eye(3)[np.abs(normal).argmin()])
    u /= np.linalg.norm(u)
    v = np.cross(normal, u)
    return math.cos(angle) * u + math.sin(angle) * v, math.cos(angle) * v - math.sin(angle) * u


def interpolation(grid, plane):
    """Weights, grid × vertices, of a smooth function through the heights at `plane`: kriging without noise."""
    length, nugget = 1.6, 1e-6
    kernel = lambda squared: 1 / (1 + squared / (2 * length * length))
    squared = lambda a, b: ((a[:, None] - b[None]) ** 2).sum(axis=2)
    basis = np.column_stack([np.ones(len(plane)), plane])
    system = np.block([[kernel(squared(plane, plane)) + nugget * np.eye(len(plane)), basis], [basis.T, np.zeros((3, 3))]])
    right = np.column_stack([kernel(squared(grid, plane)), np.ones(len(grid)), grid]).T
    return np.linalg.solve(system, right)[: len(plane)].T


class Views:
    """Vertices as the network sees them: heights on the grid are weights @ (heights + raise_ * noise[neighbours])."""

    def __init__(self, surface, vertices, positions, grid, random):
        count = len(vertices)
        self.weights = torch.zeros(count, len(grid), MOST_NEIGHBOURS)
        self.heights = torch.zeros(count, MOST_NEIGHBOURS)
        self.raises = torch.zeros(count, MOST_NEIGHBOURS)
        self.neighbours = torch.zeros(count, MOST_NEIGHBOURS, dtype=torch.long)
        self.kappa = torch.tensor(surface.kappa[vertices], dtype=torch.float32)
        for i, v in enumerate(vertices):
            x, y = tangent_axes(surface.normal[v], random.uniform(0, 2 * math.pi))
            near = np.array(surface.tree.query_ball_point(surface.position[v], 1.6 * REACH))
            away = positions[near] - positions[v]
            plane = np.column_stack([away @ x, away @ y])
            facing = surface.normal[near] @ surface.normal[v]
            distance = np.hypot(*plane.T)
            inside = np.flatnonzero((distance < REACH + MARGIN) & (facing > 0.3))
            inside = inside[np.argsort(distance[inside])][:MOST_NEIGHBOURS]
            n = len(inside)
            self.weights[i, :, :n] = torch.tensor(interpolation(grid, plane[inside]), dtype=torch.float32)
            self.heights[i, :n] = torch.tensor(away[inside] @ surface.normal[v], dtype=torch.float32)
            # Along its own normal a vertex leaves the plane's grid point: over that the surface rises by 1 / cosine.
            self.raises[i, :n] = torch.tensor(1 / facing[inside], dtype=torch.float32)
            self.neighbours[i, :n] = torch.tensor(near[inside])

    def seen(self, chosen, noise=None):
        heights = self.heights[chosen]
        if noise is not None:
            heights = heights + self.raises[chosen] * noise[self.neighbours[chosen]]
        return torch.bmm(self.weights[chosen], heights[:, :, None])[:, :, 0]


class Network(torch.nn.Module):
    """Heights to principal curvatures: a linear part, and what three layers add; mean curvature and deviator inside."""

    def __init__(self, inputs, width=256, dropped=0.15):
        super().__init__()
        linear = torch.nn.Linear
        self.linear = linear(inputs, 3)
        self.deep = torch.nn.Sequential(
            linear(inputs, width), torch.nn.GELU(), torch.nn.Dropout(dropped), linear(width, width), torch.nn.GELU(),
            torch.nn.Dropout(dropped), linear(width, width), torch.nn.GELU(), linear(width, 3))
        torch.nn.init.zeros_(self.deep[-1].weight)
        torch.nn.init.zeros_(self.deep[-1].bias)

    def forward(self, heights):
        heights = heights - heights.mean(dim=1, keepdim=True)
        parts = self.linear(heights) + self.deep(heights)
        half = torch.sqrt(parts[:, 1] ** 2 + parts[:, 2] ** 2 + 1e-8)
        return torch.stack([parts[:, 0] + half, parts[:, 0] - half], dim=1)


def mean_error(errors):
    return errors.abs().mean()


def share_of_large_errors(errors):
    return (errors.abs() / (errors.abs() + SMALL_ERROR)).mean()


def taught(views, vertex_count, sigma, turns, loss):
    network = Network(views.weights.shape[1])
    optimizer = torch.optim.AdamW(network.parameters(), lr=2e-3, weight_decay=3e-3)
    schedule = torch.optim.lr_scheduler.CosineAnnealingLR(optimizer, EPOCHS)
    for epoch in range(EPOCHS):
        shuffled = torch.randperm(len(views.kappa))
        for begin in range(0, len(shuffled) - BATCH + 1, BATCH):
            chosen = shuffled[begin : begin + BATCH]
            heights = views.seen(chosen, sigma * torch.randn(vertex_count))
            heights = heights[:, turns[torch.randint(len(turns), ())]]
            optimizer.zero_grad()
            loss(network(heights) - views.kappa[chosen]).backward()
            optimizer.step()
        schedule.step()
        if (epoch + 1) % 50 == 0:
            print(f"{loss.__name__}: epoch {epoch + 1} of {EPOCHS}", file=sys.stderr)
    return network.eval()


def errors_of_halves(surface, sigma, losses):
    """Absolute errors of κ over the reference at all judged vertices, for each of the losses; and how many were taught."""
    random = np.random.default_rng(2009)
    grid = hexagonal_grid()
    turns = symmetries(grid)
    errors, counts = [[] for _ in losses], []
    for colour in (0, 1):
        known = np.flatnonzero((surface.role > 0) & (surface.colour == colour))
        known = random.permutation(known)[:MOST_TAUGHT]
        judged = np.flatnonzero((surface.role == 2) & (surface.colour != colour))
        lesson = Views(surface, known, surface.position, grid, random)
        exam = Views(surface, judged, surface.noisy, grid, random)
        counts.append(len(known))
        for kept, loss in zip(errors, losses):
            network = taught(lesson, len(surface.role), sigma, turns, loss)
            with torch.no_grad():
                heights = exam.seen(torch.arange(len(judged)))
                answer = torch.stack([network(heights[:, turn]) for turn in turns]).mean(dim=0)
            kept.append((answer - exam.kappa).abs().numpy().ravel())
    return [np.concatenate(kept) for kept in errors], counts


def main():
    path, cell = sys.argv[1], sys.argv[2]
    shape, meshing, sigma = cell.split("/")
    torch.manual_seed(2009)
    surface = Surface(path)
    (least_mean, most_small), counts = errors_of_halves(surface, float(sigma), [mean_error, share_of_large_errors])
    print("shape,meshing,sigma,taught,mean,median")
    print(f"{shape},{meshing},{sigma},{min(counts)},{least_mean.mean():.5g},"
          f"{min(np.median(least_mean), np.median(most_small)):.5g}")


if __name__ == "__main__":
    main()
