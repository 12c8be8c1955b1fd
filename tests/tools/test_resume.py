#!/usr/bin/python3
"""Runs that are killed and go on: the same bits as runs that nothing stopped, and results that can be read at any moment.

Called by CTest with the path of the program as the only argument.
"""
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import h5py

PROGRAM = pathlib.Path(sys.argv.pop() if len(sys.argv) > 1 else "build/ashlar").resolve()
OFTEN = ("--checkpoint-every", "2e-4")  # 12 ms

# A wall of two blocks on a joint: every kind of stage. Its runs take about a second.
WALL = """
local args = deck.args { stages = { default = "heat", doc = "which stages" }, duration = { default = 1, doc = "of them" } }
model "wall" { reference_temperature = 10*degC }
box "under" { from = {0,0,0}, to = {2*m,1*m,1*m}, cells = {8,4,4} }
box "over" { from = {0,0,1*m}, to = {2*m,1*m,2*m}, cells = {8,4,4} }
material "concrete" {
  region = { "under", "over" }, density = 2400*kg/m^3, young = 20*GPa, poisson = 0.2, conductivity = 2*W/(m*K),
  heat_capacity = 900*J/(kg*K), expansion = 1e-5/K, LAW
}
joint "joint" { between = { "under", "over" }, law = "brittle", tensile_strength = 0.05*MPa, cohesion = 5*MPa, friction = 0.7 }
surface "sides" { of = { "under", "over" }, side = { "left", "right" } }
fix { surface = "under.bottom", x = 0, y = 0, z = 0 }
gravity { z = -9.81 }
history "top" { at = {2*m,1*m,2*m}, record = { "displacement", VELOCITY "temperature", "stress" } }
history "foot" { surface = "under.bottom", record = { "reaction", "load" } }
output "all" { every = 1, record = { "displacement", "stress", "temperature", "opening", "slip", "traction", "broken" } }
"""
HEAT = """
stage "rest" { solve = static { tolerance = 1e-6 }, reset_displacement = true }
stage "warm" { apply = { fixed_temperature { surface = "sides", value = in_time(function(t) return 40 + t / 3600 end) } },
  solve = thermal { duration = args.duration * 7200*s, record_every = 60*s } }
stage "cold" { apply = { fixed_temperature { surface = "sides", value = in_time(function(t) return -20 + t / 3600 end) } },
  solve = thermal { duration = args.duration * 7200*s, record_every = 60*s } }
"""
CRACKS = """
stage "rest" { solve = static { tolerance = 1e-6 } }
stage "warm" { apply = { fixed_temperature { surface = "sides", value = 30*degC } }, solve = thermal { steady = true } }
stage "cold" { apply = { fixed_temperature { surface = "over.top", value = -30*degC } }, solve = thermal { steady = true } }
stage "cracks" { solve = fracture { from = "warm", to = "cold", increments = 8, tolerance = 1e-6 } }
stage "after" { apply = { pressure { surface = "over.top", value = 0.2*MPa }, grouting { of = "joint" } },
  solve = static { tolerance = 1e-6, increments = 4 } }
"""
SHAKE = """
stage "rest" { solve = static { tolerance = 1e-6 } }
stage "shake" { apply = { traction { surface = "over.left", x = in_time(function(t) return 2e5 * math.sin(300 * t) end) } },
  solve = dynamic { duration = args.duration * 0.05*s, record_every = 0.002*s, stiffness_damping = 1e-6, mass_damping = 1 } }
stage "swing" { solve = dynamic { duration = 0.01*s } }
"""
SEASONS = """
crack_water { of = "joint", level = in_time(function(t) return 1.1 + t / 60000 end) }
stage "rest" { solve = static { tolerance = 1e-6 } }
stage "year" { apply = { fixed_temperature { surface = "sides", value = in_time(function(t) return 10 - t / 400 end) } },
  solve = coupled { duration = 12000*s, every = 600*s, tolerance = 1e-6 } }
stage "after" { solve = static { tolerance = 1e-6 } }
"""
FACTOR = """
stage "rest" { solve = static { tolerance = 1e-6, increments = 3 } }
stage "factor" { solve = strength_reduction { between = { 1, 64 }, width = 1, tolerance = 1e-5, max_steps = 400 } }
stage "push" { apply = { pressure { surface = "over.left", value = 0.1*MPa } }, solve = static { tolerance = 1e-6 } }
"""
# A deck of its own: a block falls on the edge of the ground, tumbles and slides.
TUMBLE = """
model "tumble" {}
box "ground" { from = {-1,-1,-0.2}, to = {0.05,1,0}, cells = {3,4,1} }
box "block" { from = {-0.1,-0.1,-0.1}, to = {0.1,0.1,0.1}, cells = {2,2,2},
  x = function(x, y, z) return 0.8 * x + 0.6 * z end, z = function(x, y, z) return 0.2 - 0.6 * x + 0.8 * z end }
material "rock" { region = { "ground", "block" }, density = 2500*kg/m^3, young = 5*GPa, poisson = 0.2 }
joint "contact" { between = { "ground", "block" }, law = "frictional", friction = 20*deg,
  normal_stiffness = 5e9*Pa/m, shear_stiffness = 5e9*Pa/m }
surface "held" { of = "ground" }
fix { surface = "held", x = 0, y = 0, z = 0 }
gravity { x = 3, z = -9.81 }
history "middle" { at = {0,0,0.2*m}, record = { "displacement", "velocity", "stress" } }
history "all" { record = { "energy" } }
output "all" { every = 5, record = { "displacement", "stress" } }
stage "fall" { solve = dynamic { duration = 0.4*s, record_every = 0.01*s, large_displacement = true, contact_damping = 1e-5 } }
stage "slide" { solve = dynamic { duration = 0.4*s, record_every = 0.01*s, large_displacement = true, mass_damping = 1 } }
"""
PLASTIC = 'law = "mohr_coulomb", cohesion = 1*MPa, friction = 30*deg'


