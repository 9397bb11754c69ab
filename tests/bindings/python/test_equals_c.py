"""The same case gives the same numbers as the C program report.c, bit for bit."""
import os
import struct
import subprocess
import unittest

from support import CASE, plain, small

MASK = 2**64 - 1


def mix(total, bits):
    return (((total << 1) | (total >> 63)) & MASK) ^ (bits & MASK)


def bits_of(value):
    return struct.unpack("<Q", struct.pack("<d", value))[0]


def signed(bits):
    return bits - 2**64 if bits >= 2**63 else bits


def field_line(sim, name):
    rows = [row if isinstance(row, list) else [row] for row in plain(sim.field(name))]
    total = 0
    for row in rows:
        for value in row:
            total = mix(total, bits_of(value) if isinstance(value, float) else value)
    return f"{name} {len(rows[0])} {len(rows)} {signed(total)}"


def report():
    with small() as sim:
        sim.step(5)
        state, cracks, fractures = sim.state, sim.cracks, sim.fractures
        total = 0
        for crack in cracks:
            total = mix(mix(total, int(crack.bond)), bits_of(crack.aperture))
            total = mix(mix(total, bits_of(crack.position[1])), int(crack.disc[1]))
        yield f"hash {sim.state_hash}"
        yield f"state {state.step} {state.cycles} {signed(bits_of(state.time))}"
        yield f"cracks {len(cracks)} {signed(total)}"
        yield f"fractures {len(fractures)} {signed(bits_of(fractures[0].length))}"
        for name in ("disc.position", "disc.radius", "disc.stress", "disc.intact_bonds", "bond.discs",
                     "bond.normal_force", "pipe.aperture", "domain.pressure", "domain.kind"):
            yield field_line(sim, name)


class EqualsC(unittest.TestCase):
    @unittest.skipUnless("HFRAC_REPORT" in os.environ, "HFRAC_REPORT does not name the C program")
    def test_every_line(self):
        program = subprocess.run([os.environ["HFRAC_REPORT"], CASE], check=True, capture_output=True, text=True)
        self.assertEqual(list(report()), program.stdout.splitlines())
