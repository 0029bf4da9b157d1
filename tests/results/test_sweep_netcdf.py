"""sweep.nc as xarray reads it: the same numbers as in sweep.csv, summary.json and the results of single runs.

Usage: test_sweep_netcdf.py REPOSITORY PROGRAM
"""

import csv
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np
import xarray

ROOT = Path(sys.argv[1]).resolve()
PROGRAM = Path(sys.argv[2]).resolve()
CASE = ROOT / "examples/gen1.toml"
STEPS = 6
AMPLITUDES = ["60 um", "70 um", "79.5 um"]
FRICTIONS = [0, 0.05, 0.1, 0.15]


def run(*words):
    subprocess.run([PROGRAM, *words, "--quiet"], check=True)


class Sweep(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.directory = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.directory.name) / "swept"
        amplitudes = "cycle.amplitude=[" + ", ".join(AMPLITUDES) + "]"
        over = ["--over", amplitudes, "--over", "friction.coefficient=0:0.15:0.05"]
        run("sweep", CASE, *over, "-o", cls.folder, "--set", f"cycle.steps={STEPS}")
        cls.summary = json.loads((cls.folder / "summary.json").read_text(encoding="utf-8"))
        with open(cls.folder / "sweep.csv", newline="", encoding="utf-8") as file:
            cls.rows = list(csv.DictReader(file))
        cls.result = xarray.open_dataset(cls.folder / "sweep.nc")

    @classmethod
    def tearDownClass(cls):
        cls.result.close()
        cls.directory.cleanup()

    def test_keys_are_coordinates(self):
        result = self.result
        self.assertEqual(result.loss_factor.dims, ("cycle_amplitude", "friction_coefficient", "direction"))
        np.testing.assert_array_equal(result.cycle_amplitude, [60e-6, 70e-6, 79.5e-6])
        np.testing.assert_array_equal(result.friction_coefficient, FRICTIONS)
        np.testing.assert_array_equal(result.direction, [0, 90, 180, 270])
        self.assertEqual(result.cycle_amplitude.units, "m")
        self.assertEqual(result.friction_coefficient.units, "1")
        self.assertEqual(result.friction_coefficient.case_key, "friction.coefficient")
        one = result.sel(friction_coefficient=0.11, cycle_amplitude=69e-6, direction=91, method="nearest")
        self.assertEqual(float(one.friction_coefficient), 0.1)
        self.assertTrue(np.isfinite(one.loaded_stiffness))

    def test_every_variable_is_described(self):
        for name, variable in self.result.variables.items():
            self.assertTrue(variable.attrs["long_name"], name)
            self.assertTrue("units" in variable.attrs or "flag_meanings" in variable.attrs, name)
            self.assertIn(variable.dtype.kind, "fi", name)
        self.assertEqual(self.result.attrs["status"], "complete")
        self.assertEqual(self.result.attrs["run_id"], self.summary["run_id"])

    def test_csv_has_the_same_rows(self):
        self.assertEqual(len(self.rows), 3 * 4 * 4)
        self.assertEqual(list(self.rows[0])[:3], ["cycle_amplitude_m", "friction_coefficient", "direction_deg"])
        for column, name in (
            ("max_force_N", "max_force"),
            ("loaded_stiffness_N_per_m", "loaded_stiffness"),
            ("loss_factor", "loss_factor"),
            ("iterations", "total_iterations"),
        ):
            values = np.array([float(row[column]) for row in self.rows]).reshape(3, 4, 4)
            as_in_case = self.result[name].sel(direction=[0, 180, 90, 270])
            np.testing.assert_array_equal(as_in_case, values, column)
        meanings = self.result.status.attrs["flag_meanings"].split()
        self.assertEqual(
            [meanings[int(flag)] for flag in self.result.status.values.ravel()], [row["status"] for row in self.rows]
        )
        frictions = [float(row["friction_coefficient"]) for row in self.rows]
        self.assertEqual(frictions, list(np.repeat(FRICTIONS, 4)) * 3)

    def test_summary_has_the_same_points(self):
        points = self.summary["points"]
        self.assertEqual([axis["name"] for axis in self.summary["axes"]], ["cycle_amplitude", "friction_coefficient"])
        self.assertEqual(len(points), 12)
        for point in points:
            at = {axis["name"]: point["values"][axis["key"]] for axis in self.summary["axes"]}
            for cycle in point["cycles"]:
                one = self.result.sel(at | {"direction": cycle["direction_deg"]})
                self.assertEqual(float(one.loop_energy), cycle["loop_energy_J"])

    def test_a_point_is_what_a_run_of_its_own_gives(self):
        alone = Path(self.directory.name) / "alone"
        overrides = [f"cycle.steps={STEPS}", "friction.coefficient=0.15", "cycle.amplitude=70 um"]
        run("cycle", CASE, "-o", alone, *(word for one in overrides for word in ("--set", one)))
        point = self.result.sel(friction_coefficient=0.15, cycle_amplitude=70e-6)
        with xarray.open_dataset(alone / "result.nc") as unordered:
            result = unordered.sel(direction=point.direction)
            for name in self.result.data_vars:
                if name != "wall_time":
                    np.testing.assert_array_equal(point[name], result[name], str(name))
            np.testing.assert_array_equal(point.displacement, result.displacement)
            self.assertEqual(point.force_direct.dims, result.force_direct.dims)
            for name in ("loss_factor", "force_direct", "status"):
                self.assertEqual(point[name].attrs["long_name"], result[name].attrs["long_name"])

    def test_documented(self):
        text = (ROOT / "docs/results.md").read_text(encoding="utf-8")
        for name in [*self.summary, *self.summary["points"][0], *self.summary["axes"][0], *self.result.attrs]:
            self.assertIn(f"`{name}`", text)


