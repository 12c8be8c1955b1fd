#!/usr/bin/python3
"""What a run writes reads back with h5py and ParaView, and read_back.py finds every kind of damage done to it.

Called by CTest with the program as the only argument.
"""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy as np

READ_BACK = pathlib.Path(__file__).with_name("read_back.py")
PROGRAM = sys.argv.pop() if len(sys.argv) > 1 else "ashlar"

# Two element shapes, a joint, a stage without and one with heat; no output declared: everything is written.
DECK = """
model "pair" { reference_temperature = 12*degC }
box "rock" { from = {0,0,0}, to = {2*m,1*m,1*m}, cells = {2,1,2} }
box "dam"  { from = {2*m,0,0}, to = {4*m,1*m,1*m}, cells = {2,1,2}, elements = "wedge6" }
surface "left"  { of = "rock", side = "left" }
surface "right" { of = "dam", side = "right" }
material "stone" { region = { "rock", "dam" }, density = 2400*kg/m^3, young = 20*GPa, poisson = 0.2, conductivity = 2.7*W/(m*K) }
joint "contact" { between = { "rock", "dam" }, law = "brittle", tensile_strength = 2*MPa, cohesion = 3*MPa, friction = 45*deg }
fix "wall" { surface = "left", x = 0, y = 0, z = 0 }
gravity { z = -9.81 }
stage "gravity" { solve = static {} }
stage "summer"  { apply = { fixed_temperature { surface = "left", value = 10*degC },
                            fixed_temperature { surface = "right", value = 30*degC } }, solve = thermal { steady = true } }
history "tip"  { at = { 4*m, 0, 1*m }, record = { "displacement", "temperature" } }
history "wall" { surface = "left", record = { "reaction" } }
"""


def swapped(path, old, new):
    text = path.read_text(encoding="utf-8")
    assert old in text, old
    path.write_text(text.replace(old, new), encoding="utf-8")


def change(path, change_file):
    with h5py.File(path, "r+") as file:
        change_file(file)


def set_row(dataset, value):
    def setter(file):
        file[dataset][-1] = value
    return setter


DAMAGE = {
    "times do not grow": lambda run: change(run / "results.vtkhdf", set_row("VTKHDF/Steps/Values", 0.5)),
    "Offsets do not fit the types": lambda run: change(run / "results.vtkhdf", set_row("VTKHDF/Types", 12)),
    "stress is not finite": lambda run: change(run / "results.vtkhdf", set_row("VTKHDF/CellData/stress", np.nan)),
    "offsets of opening": lambda run: change(run / "interfaces.vtkhdf", set_row("VTKHDF/Steps/PointDataOffsets/opening", 0)),
    "finds other values of temperature": lambda run: swapped(run / "results.xdmf", "/Steps/00002/temperature",
                                                             "/Steps/00001/temperature"),
    "finds times": lambda run: swapped(run / "interfaces.xdmf", '<Time Value="2"/>', '<Time Value="3"/>'),
    "lacks units": lambda run: swapped(run / "history_tip.csv", " [degC]", ""),
    "which is not there": lambda run: (run / "history_wall.csv").unlink(),
}


class ReadBack(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.place.name)
        deck = cls.folder / "pair.lua"
        deck.write_text(DECK, encoding="utf-8")
        cls.run_folder = cls.folder / "pair.run"
        answer = subprocess.run([PROGRAM, "run", deck, "--out", cls.run_folder], capture_output=True, text=True)
        assert answer.returncode == 0, answer.stdout + answer.stderr

    @classmethod
    def tearDownClass(cls):
        cls.place.cleanup()

    def read_back(self, folder):
        return subprocess.run([READ_BACK, folder], capture_output=True, text=True)

    def test_the_run_reads_back(self):
        answer = self.read_back(self.run_folder)
        self.assertEqual(answer.returncode, 0, answer.stdout + answer.stderr)
        self.assertIn("2 steps at 1, 2; ", answer.stdout)
        self.assertIn("cells 4 of type 12, 8 of type 13", answer.stdout)
        self.assertIn("8 points; cells 2 of type 9", answer.stdout)

    def test_temperature_is_the_reference_first_and_then_falls_linearly_to_the_left(self):
        with h5py.File(self.run_folder / "results.vtkhdf", "r") as file:
            x = file["VTKHDF/Points"][:, 0]
            self.assertTrue((file["Steps/00001/temperature"][()] == 12).all())
            np.testing.assert_allclose(file["Steps/00002/temperature"][()], 10 + 5 * x, atol=1e-6)

    def test_manifest_names_the_deck_by_its_hash(self):
        deck = json.loads((self.run_folder / "manifest.json").read_text(encoding="utf-8"))["deck"]
        wanted = subprocess.run(["sha256sum", deck["file"]], capture_output=True, text=True, check=True).stdout.split()[0]
        self.assertEqual(deck["sha256"], wanted)

    def test_every_damage_is_found(self):
        for words, damage in DAMAGE.items():
            with self.subTest(words):
                copy = self.folder / "copy.run"
                shutil.rmtree(copy, ignore_errors=True)
                shutil.copytree(self.run_folder, copy)
                damage(copy)
                answer = self.read_back(copy)
                self.assertEqual(answer.returncode, 1, answer.stdout)
                self.assertIn(words, answer.stderr)


if __name__ == "__main__":
    unittest.main()
