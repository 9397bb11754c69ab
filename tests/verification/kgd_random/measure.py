# SPDX-License-Identifier: BSD-3-Clause
"""What a fracture in a packing is, in the numbers of the KGD bench, read through the Python binding.

A wing is the way of least resistance through broken bonds from the well's pore to the farthest pore of that side (round a disc that
hangs in the fracture there are two, one of them shut). Its mechanical opening u is
the jump of displacement across the local line of cracks, between the discs of either flank that still have two bonds.
"""
import heapq
import math
from typing import Any, Callable, Dict, List, NamedTuple, Tuple

import numpy as np


class Wing(NamedTuple):
    """One side of the fracture."""

    length: float  # m, from the middle of the well
    ratio: float  # effective hydraulic over mechanical aperture; nan: too short
    by_gap: float  # what it would be if every pipe had the gap of its own two discs
    by_pore: float  # and the volume gained by its two pores over their length along the fracture
    monotone: bool  # pressure falls from the well to the tip


class Fracture(NamedTuple):
    """The fracture of the well."""

    length: float  # m, half of tip to tip with the hole
    width: float  # m, in the middle, by the openings at 0.25 to 0.75 of the half length and the formula's shape: median
    pressure: float  # Pa, of the well over sigma_hmin
    volume: float  # m2, gained by the pores beside its cracks, and its opening times the hole's width
    injected: float  # m2, less what the fluid in the hole is compressed by
    pores: float  # m2, gained by hole and pores beside its cracks
    cracks: int
    wing_count: int
    azimuth: float  # degrees
    loose: int  # discs without an intact bond
    wings: Tuple[Wing, Wing]


class Model:
    """Arrays of a simulation that never change, and the pores' volumes before injection."""

    def __init__(self, sim: Any, facets: bool) -> None:
        self.sim = sim
        self.facets = facets
        self.start_volume = np.array(sim.domains.volume)
        self.kind = np.array(sim.domains.kind)
        self.radius = np.array(sim.discs.radius)
        self.bond_discs = np.array(sim.bonds.discs)
        self.pipe_domains = np.array(sim.pipes.domains)
        self.well = sim.wells[0].state
        self.centre = np.array([self.well.x, self.well.y])
        self.well_radius = self.well.equivalent_radius
        self.domain = self.well.domain
        rock = self.start_volume[self.kind == 0].sum()
        self.porosity = rock / (rock + math.pi * (self.radius**2).sum())
        self.start_pressure = np.array(sim.domains.pressure)
        self.position = np.array(sim.discs.position)
        self.graded = sim.setup.coarsest_radius > sim.setup.mean_radius

    def mean_radius(self, at: np.ndarray) -> float:
        """Of the discs around a place [m]: of all in a uniform packing, of the nearest 12 in a graded one."""
        if not self.graded:
            return float(self.radius.mean())
        away = np.hypot(*(self.position - at).T)
        return float(self.radius[np.argpartition(away, 12)[:12]].mean())


def _graph(model: Model, bonds: np.ndarray, middle: np.ndarray, centres: np.ndarray) -> Dict[int, List[Tuple[int, float, int]]]:
    graph: Dict[int, List[Tuple[int, float, int]]] = {}
    for k, bond in enumerate(bonds):
        left, right = (int(d) for d in model.pipe_domains[bond])
        way = sum(0.0 if d == model.domain else math.dist(centres[d], middle[k]) for d in (left, right))
        graph.setdefault(left, []).append((right, way, k))
        graph.setdefault(right, []).append((left, way, k))
    return graph


def _ways(graph: Dict[int, List[Tuple[int, float, int]]], start: int, resists: np.ndarray) -> Tuple[Dict[int, float], Dict[int, Tuple[int, int]]]:
    far: Dict[int, float] = {}
    before: Dict[int, Tuple[int, int]] = {}
    queue: List[Tuple[float, int, int, int]] = [(0.0, start, -1, -1)]
    while queue:
        distance, node, parent, crack = heapq.heappop(queue)
        if node in far:
            continue
        far[node], before[node] = distance, (parent, crack)
        for other, way, k in graph.get(node, []):
            if other not in far:
                heapq.heappush(queue, (distance + way * resists[k], other, node, k))
    return far, before


