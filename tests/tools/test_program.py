#!/usr/bin/python3
"""The program as a user meets it: exit codes, what it prints where, folders that are not overwritten, Ctrl-C.

Called by CTest with the path of the program as the only argument.
"""
import csv
import json
import os
import pathlib
import pty
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from xml.etree import ElementTree

import h5py

PROGRAM = pathlib.Path(sys.argv.pop() if len(sys.argv) > 1 else "build/ashlar").resolve()

DECK = """
local args = deck.args { load = { default = 1, unit = MPa, doc = "pull" } }
model "bar" {}
box "bar" { from = {0,0,0}, to = {4*m,1*m,1*m}, cells = {4,1,1} }
material "steel" { region = "bar", density = 7800, young = 200*GPa, poisson = 0, conductivity = 45, heat_capacity = 460 }
surface "left" { of = "bar", side = "left" }
surface "right" { of = "bar", side = "right" }
fix { surface = "left", x = 0, y = 0, z = 0 }
traction { surface = "right", x = args.load }
EXTRA
stage "pull" { solve = static { tolerance = 1e-8 } }
history "end" { at = {4,0,0}, record = { "displacement" } }
expect "Hooke" { history = "end", component = "displacement.x", value = 0.02*mm, relative = 1e-4 }
"""


BRITTLE = 'crackable "bar" { region = "bar", law = "brittle", tensile_strength = 1*MPa, cohesion = 9*MPa, friction = 0.1 }'
ENDLESS = """stage "heat" {
  apply = { fixed_temperature { surface = "left", value = 20*degC } }, solve = thermal { duration = 1e12 },
}"""

# Case P28, outer cone.
ROCK = """model "rock" {}
material "rock" {
  region = "rock", law = "drucker_prager", density = 2400*kg/m^3, young = 10*GPa, poisson = 0.2,
  cohesion = 1.2*MPa, friction = 35*deg, match = "outer",
}
"""


