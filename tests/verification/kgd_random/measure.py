# SPDX-License-Identifier: BSD-3-Clause
"""What a fracture in a packing is, in the numbers of the KGD bench, read through the Python binding.

A wing is the way of least resistance through broken bonds from the well's pore to the farthest pore of that side (round a disc that
hangs in the fracture there are two, one of them shut). Its mechanical aperture u is the jump of displacement of a crack's two discs across
the line of the cracks within three mean radii, and lies along the way's projection on that line; its hydraulic one follows from pressures
and flows. A state just after a bond broke has the pressures of then and the flows of before, so that it says nothing about apertures.
The jump between the nearest three discs of either flank, which are up to three radii off the fracture, is `flank`.
"""
import heapq
import math
from typing import Any, Callable, Dict, List, NamedTuple, Sequence, Set, Tuple

import numpy as np


class Wing(NamedTuple):
    """One side of the fracture."""

    length: float  # m, from the middle of the well
    ratio: float  # effective hydraulic over mechanical aperture; nan: too short
    by_flanks: float  # the same over the jump between the flanks, along the way from pore to pore
    rise: float  # most that pressure rises from a pore to the next on the way to the tip, over the net pressure; up to 0.01 it falls


class Fracture(NamedTuple):
    """The fracture of the well."""

    length: float  # m, half of tip to tip with the hole
    width: float  # m, in the middle, by the openings at 0.25 to 0.75 of the half length and the formula's shape: median
    pressure: float  # Pa, of the well over sigma_hmin
    volume: float  # m2, gained by the pores beside its cracks, and its opening times the hole's width
    injected: float  # m2, less what the fluid in the hole is compressed by
    pores: float  # m2, gained by hole and pores beside its cracks
    reported: float  # m2, volume of the fracture as the program reports it, without the hole
    wall_leak: float  # m2/s, out of the hole through the rock at its wall now
    stretched: float  # m2, of what its pores gained: before their first bonds broke, as rock (to a step)
    balanced: float  # m2, the same by the fluid's balance: injected less what hole, rock pores and the outside took
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
        self.storing = self.start_volume  # m2, of stiff grains: without rock.grain_modulus
        self.last_volume = self.start_volume
        self.stretched: Dict[int, float] = {}  # m2, by pore of the fracture: gained before its first bond broke, as rock
        self.kind = np.array(sim.domains.kind)
        self.radius = np.array(sim.discs.radius)
        self.bond_discs = np.array(sim.bonds.discs)
        self.position = np.array(sim.discs.position)
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