def _jumps(model: Model, middle: np.ndarray, position: np.ndarray, moved: np.ndarray, intact: np.ndarray) -> np.ndarray:
    """Opening across the local line of cracks at each crack."""
    result = np.zeros(len(middle))
    for k, at in enumerate(middle):
        reach = 3.0 * model.mean_radius(at)
        near = middle[np.hypot(*(middle - at).T) <= reach] - at
        spread = (near - near.mean(axis=0)).T @ (near - near.mean(axis=0)) if len(near) > 1 else np.diag([1.0, 0.0])
        along = np.linalg.eigh(spread)[1][:, 1]
        normal = np.array([-along[1], along[0]])
        offset = position - at
        flank = (np.hypot(*offset.T) <= reach) & (intact >= 2)
        side = offset @ normal - (near @ normal).mean()
        up, down = flank & (side > 0), flank & (side < 0)
        if up.any() and down.any():
            # The nearest three of either side.
            def mean(chosen: np.ndarray) -> float:
                index = np.flatnonzero(chosen)
                index = index[np.argsort(np.hypot(*offset[index].T))[:3]]
                return float((moved[index] @ normal).mean())
            result[k] = mean(up) - mean(down)
    return result


def _in_the_middle(jump: np.ndarray, xi: np.ndarray, shape: Callable[[np.ndarray], np.ndarray]) -> float:
    chosen = (np.abs(xi) > 0.25) & (np.abs(xi) < 0.75)
    return float(np.median(jump[chosen] / shape(np.abs(xi[chosen])))) if chosen.any() else 0.0


