#!/usr/bin/python3
"""tools/check_floors.py passes the sources as they are and finds every kind of violation planted in a copy of them."""
import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
CHECK = ROOT / "tools" / "check_floors.py"

PLANTED = {
    "a lower floor includes a higher one": ("src/physics/planted.hpp", '#include "model/mesh.hpp"', "higher floor model"),
    "a solver reads a deck": ("src/solve/planted.cpp", '#include "script/deck.hpp"', "higher floor script"),
    "Lua outside script": ("src/model/planted.cpp", "#include <lua.hpp>", "only script includes Lua's lua.hpp"),
    "Lua outside script, indented": ("src/io/planted.cpp", "  #  include <lauxlib.h>", "only script"),
    "HDF5 outside io": ("src/script/planted.cpp", "#include <hdf5.h>", "only io includes HDF5's hdf5.h"),
    "CUDA outside cuda": ("src/backend/planted.cpp", "#include <cuda_runtime.h>", "only cuda/ and base/hd.hpp"),
    "a CUDA word in a kernel": ("src/kernels/planted.hpp", "__device__ int f();", "know CUDA"),
    "a source file included": ("src/model/planted.cpp", '#include "model/mesh.cpp"', "includes the source file"),
    "a relative include": ("src/model/planted.cpp", '#include "mesh.hpp"', "is not of the form"),
    "a header that does not exist": ("src/model/planted.cpp", '#include "model/absent.hpp"', "does not exist"),
    "a file outside the floors": ("src/elsewhere/planted.cpp", "", "belongs to no floor"),
    "the program's seam crossed": ("src/solve/planted.hpp", '#include "cuda/launch.hpp"', "higher floor cuda"),
}


def check(root):
    return subprocess.run([CHECK, root], capture_output=True, text=True)


class CheckFloors(unittest.TestCase):
    def test_the_sources_keep_to_their_floors(self):
        answer = check(ROOT)
        self.assertEqual(answer.returncode, 0, answer.stdout + answer.stderr)

    def test_every_planted_violation_is_found(self):
        for title, (place, line, expected) in PLANTED.items():
            with self.subTest(title), tempfile.TemporaryDirectory() as folder:
                copy = pathlib.Path(folder)
                shutil.copytree(ROOT / "src", copy / "src")
                planted = copy / place
                planted.parent.mkdir(parents=True, exist_ok=True)
                planted.write_text("\n" + line + "\n", encoding="utf-8")
                answer = check(copy)
                self.assertEqual(answer.returncode, 1, answer.stdout + answer.stderr)
                self.assertIn(f"{place}:", answer.stdout)
                self.assertIn(expected, answer.stdout)

    def test_a_folder_without_sources_is_no_success(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertNotEqual(check(folder).returncode, 0)


if __name__ == "__main__":
    unittest.main()