class Resume(unittest.TestCase):
    def setUp(self):
        self.place = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.place.name)
        self.environment = os.environ | {"OMP_WAIT_POLICY": "passive"}

    def tearDown(self):
        self.place.cleanup()

    def deck(self, stages, law=""):
        velocity = '"velocity",' if "dynamic" in stages else ""
        deck = stages if "model" in stages else WALL.replace("LAW", law).replace("VELOCITY", velocity) + stages
        (self.folder / "wall.lua").write_text(deck, encoding="utf-8")

    def ashlar(self, *words, code=0):
        answer = subprocess.run([PROGRAM, *words], cwd=self.folder, env=self.environment, capture_output=True, text=True)
        self.assertEqual(answer.returncode, code, f"{words}\n{answer.stdout}{answer.stderr}")
        return answer

    def start(self, *words):
        return subprocess.Popen([PROGRAM, *words], cwd=self.folder, env=self.environment, stdout=subprocess.DEVNULL)

    def within(self, run):
        """0-based stage and number of history rows of the checkpoint within a stage; none: no such file."""
        try:
            with h5py.File(self.folder / run / "checkpoint_within_stage.h5") as file:
                return int(file.attrs["stage"]), int(file["numbers/history.count"][0])
        except OSError:  # not there, or no longer
            return None

    def kill_within(self, run, stage, rows, *words):
        """Starts a run and kills it where there is a checkpoint within a stage, and so many history rows."""
        program = self.start(*words, *OFTEN)
        while True:
            program.send_signal(signal.SIGSTOP)  # what is found is what it is killed with
            found = self.within(run)
            if found is not None and found >= (stage, rows):
                break
            self.assertIsNone(program.poll(), "the run came to its end")
            program.send_signal(signal.SIGCONT)
            time.sleep(1e-3)
        program.kill()
        program.wait()
        self.assertEqual(found[0], stage)

    def read_all(self, run):
        """Reads every dataset of every result file; how many outputs there are."""
        outputs = 0
        for path in sorted((self.folder / run).glob("*.vtkhdf")):
            with h5py.File(path) as file:
                outputs = len(file["Steps"])
                self.assertIn(file["VTKHDF/Steps"].attrs["NSteps"], (outputs, outputs - 1))
                file.visititems(lambda _, thing: thing[()] if isinstance(thing, h5py.Dataset) else None)
        return outputs

    def expect_same(self, whole, resumed):
        self.assertIn("same bits", self.ashlar("compare", whole, resumed, "--tolerance", "0").stdout)
        for table in (self.folder / whole).glob("*.csv"):
            self.assertEqual(table.read_bytes(), (self.folder / resumed / table.name).read_bytes(), table.name)
        self.read_all(resumed)

    def expect_to_go_on(self, stages, kills, law="", extra=()):
        """`kills`: (stage, history rows) within which the run is killed, one after another."""
        self.deck(stages, law)
        self.ashlar("run", "wall.lua", "--out", "whole", "--threads", "1", *extra)
        words = ("run", "wall.lua", "--out", "killed", "--threads", "1", *extra)
        for stage, rows in kills:
            self.kill_within("killed", stage, rows, *words)
            words = ("resume", "killed", "--threads", "2")
        answer = self.ashlar(*words)
        self.assertIn("goes on within stage", answer.stdout)
        self.expect_same("whole", "killed")
        self.ashlar("resume", "killed", code=2)  # nothing is left to do

    def test_a_transient_goes_on(self):
        self.expect_to_go_on(HEAT, [(1, 10), (2, 60)])

    def test_a_transient_in_single_precision_goes_on(self):
        self.expect_to_go_on(HEAT, [(1, 10), (2, 60)], extra=("--precision", "single"))

    def test_a_staged_fracture_and_load_increments_go_on(self):
        self.expect_to_go_on(CRACKS, [(3, 6), (4, 13)])

    def test_plastic_load_increments_go_on(self):
        self.expect_to_go_on(CRACKS, [(0, 5), (3, 27)], PLASTIC)

    def test_a_motion_goes_on(self):
        self.expect_to_go_on(SHAKE, [(1, 8), (1, 20), (2, 40)])

    def test_a_motion_in_single_precision_goes_on(self):
        self.expect_to_go_on(SHAKE, [(1, 8)], extra=("--precision", "single"))

    def test_blocks_that_move_far_go_on(self):
        self.expect_to_go_on(TUMBLE, [(0, 20), (1, 50)])

    def test_a_coupled_stage_goes_on(self):
        self.expect_to_go_on(SEASONS, [(1, 8), (1, 14)])

    def test_a_coupled_stage_in_single_precision_goes_on(self):
        self.expect_to_go_on(SEASONS, [(1, 9)], extra=("--precision", "single"))

    def test_a_strength_reduction_goes_on(self):
        self.expect_to_go_on(FACTOR, [(1, 4)], PLASTIC)

    def test_results_can_be_read_whenever_the_run_is_killed(self):
        self.deck(HEAT)
        started = time.monotonic()
        self.ashlar("run", "wall.lua", "--out", "whole", "--threads", "1")
        lasts = time.monotonic() - started
        chance = random.Random(4)
        for number in range(10):
            run = f"killed_{number}"
            program = self.start("run", "wall.lua", "--out", run, "--threads", "1", *OFTEN)
            time.sleep(lasts * chance.random())
            program.kill()
            program.wait()
            self.read_all(run)
            if number % 5 == 4 and (self.folder / run / "manifest.json").exists():
                if program.returncode == -signal.SIGKILL:
                    self.ashlar("resume", run)
                self.expect_same("whole", run)
            shutil.rmtree(self.folder / run, ignore_errors=True)

    def test_a_run_that_was_interrupted_says_how_to_go_on(self):
        self.deck(HEAT)
        self.ashlar("run", "wall.lua", "--out", "whole")
        with subprocess.Popen([PROGRAM, "run", "wall.lua"], cwd=self.folder, env=self.environment,
                              stdout=subprocess.PIPE, text=True) as program:
            while "stage 2" not in program.stdout.readline():
                pass
            program.send_signal(signal.SIGINT)
            rest = program.stdout.read()
        self.assertEqual(program.returncode, 130)
        self.assertIn("to go on: ashlar resume wall.run", rest)
        self.assertEqual(self.within("wall.run")[0], 1)
        elsewhere = self.folder / "elsewhere"
        elsewhere.mkdir()
        answer = subprocess.run([PROGRAM, "resume", "../wall.run"], cwd=elsewhere, env=self.environment,
                                capture_output=True, text=True)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.expect_same("whole", "wall.run")

    def test_another_deck_is_refused(self):
        self.deck(HEAT)
        self.kill_within("wall.run", 1, 8, "run", "wall.lua", "--set", "duration=2")
        whole = (self.folder / "wall.lua").read_text(encoding="utf-8")
        (self.folder / "wall.lua").write_text(whole.replace("20*GPa", "30*GPa"), encoding="utf-8")
        answer = self.ashlar("resume", "wall.run", code=2)
        self.assertIn("the run was of wall.lua with sha256", answer.stderr)
        self.assertIn("--force", answer.stderr)
        (self.folder / "wall.lua").write_text(whole, encoding="utf-8")
        self.ashlar("resume", "wall.run")
        self.ashlar("run", "wall.lua", "--out", "whole", "--set", "duration=2")
        self.expect_same("whole", "wall.run")


if __name__ == "__main__":
    unittest.main()