def fracture(model: Model, sigma_min: float, viscosity: float, bulk: float, shape: Callable[[np.ndarray], np.ndarray]) -> Fracture:
    """The well's fracture as it is now."""
    sim = model.sim
    state = sim.wells[0].state
    net = state.pressure - sigma_min
    hole = model.start_volume[model.domain]
    volume_now = np.array(sim.domains.volume)
    injected = state.injected_volume - (state.pressure - model.start_pressure[model.domain]) * hole / bulk
    fractures = sim.fractures
    own = next((f for f in fractures if f.well == 0), None)
    intact = np.array(sim.discs.intact_bonds)
    if own is None:
        nothing = Wing(0.0, math.nan, math.nan, math.nan, True)
        return Fracture(0.0, 0.0, net, 0.0, injected, 0.0, sim.crack_count, 0, 0.0, int((intact == 0).sum()), (nothing, nothing))
    cracks = sim.cracks  # with their fractures
    mine = cracks[cracks.fracture == own.index]
    middle, bonds = np.array(mine.position), np.array(mine.bond)
    position, moved = np.array(sim.discs.position), np.array(sim.discs.displacement)
    pressure, centres = np.array(sim.domains.pressure), np.array(sim.domains.centre)
    aperture, flow = np.array(sim.pipes.aperture), np.array(sim.pipes.flow)
    gap, floor = np.array(sim.bonds.gap), 1e-5
    jump = _jumps(model, middle, position, moved, intact)
    graph = _graph(model, bonds, middle, centres)
    far, _ = _ways(graph, model.domain, np.ones(len(bonds)))
    _, before = _ways(graph, model.domain, 1.0 / np.maximum(aperture[bonds], 1e-7) ** 3)
    pores = set(int(d) for d in model.pipe_domains[bonds].ravel()) - {0, model.domain}
    along = sum(volume_now[d] - model.start_volume[d] for d in pores)
    gained = along + volume_now[model.domain] - hole
    # A hole widens under its pressure without a fracture, too: of it the fracture has what it opens on either side.
    offset = middle - model.centre
    distance = np.hypot(*offset.T)
    heading = np.array([math.cos(own.azimuth), math.sin(own.azimuth)])
    mouth = model.well_radius + 5.0 * model.mean_radius(model.centre)
    mouths = [jump[(sign * (offset @ heading) > 0) & (distance < mouth)] for sign in (1.0, -1.0)]
    volume = along + model.well_radius * sum(float(np.median(m)) for m in mouths if len(m) > 0)
    wings = []
    normal = np.array(mine.normal)
    half = 0.5 * np.array(mine.length)
    ends = np.concatenate([middle + half[:, None] * np.stack([-normal[:, 1], normal[:, 0]], 1),
                           middle - half[:, None] * np.stack([-normal[:, 1], normal[:, 0]], 1)]) - model.centre
    azimuth = own.azimuth
    axis = np.array([math.cos(azimuth), math.sin(azimuth)])
    for sign in (1.0, -1.0):
        mine_ends = ends[sign * (ends @ axis) > 0]
        reach = max([model.well_radius] + [float(d) for d in np.hypot(*mine_ends.T)])
        side = [d for d in far if d not in (0, model.domain) and sign * ((centres[d] - model.centre) @ axis) > 0]
        if not side:
            wings.append(Wing(reach, math.nan, math.nan, math.nan, True))
            continue
        node, path = max(side, key=lambda d: far[d]), []
        while node != model.domain:
            parent, k = before[node]
            path.append((parent, node, k))
            node = parent
        path.reverse()
        hydraulic = mechanical = by_gap = by_pore = 0.0
        ways = {d: 0.0 for step in path for d in step[:2]}  # of the fracture through each pore
        for parent, node, k in path:
            for d in (parent, node):
                ways[d] += 0.0 if d == model.domain else math.dist(centres[d], middle[k])
        monotone, last = True, pressure[model.domain]
        lowest = max(1e-4, 0.3 * max(jump.max(), 0.0))
        for parent, node, k in path:
            bond = bonds[k]
            drop, through = abs(pressure[parent] - pressure[node]), abs(flow[bond])
            if jump[k] < lowest or through <= 0.0 or aperture[bond] <= 0.0:
                continue  # the tip
            if pressure[node] > last + 0.01 * abs(net):
                monotone = False
            last = pressure[node]
            way = 0.0
            for d in (parent, node):
                way += 0.0 if d == model.domain else math.dist(centres[d], middle[k])
            mechanical += way / jump[k] ** 3
            hydraulic += drop / (12.0 * viscosity * through)
            discs = model.bond_discs[bond]
            by_gap += float(model.radius[discs].sum()) / max(gap[bond], floor) ** 3
            opened, length_through = 0.0, 0.0
            for d in (parent, node):
                if d != model.domain:
                    opened += volume_now[d] - model.start_volume[d]
                    length_through += ways[d]
            if length_through > 0.0:
                by_pore += way / max(opened / length_through, floor) ** 3
        length = sum(0.0 if p == model.domain else math.dist(centres[p], centres[n]) for p, n, _ in path)
        enough = len(path) >= 4 and mechanical > 0.0 and hydraulic > 0.0 and length > 0.0
        ratios = [(mechanical / each) ** (1.0 / 3.0) if enough else math.nan for each in (hydraulic, by_gap, by_pore)]
        wings.append(Wing(reach, *ratios, monotone))
    # What a user reads, where a fracture's opening is its own; of contacts, whose gaps are not it, the jump between the flanks.
    opened = np.array(mine.aperture) if model.facets else jump
    half = 0.5 * (wings[0].length + wings[1].length)
    xi = (offset @ heading - 0.5 * (wings[0].length - wings[1].length)) / half
    return Fracture(
        half, _in_the_middle(opened, xi, shape), net, volume, injected, gained,
        len(cracks), own.wings, math.degrees(azimuth), int((intact == 0).sum()), (wings[0], wings[1]),
    )
