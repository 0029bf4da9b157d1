"""ensemble.nc as xarray reads it: its samples are those of `cycle --sample`, its statistics those of NumPy, and threads
make no difference to the last bit.

Usage: test_ensemble_netcdf.py REPOSITORY PROGRAM
"""

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
CASE = ROOT / "examples/tolerances.toml"
SAMPLES = 100
SET = [
    "--set", "cycle.steps=4",
    "--set", 'cycle.directions=["+X", "-Y"]',
    "--set", "montecarlo.bump_foil_thickness.std=1 um",
    "--set", 'montecarlo.friction_bump_sleeve={distribution="uniform", lower=-0.05, upper=0.05}',
    "--set", 'montecarlo.sleeve_waviness={harmonic=3, amplitude="3 um"}',
]  # fmt: skip


def run(*words):
    subprocess.run([PROGRAM, *words, "--quiet"], check=True)


class Ensemble(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.directory = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.directory.name)
        run("montecarlo", CASE, "-o", cls.folder / "ensemble", *SET, "--samples", str(SAMPLES), "--threads", "2")
        cls.result = xarray.open_dataset(cls.folder / "ensemble/ensemble.nc")
        cls.summary = json.loads((cls.folder / "ensemble/summary.json").read_text(encoding="utf-8"))

    @classmethod
    def tearDownClass(cls):
        cls.result.close()
        cls.directory.cleanup()

    def test_dimensions(self):
        self.assertEqual(dict(self.result.sizes), {"sample": SAMPLES, "direction": 2, "bump": 26})
        self.assertEqual(self.result.sample.dtype, np.int32)
        self.assertEqual(list(self.result.direction.values), [0.0, 270.0])
        for variable in self.result.variables.values():
            self.assertTrue(variable.attrs["long_name"])

    def test_what_was_drawn(self):
        heights = self.result.bump_height_deviation
        self.assertEqual(heights.dims, ("sample", "bump"))
        # Five standard errors of 100 x 26 numbers with a standard deviation of 10 um.
        self.assertLess(abs(float(heights.mean())), 5 * 10e-6 / np.sqrt(SAMPLES * 26))
        self.assertLessEqual(float(abs(self.result.friction_bump_sleeve_deviation).max()), 0.05)
        self.assertGreater(float(self.result.sleeve_waviness_phase.max()), np.pi)
        self.assertNotIn("radial_clearance_deviation", self.result)

    def test_samples_are_those_of_cycle(self):
        """All hundred, each of its quantities within 1e-9 of what it is."""
        for sample in range(SAMPLES):
            folder = self.folder / "alone"
            ensemble = f"{self.folder}/ensemble/ensemble.nc:{sample}"
            run("cycle", CASE, "-o", folder, "--force", "--sample", ensemble, *SET[:4])
            with xarray.open_dataset(folder / "result.nc") as cycle:
                for name in set(self.result.data_vars) & set(cycle.data_vars):
                    if "sample" not in self.result[name].dims or name in ("status", "max_residual"):
                        continue
                    alone = cycle[name].sel(direction=self.result.direction)
                    drawn = self.result[name].sel(sample=sample)
                    scale = float(abs(self.result[name]).max())
                    np.testing.assert_allclose(drawn, alone, rtol=1e-9, atol=1e-12 * scale, err_msg=f"{sample} {name}")

    def test_statistics_are_those_of_numpy(self):
        for direction, name in enumerate(["+X", "-Y"]):
            for quantity, key in [("max_force", "max_force_N"), ("loaded_stiffness", "loaded_stiffness_N_per_m")]:
                values = self.result[quantity].values[:, direction]
                found = self.summary["statistics"][name][key]
                self.assertEqual(found["count"], SAMPLES)
                self.assertAlmostEqual(found["mean"] / np.mean(values), 1.0, delta=1e-13)
                self.assertAlmostEqual(found["std"] / np.std(values, ddof=1), 1.0, delta=1e-11)
                for p in (1, 5, 25, 50, 75, 95, 99):
                    self.assertAlmostEqual(found[f"p{p}"] / np.percentile(values, p), 1.0, delta=1e-13)
            loads = self.result.bump_load.values[:, direction]
            np.testing.assert_allclose(self.summary["bump_loads"][name]["mean_N"], loads.mean(axis=0), rtol=1e-12)

    def test_threads_make_no_difference(self):
        run("montecarlo", CASE, "-o", self.folder / "one", *SET, "--samples", str(SAMPLES), "--threads", "1")
        with xarray.open_dataset(self.folder / "one/ensemble.nc") as one:
            for name, variable in self.result.variables.items():
                self.assertEqual(one[name].values.tobytes(), variable.values.tobytes(), name)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
