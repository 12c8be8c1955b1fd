#!/usr/bin/python3
"""The plotting program on a run whose fields are known functions: geometry is exact, every picture gets drawn."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tools"), str(ROOT / "tests" / "tools")]

import numpy as np  # noqa: E402
from plotting import geometry, pictures, results  # noqa: E402
from synthetic_run import write_run  # noqa: E402

PROGRAM = ROOT / "tools" / "plot.py"
THICKNESS, ROCK, DAM = 12.0, 168.0 * 60.0, (48 + 9.6) / 2 * 48 + (9.6 + 8) / 2 * 6 + 8 * 6  # m, m^2, m^2


def area(polygons, points):
    """Sum of the polygons' areas by the shoelace formula in space."""
    p = polygons.at_corners(points)
    edges = polygons.edges()
    vectors = np.add.reduceat(np.cross(p[edges[:, 0]], p[edges[:, 1]]), polygons.start[:-1], axis=0)
    return np.linalg.norm(vectors, axis=1).sum() / 2


class Plot(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.place.name) / "synthetic.run"
        cls.known = write_run(cls.folder)
        cls.run_read = results.Run(cls.folder)

    @classmethod
    def tearDownClass(cls):
        cls.run_read.file.close()
        cls.place.cleanup()

    def all_elements(self):
        return np.ones(len(self.run_read.mesh.types), bool)

    def plot(self, *words):
        return subprocess.run([PROGRAM, self.folder, *words], capture_output=True, text=True)

    def test_sections_have_the_area_of_the_body_wherever_they_cut(self):
        mesh = self.run_read.mesh
        for y in (0.7, THICKNESS / 2, 11.0):  # the middle is a plane of nodes
            cut = geometry.section(mesh, self.all_elements(), 1, y)
            self.assertAlmostEqual(area(cut, mesh.points) / (ROCK + DAM), 1, delta=1e-5)

    def test_the_view_along_y_shows_the_front_face_and_nothing_else(self):
        mesh = self.run_read.mesh
        view = geometry.view_along("y")
        seen = geometry.facing(geometry.outer_faces(mesh, self.all_elements(), mesh.points), mesh.points, view)
        self.assertAlmostEqual(area(seen, mesh.points), ROCK + DAM, delta=1e-6 * ROCK)
        self.assertLess(np.abs(seen.at_corners(mesh.points)[:, 1]).max(), 1e-9)

    def test_blocks_that_touch_hide_their_common_faces(self):
        mesh = self.run_read.mesh
        outer = geometry.outer_faces(mesh, mesh.regions == 0, mesh.points)
        down = np.hypot(48 - 9.6, 48) + np.hypot(1.6, 6) + 6
        self.assertAlmostEqual(area(outer, mesh.points), 2 * DAM + (48 + 60 + 8 + down) * THICKNESS, delta=1e-6 * DAM)

    def test_blocks_that_moved_far_show_what_they_turn_to_the_eye_there(self):
        cube = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], float)
        points = np.concatenate([cube, cube + [1, 0, 0]])
        mesh = results.Mesh(points, np.arange(16), np.array([0, 8, 16]), np.array([12, 12]), np.zeros(2, int), ["rock"])
        self.assertEqual(len(geometry.outer_faces(mesh, np.ones(2, bool), points)), 10)
        c, s = np.cos(2.5), np.sin(2.5)  # about z, then away from the other
        turned = np.concatenate([cube, cube @ np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]]) + [3, 0, 0]])
        outer = geometry.outer_faces(mesh, np.ones(2, bool), turned)
        self.assertEqual(len(outer), 12)
        seen = geometry.facing(outer, turned, geometry.view_along("y"))
        self.assertEqual(sorted(seen.cell), [0, 1, 1])
        self.assertTrue((geometry.normals(seen, turned)[:, 1] < 0).all())

    def test_what_is_drawn_last_at_a_place_is_what_lies_nearest_there(self):
        cube = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], float)
        bodies = [cube * [20, 20, 1] - [0, 0, 1]]  # a large plate, small cubes on it at its far and near side
        for place in ([3, 17, 0], [17, 3, 0], [3, 3, 0], [4.2, 3.3, 0], [16, 17, 0], [3.3, 3.2, 1]):
            c, s = np.cos(place[0]), np.sin(place[0])
            bodies.append((cube - [0.5, 0.5, 0]) @ np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]]) + place)
        count, points = len(bodies), np.concatenate(bodies)
        mesh = results.Mesh(points, np.arange(8 * count), 8 * np.arange(count + 1), np.full(count, 12),
                            np.zeros(count, int), ["rock"])
        view = geometry.view_along("iso")
        seen = geometry.facing(geometry.outer_faces(mesh, np.ones(count, bool), points), points, view)
        at = seen.at_corners(points)
        shape, depth = view.project(at).reshape(-1, 4, 2), (at @ view.away).reshape(-1, 4)
        low, high = shape.min(axis=(0, 1)), shape.max(axis=(0, 1))
        covered = 0
        for place in np.random.default_rng(7).uniform(low, high, (4000, 2)):
            along = np.roll(shape, -1, axis=1) - shape
            side = geometry.cross2(along, place - shape)
            over = np.flatnonzero((side > 1e-6).all(axis=1) | (side < -1e-6).all(axis=1))
            if len(over) == 0:
                continue
            deep = [geometry.plane_depth(shape[[i]], depth[[i]], place[None])[0] for i in over]
            self.assertEqual(over[np.argmin(deep)], over.max())
            covered += len(over) > 1
        self.assertGreater(covered, 50)

    def test_a_linear_field_is_exact_on_a_profile(self):
        mesh = self.run_read.mesh
        cut = geometry.section(mesh, self.all_elements(), 1, 5.0)
        corners = cut.at_corners(mesh.points)
        at = geometry.view_along("y").project(corners)
        middle = at.shape[0] + cut.owner()
        triangles = np.column_stack([cut.edges(), middle])
        at, height = np.concatenate([at, cut.mean(at)]), np.concatenate([corners[:, 2], cut.mean(corners[:, 2])])
        line = np.column_stack([np.linspace(2, 6, 9), np.linspace(-50, 59, 9)])
        found = geometry.sample(at[triangles], height[triangles], line)
        np.testing.assert_allclose(found, line[:, 1], atol=1e-9)
        self.assertTrue(np.isnan(geometry.sample(at[triangles], height[triangles], np.array([[50.0, 30.0]]))[0]))

    def test_crack_traces_run_along_the_crack_and_only_there(self):
        run, mesh = self.run_read, self.run_read.mesh
        faces = run.interfaces(run.output("fracture"))
        view = geometry.view_along("y")
        surface = geometry.facing(geometry.outer_faces(mesh, self.all_elements(), mesh.points), mesh.points, view)
        cut = geometry.section(mesh, self.all_elements(), 1, 4.0)
        for polygons, plane in ((surface, None), (cut, (1, 4.0))):
            corners = polygons.at_corners(mesh.points)
            halves, state, _ = geometry.traces(polygons, corners, faces, plane)
            ends = corners[halves[state > 0]]
            np.testing.assert_allclose(ends[:, 0, 2], 12.0, atol=1e-6)
            length = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).sum() / 2
            # The crack reaches to half an edge beyond its last broken contact point, at 28.8 m; both lips are drawn.
            self.assertAlmostEqual(length, 2 * (28.8 + 2.4), delta=1e-6)

    def test_components_and_units(self):
        stress = np.array([[1e6, 2e6, 3e6, 4e6, 5e6, 6e6]])
        self.assertEqual(pictures.component_of("stress.yz", stress)[0][0], 5.0)
        self.assertEqual(pictures.component_of("displacement", np.array([[0.003, 0.0, 0.004]]))[0][0], 5.0)
        with self.assertRaises(pictures.PictureError):
            pictures.component_of("stress", stress)

    def test_a_history_with_one_stage_in_time_is_drawn_over_its_time(self):
        with tempfile.TemporaryDirectory() as place:
            folder = pathlib.Path(place) / "shaken.run"
            write_run(folder)
            (folder / "history_crest.csv").write_text(
                "stage,time,load_factor,balanced,seconds [s],velocity.x [m/s]\ngravity,0,0,1,0,0\ngravity,1,1,1,0,0\n"
                "shake,1.2,1,1,1,2\nshake,1.4,1,1,2,-1\nshake,2,1,0,5,9\n", encoding="utf-8")
            run = results.Run(folder)
            table = run.history("crest")
            self.assertEqual(table.stages_with_a_way, ["shake"])
            self.assertEqual(list(table.balanced), [True, True, True, True, False])
            figures = []
            pictures.drawing.save, save = lambda figure, path: figures.append(figure), pictures.drawing.save
            try:
                pictures.history_picture(run, "crest", "")
                pictures.history_picture(run, "crest", "", "gravity")
            finally:
                pictures.drawing.save = save
                run.file.close()
            shaken, gravity = (figure.axes[-1] for figure in figures)
            self.assertEqual(shaken.get_xlabel(), "time [s]")
            self.assertEqual([list(line.get_xdata()) for line in shaken.lines], [[1, 2], [5]])
            self.assertEqual(gravity.get_xlabel(), "load factor")
            self.assertEqual(pictures.along_a_stage(
                results.History("", [], {}, ["a"] * 2, np.zeros(2), np.ones(2), np.ones(2, bool),
                                {"seconds": np.array([0, 40 * 86400.0])}), "a")[1], "time [days]")

    def test_every_kind_of_picture_is_drawn(self):
        for words in ([], ["--of", "displacement", "--deform", "auto", "--view", "iso"], ["--of", "stress.zz", "--section", "y"],
                      ["--of", "cracks", "--deform", "200"], ["--of", "cracks", "--section", "y=4"],
                      ["--of", "temperature", "--stage", "winter", "--regions", "dam"], ["--history", "crest"],
                      ["--of", "temperature", "--profile", "0,30:40,30"]):
            with self.subTest(words):
                answer = self.plot(*words)
                self.assertEqual(answer.returncode, 0, answer.stderr)
                for name in answer.stdout.split("\n")[:-1]:
                    self.assertEqual(pathlib.Path(name).read_bytes()[:4], b"\x89PNG")

    def test_wrong_requests_name_what_there_is(self):
        for words, expected in ((["--of", "pressure"], "displacement, stress, temperature"),
                                (["--stage", "autumn", "--of", "temperature"], "gravity, summer, winter, fracture"),
                                (["--of", "temperature", "--regions", "damm"], "dam, rock"),
                                (["--of", "temperature", "--section", "y=40"], "0 to 12 m"),
                                (["--history", "toe"], "crest"), (["--history", "crest", "--stage", "toe"], "gravity, summer, fracture"),
                                (["--of", "temperature", "--profile", "500,0:600,0"], "misses the model")):
            with self.subTest(words):
                answer = self.plot(*words)
                self.assertEqual(answer.returncode, 2)
                self.assertIn(expected, answer.stderr)
                self.assertNotIn("Traceback", answer.stderr)
        answer = subprocess.run([PROGRAM, self.place.name], capture_output=True, text=True)
        self.assertEqual(answer.returncode, 2)
        self.assertIn("is no folder of results", answer.stderr)


if __name__ == "__main__":
    unittest.main()