def _lines(model: Model, middle: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """At each crack: unit vector along the cracks within three mean radii, and their mean offset from it across that."""
    along, across = np.zeros((len(middle), 2)), np.zeros(len(middle))
    for k, at in enumerate(middle):
        near = middle[np.hypot(*(middle - at).T) <= 3.0 * model.mean_radius(at)] - at
        spread = (near - near.mean(axis=0)).T @ (near - near.mean(axis=0)) if len(near) > 1 else np.diag([1.0, 0.0])
        along[k] = np.linalg.eigh(spread)[1][:, 1]
        across[k] = (near @ _normal(along[k])).mean()
    return along, across


def _normal(along: np.ndarray) -> np.ndarray:
    return np.array([-along[1], along[0]])


def _flanks(model: Model, middle: np.ndarray, lines: Tuple[np.ndarray, np.ndarray], position: np.ndarray, moved: np.ndarray, intact: np.ndarray) -> np.ndarray:
    """Opening at each crack between the nearest three discs of either flank that still have two bonds."""
    result = np.zeros(len(middle))
    for k, at in enumerate(middle):
        normal = _normal(lines[0][k])
        offset = position - at
        flank = (np.hypot(*offset.T) <= 3.0 * model.mean_radius(at)) & (intact >= 2)
        side = offset @ normal - lines[1][k]
        up, down = flank & (side > 0), flank & (side < 0)
        if up.any() and down.any():
            def mean(chosen: np.ndarray) -> float:
                index = np.flatnonzero(chosen)
                index = index[np.argsort(np.hypot(*offset[index].T))[:3]]
                return float((moved[index] @ normal).mean())
            result[k] = mean(up) - mean(down)
    return result


def _jumps(model: Model, bonds: np.ndarray, along: np.ndarray, moved: np.ndarray) -> np.ndarray:
    """Opening at each crack between its own two discs, across the line of cracks."""
    first, second = model.bond_discs[bonds].T
    normal = np.stack([-along[:, 1], along[:, 0]], axis=1)
    facing = np.sign(((model.position[second] - model.position[first]) * normal).sum(axis=1))
    return facing * ((moved[second] - moved[first]) * normal).sum(axis=1)


class Step(NamedTuple):
    """A crack on the way along a wing, from pore `parent` to pore `node`."""

    parent: int
    node: int
    flow: float  # m2/s
    opened: float  # m
    flank: float  # m
    along: np.ndarray  # unit vector of the line of cracks
    middle: np.ndarray  # m


def _wing(model: Model, reach: float, steps: List[Step], centres: np.ndarray, pressure: np.ndarray, viscosity: float, net: float) -> Wing:
    """Resistance to flow along a wing, seen by its fluid and by its openings, without the last cracks that are hardly open: the tip."""
    hydraulic = mechanical = by_flanks = 0.0
    rise, last = 0.0, pressure[model.domain]
    lowest = max(1e-4, 0.3 * max(step.opened for step in steps))
    for step in steps:
        if step.opened < lowest or step.flow <= 0.0 or step.flank <= 0.0:
            continue
        rise = max(rise, (pressure[step.node] - last) / max(net, 1.0))
        last = pressure[step.node]
        ends = [step.middle if d == model.domain else centres[d] for d in (step.parent, step.node)]
        mechanical += abs((ends[1] - ends[0]) @ step.along) / step.opened**3
        by_flanks += sum(math.dist(end, step.middle) for end in ends) / step.flank**3
        hydraulic += abs(pressure[step.parent] - pressure[step.node]) / (12.0 * viscosity * step.flow)
    enough = len(steps) >= 4 and hydraulic > 0.0
    ratios = [(each / hydraulic) ** (1.0 / 3.0) if enough else math.nan for each in (mechanical, by_flanks)]
    return Wing(reach, ratios[0], ratios[1], float(rise))


def _stored_elsewhere(model: Model, pores: Set[int], volume_now: np.ndarray, pressure: np.ndarray, bulk: float) -> float:
    """What holes, rock pores and, by being compressed, the pores of the fracture took of the fluid [m2]."""
    squeezed = model.storing * (pressure - model.start_pressure) / bulk
    opened = volume_now - model.start_volume
    opened[list(pores)] = 0.0
    inside = model.kind != 2
    return float((squeezed + opened)[inside].sum())


def _wall_leak(model: Model, cracks: Sequence[int]) -> float:
    flow = np.array(model.sim.pipes.flow)
    flow[list(cracks)] = 0.0
    left, right = model.pipe_domains.T
    return float(flow[left == model.domain].sum() - flow[right == model.domain].sum())


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
        nothing = Wing(0.0, math.nan, math.nan, 0.0)
        return Fracture(0.0, 0.0, net, 0.0, injected, 0.0, 0.0, _wall_leak(model, []), 0.0, 0.0, sim.crack_count, 0, 0.0, int((intact == 0).sum()), (nothing, nothing))
    cracks = sim.cracks  # with their fractures
    mine = cracks[cracks.fracture == own.index]
    middle, bonds = np.array(mine.position), np.array(mine.bond)
    position, moved = np.array(sim.discs.position), np.array(sim.discs.displacement)
    pressure, centres = np.array(sim.domains.pressure), np.array(sim.domains.centre)
    aperture, flow = np.array(sim.pipes.aperture), np.array(sim.pipes.flow)
    lines = _lines(model, middle)
    jump, opened = _flanks(model, middle, lines, position, moved, intact), _jumps(model, bonds, lines[0], moved)
    graph = _graph(model, bonds, middle, centres)
    far, _ = _ways(graph, model.domain, np.ones(len(bonds)))
    _, before = _ways(graph, model.domain, 1.0 / np.maximum(aperture[bonds], 1e-7) ** 3)
    pores = set(int(d) for d in model.pipe_domains[bonds].ravel()) - {0, model.domain}
    for d in pores - model.stretched.keys():
        model.stretched[d] = float(model.last_volume[d] - model.start_volume[d])
    model.last_volume = volume_now
    along = sum(volume_now[d] - model.start_volume[d] for d in pores)
    gained = along + volume_now[model.domain] - hole
    balanced = state.injected_volume - sim.balance.leaked_volume - _stored_elsewhere(model, pores, volume_now, pressure, bulk)
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
            wings.append(Wing(reach, math.nan, math.nan, 0.0))
            continue
        node, path = max(side, key=lambda d: far[d]), []
        while node != model.domain:
            parent, k = before[node]
            path.append((parent, node, k))
            node = parent
        path.reverse()
        steps = [Step(parent, node, abs(flow[bonds[k]]), opened[k], jump[k], lines[0][k], middle[k]) for parent, node, k in path]
        wings.append(_wing(model, reach, steps, centres, pressure, viscosity, abs(net)))
    # What a user reads, where a fracture's opening is its own; of contacts, whose gaps are not it, the jump between the flanks.
    read = np.array(mine.aperture) if model.facets else jump
    half = 0.5 * (wings[0].length + wings[1].length)
    xi = (offset @ heading - 0.5 * (wings[0].length - wings[1].length)) / half
    return Fracture(
        half, _in_the_middle(read, xi, shape), net, volume, injected, gained, own.volume, _wall_leak(model, bonds), sum(model.stretched.values()), balanced,
        len(cracks), own.wings, math.degrees(azimuth), int((intact == 0).sum()), (wings[0], wings[1]),
    )