class Program(unittest.TestCase):
    def setUp(self):
        self.place = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.place.name)
        self.environment = os.environ | {"OMP_WAIT_POLICY": "passive"}

    def tearDown(self):
        self.place.cleanup()

    def deck(self, extra=""):
        (self.folder / "bar.lua").write_text(DECK.replace("EXTRA", extra), encoding="utf-8")

    def ashlar(self, *words):
        return subprocess.run([PROGRAM, *words], cwd=self.folder, env=self.environment, capture_output=True, text=True)

    def test_a_good_run_exits_0_and_says_what_it_did_in_plain_lines(self):
        self.deck()
        answer = self.ashlar("run", "bar.lua")
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertNotIn("\r", answer.stdout)
        for words in ("stage 1 pull: static", "pull (static): converged", "ok      Hooke", "bar.run/results.xdmf"):
            self.assertIn(words, answer.stdout)
        again = self.ashlar("info", "bar.run")
        self.assertEqual(again.returncode, 0)
        self.assertTrue(answer.stdout.endswith(again.stdout))

    def test_an_earlier_run_is_replaced_only_by_force(self):
        self.deck()
        self.assertEqual(self.ashlar("run", "bar.lua").returncode, 0)
        refused = self.ashlar("run", "bar.lua")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("--force", refused.stderr)
        self.assertEqual(self.ashlar("run", "bar.lua", "--force").returncode, 0)
        self.assertEqual(self.ashlar("run", "bar.lua", "--out", "other").returncode, 0)

    def test_compare_says_by_its_exit_code_whether_two_runs_are_within_a_tolerance(self):
        self.deck()
        self.assertEqual(self.ashlar("run", "bar.lua").returncode, 0)
        self.assertEqual(self.ashlar("run", "bar.lua", "--set", "load=1.01", "--out", "other").returncode, 4)
        for tolerance, code in (("0.02", 0), ("0.005", 4)):
            answer = self.ashlar("compare", "other", "bar.run", "--tolerance", tolerance, "--line", "0,0.5,0.5,4,0.5,0.5")
            self.assertEqual(answer.returncode, code, answer.stdout + answer.stderr)
        self.assertIn("displacement       max 1.00e-02", answer.stdout)
        row = [line for line in answer.stdout.splitlines() if line.lstrip().startswith("4  (4, 0.5, 0.5)")][0].split()
        self.assertAlmostEqual(float(row[-1]), 1, delta=1e-3)  # per cent
        same = self.ashlar("compare", "bar.run", "bar.run/results.xdmf", "--tolerance", "0")
        self.assertEqual(same.returncode, 0)
        self.assertIn("same bits", same.stdout)
        (self.folder / "short.lua").write_text(
            (self.folder / "bar.lua").read_text(encoding="utf-8").replace("{4,1,1}", "{2,1,1}"), encoding="utf-8")
        self.assertEqual(self.ashlar("run", "short.lua").returncode, 0)
        refused = self.ashlar("compare", "short.run", "bar.run")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("the meshes differ", refused.stderr)
        self.assertIn("2 and 4 elements", refused.stderr)

    def test_an_exported_mesh_gives_the_same_answer(self):
        self.deck()
        self.assertEqual(self.ashlar("run", "bar.lua").returncode, 0)
        for extension in ("msh", "vtu", "inp"):
            answer = self.ashlar("export", "bar.lua", "--to", "bar_mesh." + extension)
            self.assertEqual(answer.returncode, 0, answer.stderr)
            self.assertIn("4 elements, 20 nodes, 1 region, 8 surfaces", answer.stdout)
            (self.folder / "again.lua").write_text("\n".join(
                line.replace('box "bar"', f'import_mesh {{ file = "bar_mesh.{extension}" }} --')
                for line in DECK.replace("EXTRA", "").split("\n") if not line.startswith("surface")), encoding="utf-8")
            self.assertEqual(self.ashlar("run", "again.lua", "--force").returncode, 0)
            self.assertEqual((self.folder / "again.run/history_end.csv").read_bytes(),
                             (self.folder / "bar.run/history_end.csv").read_bytes())

    def test_export_says_what_it_writes_and_replaces_only_by_force(self):
        self.deck()
        for words in ((), ("--to", "bar.stl"), ("--to", "bar.lua")):
            answer = self.ashlar("export", "bar.lua", *words)
            self.assertEqual(answer.returncode, 2)
            self.assertIn(".inp (CalculiX, Abaqus)", answer.stderr)
        self.assertEqual(self.ashlar("export", "bar.lua", "--to", "bar.msh").returncode, 0)
        refused = self.ashlar("export", "bar.lua", "--to", "bar.msh")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("--force", refused.stderr)

    def test_material_shows_the_strength_that_theory_gives(self):
        (self.folder / "rock.lua").write_text(ROCK, encoding="utf-8")
        answer = self.ashlar("material", "rock.lua", "rock", "--confining", "5", "--to", "rock.csv")
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertIn("uniaxial compression: flows from", answer.stdout)
        curves = {}
        for line in (self.folder / "rock.csv").read_text(encoding="utf-8").splitlines()[1:]:
            test, *numbers = line.split(",")
            curves.setdefault(test, []).append([float(n) for n in numbers])
        for test, strength in (("uniaxial compression", -4.610357e6), ("uniaxial tension", 1.650418e6),
                               ("triaxial compression at 5 MPa", -23.061219e6), ("simple shear", 1.403362e6)):
            self.assertAlmostEqual(curves[test][-1][1] / strength, 1, delta=1e-3, msg=test)
        axial, side = curves["oedometer"][1][1], curves["oedometer"][1][2]
        self.assertAlmostEqual(side / axial, 0.25, delta=1e-6)  # poisson / (1 - poisson) before it flows
        cycle = [row[1] for row in curves["cycle"]]
        self.assertAlmostEqual(min(cycle) / -4.610357e6, 1, delta=1e-3)
        self.assertAlmostEqual(max(cycle) / 1.650418e6, 1, delta=1e-3)
        drawn = self.ashlar("plot", "rock.csv")
        self.assertEqual((drawn.returncode, drawn.stdout), (0, "rock.png\n"), drawn.stderr)
        self.assertGreater((self.folder / "rock.png").stat().st_size, 20000)
        refused = self.ashlar("material", "rock.lua", "rocks")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("did you mean 'rock'", refused.stderr)
        refused = self.ashlar("material", "rock.lua", "rock", "--confining", "5,-1")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("--confining takes positive numbers, not '-1'", refused.stderr)

    def test_a_failed_expect_exits_4(self):
        self.deck()
        answer = self.ashlar("run", "bar.lua", "--set", "load=2")
        self.assertEqual(answer.returncode, 4)
        self.assertIn("FAILED  Hooke", answer.stdout)

    def test_a_stage_that_does_not_converge_exits_3(self):
        self.deck(BRITTLE)  # pulled in two
        answer = self.ashlar("run", "bar.lua", "--set", "load=2")
        self.assertEqual(answer.returncode, 3, answer.stderr)
        self.assertIn("pull (static): block free", answer.stdout)

    def test_wrong_commands_and_decks_exit_2_on_the_error_stream(self):
        self.deck()
        for words in (["rum", "bar.lua"], ["run"], ["run", "absent.lua"], ["run", "bar.lua", "--set", "laod=2"], ["help", "extrud"],
                      ["info", "absent.run"]):
            with self.subTest(words):
                answer = self.ashlar(*words)
                self.assertEqual(answer.returncode, 2, answer.stderr)
                self.assertEqual(answer.stdout, "")
                self.assertNotEqual(answer.stderr, "")

    def test_what_looks_like_a_slip_of_units_or_axes_is_noted_and_nothing_else(self):
        self.deck('gravity { z = -9.81 }')
        self.assertNotIn("note", self.ashlar("check", "bar.lua").stdout)
        extra = """surface "all" { of = "bar" }
        fixed_temperature { surface = "left", value = 293 }
        gravity "sideways" { y = -9.81 }
        gravity "up" { z = 9.81 }
        water_pressure "high" { surface = "right", level = 60 }
        water_pressure "low" { surface = "right", level = -60 }
        stage "heat" { solve = thermal { steady = true } }"""
        self.deck(extra)
        deck = self.folder / "bar.lua"
        deck.write_text(deck.read_text(encoding="utf-8").replace("7800", "7.8").replace("200*GPa", "200")
                        .replace("= 460", "= 0.46").replace("4*m,1*m,1*m", "4e4,1*m,1*m"), encoding="utf-8")
        answer = self.ashlar("check", "bar.lua")
        self.assertEqual(answer.returncode, 0, answer.stderr)
        said = " ".join(answer.stdout.replace("\nnote", "\n").split())
        for words in ("bar.lua:3: the model is 40000 m long",
                      "bar.lua:5: material 'steel': 'density' is 7.8 kg/m^3, unusually small",
                      "'heat_capacity' is 0.46 J/(kg*K)", "'young' is 200 Pa, unusually small; bare numbers are Pa",
                      "'value' is 293 degC; is it in kelvin? That would be 19.85*degC", "gravity 'sideways': acts sideways only",
                      "gravity 'up': points upwards", "'high': the level 60 m is above the highest point of the model, 1 m",
                      "'low': the level -60 m is below the surface"):
            self.assertIn(words, said)

    def test_what_elements_make_of_flow_is_noted_and_ground_that_is_pulled(self):
        deck = self.folder / "ground.lua"

        def said(law, formulation="", z="-1e5"):
            deck.write_text(f"""model "ground" {{}}
            box "ground" {{ from = {{ 0, 0, 0 }}, to = {{ 1, 1, 1 }}, cells = {{ 1, 1, 1 }}, elements = "tet4" }}
            material "clay" {{ region = "ground", density = 2000, young = 1e8, poisson = 0.3, {law} {formulation} }}
            fix {{ surface = "ground.bottom", x = 0, y = 0, z = 0 }}
            traction "load" {{ surface = "ground.top", z = {z} }}
            stage "load" {{ solve = static {{}} }}""", encoding="utf-8")
            answer = self.ashlar("check", "ground.lua")
            self.assertEqual(answer.returncode, 0, answer.stderr)
            return " ".join(answer.stdout.replace("\nnote", "\n").split())

        clay = 'law = "von_mises", yield_stress = 1e5,'
        sand = 'law = "mohr_coulomb", cohesion = 1e4, friction = 0.5,'
        for text in (said(clay), said(clay, 'formulation = "bbar"')):
            self.assertNotIn("tet4 lock", text)
            self.assertNotIn("pulls", text)
        self.assertIn("tet4 lock in plastic flow", said(clay, 'formulation = "full"'))
        self.assertIn("is too weak in triaxial states", said(sand))
        self.assertIn("may give way at half of the strength", said(sand, 'formulation = "bbar"'))
        self.assertIn("pulls a top face upwards", said(sand, z="1e5"))

    def test_a_deck_marked_as_utf_8_or_with_the_line_ends_of_windows_is_read(self):
        self.deck()
        deck = self.folder / "bar.lua"
        plain = deck.read_bytes()
        for text in (b"\xef\xbb\xbf" + plain, plain.replace(b"\n", b"\r\n")):
            deck.write_bytes(text)
            self.assertEqual(self.ashlar("check", "bar.lua").returncode, 0)

    def test_a_new_deck_runs_and_never_replaces_another(self):
        self.assertEqual(self.ashlar("new", "valley").returncode, 0)
        self.assertEqual(self.ashlar("run", "valley.lua").returncode, 0)
        again = self.ashlar("new", "valley")
        self.assertEqual(again.returncode, 2)
        self.assertIn("valley.lua", again.stderr)

    def test_help_knows_commands_and_angles(self):
        self.assertIn("--precision", self.ashlar("help", "run").stdout)
        self.assertIn("default 30*deg", self.ashlar("help", "surface").stdout)

    def test_help_knows_laws_and_keys(self):
        self.assertIn("dip_direction", self.ashlar("help", "jointed").stdout)
        self.assertIn("joint and crackable", self.ashlar("help", "brittle").stdout)
        elastic = self.ashlar("help", "elastic").stdout
        self.assertIn("young", elastic)
        self.assertIn("normal_stiffness", elastic)
        self.assertIn("convection", self.ashlar("help", "film").stdout)
        self.assertIn("did you mean 'brittle'", self.ashlar("help", "britle").stderr)

    def test_a_transient_records_its_way(self):
        self.deck("""stage "heat" {
          apply = { fixed_temperature { surface = "left", value = 20*degC } },
          solve = thermal { duration = 10*days, record_every = 1*days },
        }
        history "middle" { at = {2,0,0}, record = "temperature" }""")
        self.assertEqual(self.ashlar("run", "bar.lua").returncode, 0)
        lines = (self.folder / "bar.run" / "history_middle.csv").read_text(encoding="utf-8").splitlines()
        rows = [line.split(",") for line in lines]
        heated = [row for row in rows[1:] if row[0] == "heat" and float(row[rows[0].index("seconds [s]")]) > 0]
        days = [float(row[rows[0].index("seconds [s]")]) / 86400 for row in heated]
        for day, wanted in zip(days, range(1, 11), strict=True):
            self.assertAlmostEqual(day, wanted, delta=0.05)
        warmth = [float(row[rows[0].index("temperature [degC]")]) for row in heated]
        self.assertEqual(warmth, sorted(warmth))
        self.assertGreater(warmth[-1], warmth[0])

    def test_the_end_of_a_stage_that_fails_is_marked_and_proves_nothing(self):
        self.deck("""stage "light" { solve = static { tolerance = 1e-8 } }
            stage "hopeless" { apply = { traction { surface = "right", z = 1*MPa } },
              solve = static { max_steps = 3, start = "rest" } }
            expect "far" { history = "end", component = "displacement.x", stage = "hopeless", between = { -1, 1 } }
            expect "the way there" { that = function(result)
              return #result.history("end").values("displacement.x") == 2 and not result.stage("hopeless").balanced end }
            """)
        answer = self.ashlar("run", "bar.lua")
        self.assertEqual(answer.returncode, 3, answer.stderr)
        self.assertIn("its end is NOT in balance", answer.stdout)
        self.assertIn("FAILED  far: history 'end': the end of stage 'hopeless' is not in balance", answer.stdout)
        self.assertIn("ok      the way there", answer.stdout)
        with open(self.folder / "bar.run/history_end.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["balanced"] for row in rows], ["1", "1", "0"])
        with h5py.File(self.folder / "bar.run/results.vtkhdf", "r") as file:
            self.assertEqual([int(step.attrs["balanced"]) for _, step in sorted(file["Steps"].items())], [1, 0])
        drawn = self.ashlar("plot", "bar.run", "--history", "end")
        self.assertEqual(drawn.returncode, 0, drawn.stderr)

    def test_a_folder_is_no_deck(self):
        answer = self.ashlar("check", str(self.folder))
        self.assertEqual(answer.returncode, 2)
        self.assertIn("this is a folder", answer.stderr)

    def test_a_folder_that_cannot_be_made_exits_5(self):
        self.deck()
        answer = self.ashlar("run", "bar.lua", "--out", "/proc/nowhere")
        self.assertEqual(answer.returncode, 5, answer.stderr)

    def test_check_shows_the_model_and_writes_nothing(self):
        self.deck()
        answer = self.ashlar("check", "bar.lua")
        self.assertEqual(answer.returncode, 0, answer.stderr)
        for words in ("4 elements (4 hex8), 20 nodes, 4 m^3", "bar: 4 elements, 4 m^3, 31 t, steel (elastic)",
                      "right: 1 facet, 1 m^2, traction", "estimate"):
            self.assertIn(words, answer.stdout)
        self.assertEqual([p.name for p in self.folder.iterdir()], ["bar.lua"])

    def test_check_writes_the_interfaces_before_anything_is_solved(self):
        self.deck("""box "foot" { from = {0,0,-1*m}, to = {2.5*m,1*m,0}, cells = {3,1,1} }
            material "rock" { region = "foot", density = 2600, young = 50*GPa, poisson = 0 }
            joint "bed" { between = { "foot", "bar" }, law = "elastic" }""")
        answer = self.ashlar("check", "bar.lua", "--to", "bed.vtu")
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertIn("1 face covered in part, 0.5 m^2 of them free", answer.stdout)
        grid = ElementTree.parse(self.folder / "bed.vtu").getroot()
        cells = {array.get("Name"): array.text.split() for array in grid.iter("DataArray")}
        area = {match: sum(float(a) for a, m in zip(cells["area"], cells["match"]) if m == match) for match in "0123"}
        self.assertEqual({match: round(a, 9) for match, a in area.items()}, {"0": 0, "1": 2.5, "2": 0.5, "3": 0})
        self.assertEqual(set(cells["gap"]), {"0"})
        self.assertEqual(len(cells["offsets"]), len(cells["area"]))
        self.assertEqual(bytes(int(c) for c in cells["interface_names"]), b"bed\0")
        self.assertEqual(self.ashlar("check", "bar.lua", "--to", "bed.vtu").returncode, 2)
        self.assertEqual(self.ashlar("check", "bar.lua", "--to", "bed.vtk", "--force").returncode, 2)

    def test_histories_begin_with_the_initial_temperature(self):
        self.deck("""initial_temperature { value = 25*degC }
            history "middle" { at = {2,0.5,0.5}, record = { "temperature" } }
            stage "heat" { apply = { fixed_temperature { surface = "left", value = 20*degC } },
              solve = thermal { duration = 60*s } }""")
        self.assertEqual(self.ashlar("run", "bar.lua").returncode, 0)
        rows = [line for line in (self.folder / "bar.run/history_middle.csv").read_text(encoding="utf-8").splitlines()
                if not line.startswith("#")]
        self.assertEqual(float(rows[1].split(",")[rows[0].split(",").index("temperature [degC]")]), 25)

    def test_a_fracture_stage_without_a_start_goes_on_from_the_temperature_that_the_body_has(self):
        (self.folder / "free.lua").write_text("""model "free" { reference_temperature = 20*degC }
            box "bar" { from = {0,0,0}, to = {1*m,0.2*m,0.2*m}, cells = {4,1,1} }
            material "concrete" { region = "bar", density = 2400, young = 30*GPa, poisson = 0, expansion = 1e-5/K,
              conductivity = 2, heat_capacity = 900 }
            fix { surface = "bar.left", x = 0, y = 0, z = 0 }
            local function at(t) return { fixed_temperature { surface = { "bar.left", "bar.right" }, value = t*degC } } end
            stage "autumn" { apply = at(10), solve = thermal { steady = true } }
            stage "cool" { solve = static { tolerance = 1e-8 } }
            stage "winter" { apply = at(0), solve = thermal { steady = true } }
            stage "cracks" { solve = fracture { to = "winter", increments = 2, tolerance = 1e-8 } }
            stage "after" { solve = static { tolerance = 1e-8 } }
            history "tip" { at = {1,0.1,0.1}, record = { "displacement" } }""", encoding="utf-8")
        answer = self.ashlar("run", "free.lua")
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertIn("nothing can crack", answer.stdout)
        rows = [line.split(",") for line in (self.folder / "free.run/history_tip.csv").read_text(encoding="utf-8").splitlines()
                if not line.startswith("#")]
        tip = {row[0]: float(row[rows[0].index("displacement.x [m]")]) for row in rows[1:]}
        for stage, warming in (("cool", -10), ("cracks", -20), ("after", -20)):  # expansion * warming * length
            self.assertAlmostEqual(tip[stage] / (1e-5 * warming), 1, delta=1e-5, msg=stage)

    def test_check_knows_the_steps_of_stages_in_time(self):
        self.deck('''stage "shake" { solve = dynamic { duration = 0.1, record_every = 0.1 } }
            stage "heat" { apply = { fixed_temperature { surface = "left", value = 20*degC } },
                           solve = thermal { duration = 1e7 } }''')
        planned = self.ashlar("check", "bar.lua")
        self.assertEqual(planned.returncode, 0, planned.stderr)
        self.assertEqual(self.ashlar("run", "bar.lua").returncode, 0)
        stages = json.loads((self.folder / "bar.run/manifest.json").read_text(encoding="utf-8"))["stages"]
        for stage in stages[:2]:
            self.assertIn(f"stage {stage['name']}: {stage['steps']:,} steps of ".replace(",", " "), planned.stdout)

    def test_a_terminal_gets_one_live_line(self):
        self.deck(ENDLESS)
        controller, terminal = pty.openpty()
        process = subprocess.Popen([PROGRAM, "run", "bar.lua"], cwd=self.folder, env=self.environment, stdout=terminal)
        os.close(terminal)
        shown = b""
        while b"ETA" not in shown:
            shown += os.read(controller, 4096)
        process.send_signal(signal.SIGINT)
        process.wait(timeout=20)
        os.close(controller)
        self.assertIn(b"\r\x1b[Kstage 1/2 heat", shown)

    def test_an_interrupted_run_keeps_what_it_has_and_exits_130(self):
        self.deck(ENDLESS)
        for signals in (1, 2):
            with self.subTest(signals=signals):
                process = subprocess.Popen([PROGRAM, "run", "bar.lua", "--force"], cwd=self.folder, env=self.environment,
                                           stdout=subprocess.PIPE, text=True)
                self.assertIn("stage 1 heat", process.stdout.readline())
                time.sleep(0.3)
                for _ in range(signals):
                    process.send_signal(signal.SIGINT)
                words, _ = process.communicate(timeout=20)
                self.assertEqual(process.returncode, 130)
                if signals == 1:
                    self.assertIn("interrupted", words)
                    status = json.loads((self.folder / "bar.run/manifest.json").read_text(encoding="utf-8"))["status"]
                    self.assertEqual(status, "interrupted")


if __name__ == "__main__":
    unittest.main()