class SweepOfVibrations(unittest.TestCase):
    def test_points_are_what_runs_of_their_own_give(self):
        case = ROOT / "examples/vibration.toml"
        steps = ["--set", "vibration.steps=10"]
        with tempfile.TemporaryDirectory() as name:
            swept, alone = Path(name) / "swept", Path(name) / "alone"
            over = ["--over", "friction.coefficient=0.1:0.2:0.05"]
            run("sweep", case, "--command", "vibration", *over, *steps, "-o", swept)
            run("vibration", case, "--set", "friction.coefficient=0.15", *steps, "-o", alone)
            with xarray.open_dataset(swept / "sweep.nc") as result, xarray.open_dataset(alone / "result.nc") as single:
                self.assertEqual(result.kxx.dims, ("friction_coefficient", "load", "amplitude"))
                self.assertEqual(result.cxx.dims, ("friction_coefficient", "load", "amplitude", "frequency"))
                self.assertEqual(result.attrs["swept_command"], "vibration")
                self.assertIn("displacement", result.coords)
                point = result.sel(friction_coefficient=0.15)
                self.assertEqual(set(single.variables), set(result.variables) - {"friction_coefficient"})
                for variable in single.variables:
                    if variable != "wall_time":
                        np.testing.assert_array_equal(point[variable], single[variable], str(variable))
                        np.testing.assert_equal(point[variable].attrs, single[variable].attrs)
                self.assertTrue(np.all(np.isfinite(result.kxx)))
                # Where all slips, friction is what loses energy.
                largest = result.loss_stiffness_direct.sel(direction=0).isel(amplitude=-1)
                self.assertTrue(np.all(np.diff(largest, axis=0) > 0))
            with open(swept / "sweep.csv", newline="", encoding="utf-8") as file:
                rows = [row for row in csv.DictReader(file) if row.pop("friction_coefficient") == f"{0.15:.17g}"]
            with open(alone / "vibration.csv", newline="", encoding="utf-8") as file:
                expected = list(csv.DictReader(file))
            for row in [*rows, *expected]:
                row.pop("wall_time_s")
            self.assertEqual(rows, expected)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
