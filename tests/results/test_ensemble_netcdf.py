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
PADS = ROOT / "examples/three_pads.toml"
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


def assert_samples_are_those_of_cycle(case, folder, result):
    """All of them, each of their quantities within 1e-9 of what it is; returns how many quantities there are."""
    compared = set()
    for sample in result.sample.values:
        ensemble = f"{folder}/ensemble/ensemble.nc:{sample}"
        run("cycle", case, "-o", folder / "alone", "--force", "--sample", ensemble, *SET[:4])
        with xarray.open_dataset(folder / "alone/result.nc") as cycle:
            # What a cycle has of every bump at full displacement is called loads there.
            alone = cycle.rename(bump_loads="bump_load")
            for name in set(result.data_vars) & set(alone.data_vars):
                if "sample" not in result[name].dims or name in ("status", "max_residual"):
                    continue
                expected = alone[name].sel(direction=result.direction)
                drawn = result[name].sel(sample=sample)
                scale = float(abs(result[name]).max())
                np.testing.assert_allclose(drawn, expected, rtol=1e-9, atol=1e-12 * scale, err_msg=f"{sample} {name}")
                compared.add(name)
    return len(compared)


class EnsembleCase(unittest.TestCase):
    """Tests that share an ensemble."""

    @classmethod
    def run_ensemble(cls, case, *options):
        cls.directory = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.directory.name)
        run("montecarlo", case, "-o", cls.folder / "ensemble", *options)
        cls.result = xarray.open_dataset(cls.folder / "ensemble/ensemble.nc")
        cls.summary = json.loads((cls.folder / "ensemble/summary.json").read_text(encoding="utf-8"))

    @classmethod
    def tearDownClass(cls):
        cls.result.close()
        cls.directory.cleanup()


class Ensemble(EnsembleCase):
    @classmethod
    def setUpClass(cls):
        cls.run_ensemble(CASE, *SET, "--samples", str(SAMPLES), "--threads", "2")

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
        first = self.result.isel(sample=slice(40))
        self.assertGreater(assert_samples_are_those_of_cycle(CASE, self.folder, first), 10)

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


class EnsembleOfPads(EnsembleCase):
    """Three pads of eight bumps, the foils of the last a case of their own."""

    @classmethod
    def setUpClass(cls):
        heights = ["--set", 'montecarlo.bump_height={std="5 um", correlation_length="10 mm"}']
        foils = ["--set", "montecarlo.top_foil_thickness.std=1 um"]
        cls.run_ensemble(PADS, *SET[:6], *heights, *foils, "--samples", "40")

    def test_bumps_tell_their_pads(self):
        self.assertEqual(dict(self.result.sizes), {"sample": 40, "direction": 2, "bump": 24})
        np.testing.assert_array_equal(self.result.bump_pad, np.repeat([1, 2, 3], 8))

    def test_samples_are_those_of_cycle(self):
        first = self.result.isel(sample=slice(5))
        self.assertGreater(assert_samples_are_those_of_cycle(PADS, self.folder, first), 10)

    def test_heights_correlate_within_pads_alone(self):
        scores = self.result.bump_height_deviation.values
        neighbours = [np.corrcoef(scores[:, bump], scores[:, bump + 1])[0, 1] for bump in range(23)]
        within = [rho for bump, rho in enumerate(neighbours) if bump not in (7, 15)]
        # Pitches are stretched to 110 degrees in eight; forty samples tell it to 0.16, and 21 pairs to less.
        expected = np.exp(-19.05e-3 * np.radians(110 / 8) / 10e-3)
        self.assertAlmostEqual(np.mean(within), expected, delta=0.12)
        for bump in (7, 15):
            self.assertLess(abs(neighbours[bump]), 3 * 0.16)

    def test_statistics_are_of_every_bump(self):
        for direction, name in enumerate(["+X", "-Y"]):
            loads = self.result.bump_load.values[:, direction]
            np.testing.assert_allclose(self.summary["bump_loads"][name]["mean_N"], loads.mean(axis=0), rtol=1e-12)
            np.testing.assert_allclose(self.summary["bump_loads"][name]["std_N"], loads.std(axis=0, ddof=1), rtol=1e-9)
        heights = np.array(self.summary["sensitivities"]["+X"]["max_force"]["bump_height"], dtype=float)
        self.assertEqual(len(heights), 24)
        # Along +X the journal is pressed into pad 2.
        self.assertEqual(np.argmax(abs(heights)) // 8, 1)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
