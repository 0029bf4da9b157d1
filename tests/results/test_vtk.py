"""Files for ParaView, as meshio reads them: the shapes and numbers of result.nc, on the cylinder and unwrapped.

Usage: test_vtk.py REPOSITORY PROGRAM
"""

import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import meshio
import numpy as np
import xarray

EXAMPLES = Path(sys.argv[1]).resolve() / "examples"
PROGRAM = Path(sys.argv[2]).resolve()
COARSE = ["film.columns_per_pitch=4", "film.rows=4"]
TOP, BUMP, JOURNAL, JOURNAL_TOP, TOP_BUMP, BUMP_SLEEVE = range(6)


def run(*words):
    return subprocess.run([PROGRAM, *words], capture_output=True, text=True, check=True).stdout


class Mesh:
    """One file, part by part."""

    def __init__(self, path):
        self.mesh = meshio.read(path)
        self.cells = {}
        for block, parts in zip(self.mesh.cells, self.mesh.cell_data["part"], strict=True):
            for part in np.unique(parts):
                self.cells.setdefault(int(part), []).append(block.data[parts == part].ravel())

    def points(self, part):
        return self.mesh.points[self.nodes(part)]

    def nodes(self, part):
        return np.unique(np.concatenate(self.cells[part]))

    def data(self, part, name):
        return self.mesh.point_data[name][self.nodes(part)]


class Vtk(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.folder = Path(directory.name)

    def export(self, command, example, *changes, name="results"):
        """A result, and its files by what lists them."""
        results = self.folder / name
        run(command, EXAMPLES / example, "-o", results, "--quiet", *(word for pair in changes for word in ("--set", pair)))
        said = run("export", results, "--to", "vtk")
        files = {}
        for layout in ("cylinder", "unwrapped"):
            listed = ElementTree.parse(results / "vtk" / f"{layout}.pvd").getroot().iter("DataSet")
            files[layout] = [Mesh(results / "vtk" / one.get("file")) for one in listed]
        self.assertIn(f"wrote {len(files['cylinder'])} states", said)
        with xarray.open_dataset(results / "result.nc") as result:
            return result.load(), files

    def assert_balanced(self, mesh, force, part):
        """Normal and friction forces of a layer of contacts carry what the journal is loaded with."""
        found = mesh.data(part, "contact_force").sum(axis=0)
        np.testing.assert_allclose(found, [*force, 0.0], atol=2e-3 * np.hypot(*force))

    def test_pushes_are_shown_as_they_go(self):
        result, files = self.export("cycle", "gen1.toml", "cycle.directions=['+X', '90 deg']", "cycle.steps=2")
        self.assertEqual([len(meshes) for meshes in files.values()], [10, 10])
        self.assertFalse(result.force_x.isnull().any())
        radius, clearance, length = (float(result[name]) for name in ("bearing_radius", "radial_clearance", "axial_length"))
        for k, (mesh, flat) in enumerate(zip(files["cylinder"], files["unwrapped"], strict=True)):
            place = dict(direction=k // 5, increment=k % 5)
            state = result.isel(place)
            numbers = mesh.mesh.field_data
            self.assertEqual(float(numbers["force_x"][0]), float(state.force_x))
            self.assertEqual(sorted(mesh.cells), list(range(6)))
            # The journal is round, and where it is.
            x, y, z = mesh.points(JOURNAL).T
            np.testing.assert_allclose(np.hypot(x - float(state.x), y - float(state.y)), radius - clearance, atol=1e-6)
            self.assertAlmostEqual(np.ptp(z), length)
            # Displacements of the top foil over the crests; the weld and the free end are beside.
            inner = slice(1, -1)
            top = mesh.mesh.points[mesh.nodes(TOP)].reshape(2, 28, 3)[0][inner]
            polar = state.phi.values
            np.testing.assert_allclose(np.hypot(*top[:, :2].T), radius + state.top_displacement, atol=1e-12)
            np.testing.assert_allclose(np.cos(np.arctan2(top[:, 1], top[:, 0]) - polar), 1.0, atol=1e-12)
            outward = mesh.data(TOP, "displacement").reshape(2, 28, 3)[0][inner]
            np.testing.assert_allclose(outward[:, 0] * np.cos(polar) + outward[:, 1] * np.sin(polar), state.top_displacement, atol=1e-11)
            self.assert_balanced(mesh, (float(state.force_x), float(state.force_y)), JOURNAL_TOP)
            np.testing.assert_array_equal(mesh.data(TOP_BUMP, "contact_state"), state.state_top_bump)
            np.testing.assert_allclose(np.linalg.norm(mesh.data(BUMP_SLEEVE, "contact_force"), axis=1), np.hypot(state.normal_force_bump_sleeve, state.friction_force_bump_sleeve), rtol=1e-6)
            # Laid flat: heights over the sleeve, along the foils from the weld.
            along, _, height = flat.points(TOP_BUMP).T
            np.testing.assert_allclose(along, radius * state.theta + state.crest_u, atol=1e-12)
            np.testing.assert_allclose(height, float(result.bump_rise) - state.crest_v, atol=1e-12)
            self.assertLess(abs(flat.points(BUMP_SLEEVE)[:, 2] + state.foot_v.values).max(), 1e-12)
            np.testing.assert_allclose(flat.data(TOP_BUMP, "contact_force")[:, [0, 2]], np.transpose([state.friction_force_top_bump, -state.normal_force_top_bump]), rtol=1e-6, atol=1e-9)

    def assert_film(self, result, files):
        """On the top foil: film thickness and pressure of the result, and its distance from the journal."""
        radius, clearance, length = (float(result[name]) for name in ("bearing_radius", "radial_clearance", "axial_length"))
        half = float(result.z[0]) >= 0.0
        for k, mesh in enumerate(files["cylinder"]):
            state = result.isel(state=k)
            z = result.z.values
            rows = np.concatenate([z[:0:-1] * -1.0, z]) if half else z
            order = np.concatenate([np.arange(len(z))[:0:-1], np.arange(len(z))]) if half else np.arange(len(z))
            thickness = state.film_thickness.values
            thickness = thickness[order] if thickness.ndim == 2 else np.tile(thickness, (len(rows), 1))
            points = mesh.mesh.points
            pads = getattr(result, "column_pad", xarray.zeros_like(result.column) + 1).values
            nodes = mesh.nodes(TOP)
            start = 0
            for pad in np.unique(pads):
                columns = pads == pad
                count = len(rows) * columns.sum()
                own = nodes[start : start + count].reshape(len(rows), -1)
                start += count
                np.testing.assert_allclose(mesh.mesh.point_data["film_thickness"][own], thickness[:, columns], rtol=1e-6)
                np.testing.assert_allclose(mesh.mesh.point_data["pressure"][own], state.pressure.values[order][:, columns], rtol=1e-6)
                np.testing.assert_allclose(points[own][:, :, 2], np.tile(rows[:, None], (1, columns.sum())), atol=1e-12)
                x, y = points[own][:, :, 0], points[own][:, :, 1]
                polar = np.arctan2(y, x)
                slope = [float(state[name]) if name in state else 0.0 for name in ("tilt_x", "tilt_y")]
                journal = radius - clearance + (float(state.x) + slope[0] * rows[:, None]) * np.cos(polar) + (float(state.y) + slope[1] * rows[:, None]) * np.sin(polar)
                np.testing.assert_allclose(np.hypot(x, y) - journal, thickness[:, columns], atol=1e-12)
                # The foil is as far out as it is deflected.
                if "film_top_displacement" in state and not hasattr(result, "pad_lobe"):
                    moved = mesh.mesh.point_data["displacement"][own]
                    outward = moved[:, :, 0] * np.cos(polar) + moved[:, :, 1] * np.sin(polar)
                    np.testing.assert_allclose(np.hypot(x, y) - radius, outward, atol=2e-9)
            self.assertEqual(start, len(nodes))
            self.assertAlmostEqual(np.ptp(mesh.points(JOURNAL)[:, 2]), length)
            self.assertTrue(np.isnan(mesh.data(JOURNAL, "pressure")).all())

    def test_running_bearings_have_films(self):
        result, files = self.export("equilibrium", "running_pads.toml", *COARSE, 'equilibrium.loads=[["20 N", "0 N"]]')
        self.assert_film(result, files)
        for mesh in files["cylinder"]:
            self.assertEqual(sorted(mesh.cells), [TOP, BUMP, JOURNAL, TOP_BUMP, BUMP_SLEEVE])

    def test_tilted_journals_have_films_over_the_whole_width(self):
        result, files = self.export("equilibrium", "misaligned.toml", *COARSE, "width.modes=2")
        self.assertNotEqual(float(result.tilt_x[0]), 0.0)
        self.assertLess(float(result.z[0]), 0.0)
        self.assert_film(result, files)
        self.assertLess(float(result.h_min[0]) - float(files["cylinder"][0].data(TOP, "film_thickness").min()), 1e-9)
        rows, bumps = len(result.z), len(result.bump)
        for k, mesh in enumerate(files["cylinder"]):
            state = result.isel(state=k)
            radius = np.hypot(*mesh.points(BUMP)[:, :2].T).reshape(rows, -1)
            crests = radius[:, 1 + 4 :: 9]
            self.assertEqual(crests.shape, (rows, bumps))
            # Crests tilt with the top foil that lies on them.
            np.testing.assert_allclose(crests[-1] - crests[0], 2 * state.crest_v_slope, atol=1e-12)
            columns = np.abs(result.column_theta.values[None] - result.theta.values[:, None]).argmin(axis=1)
            top = np.hypot(*mesh.mesh.points[mesh.nodes(TOP)][:, :2].T).reshape(rows, -1)[:, columns]
            loaded = state.normal_force_top_bump.values > 5.0
            self.assertGreater(loaded.sum(), 3)
            self.assertGreater(np.ptp(top[:, loaded], axis=0).max(), 5e-7)
            np.testing.assert_allclose(crests[:, loaded], top[:, loaded], atol=1e-8)

    def test_tilted_journals_press_dry_foils_at_one_side(self):
        at_side = ["width.modes=3", "width.tilt=['0.2 mrad', '0.05 mrad']"]
        for example in ("gen1.toml", "three_pads.toml"):
            with self.subTest(example):
                result, files = self.export("path", example, *at_side, 'path.points=[["40 um", "20 um"]]', name=example)
                self.assertGreater(float(abs(result.top_slope).max()), 1e-6)
                radius, clearance = float(result.bearing_radius), float(result.radial_clearance)
                meshes = files["cylinder"]
                for k in (0, len(meshes) - 1):
                    mesh, state = meshes[k], result.isel(increment=k)
                    x, y, z = mesh.mesh.points[mesh.nodes(TOP)].T
                    polar = np.arctan2(y, x)
                    gap = mesh.data(TOP, "film_thickness")
                    journal = radius - clearance + (float(state.x) + 2e-4 * z) * np.cos(polar) + (float(state.y) + 5e-5 * z) * np.sin(polar)
                    np.testing.assert_allclose(np.hypot(x, y) - journal, gap, atol=1e-12)
                    bumps = len(result.bump) // (3 if "pad_lobe" in result else 1)
                    shape = (-1, 9, bumps + 2)
                    over = gap.reshape(shape)[:, :, 1:-1]
                    least = state.gap_journal_top.values.reshape(-1, bumps)
                    # The gap of the result is the least at lines inside, at +-0.775 of half the width.
                    zeta = np.linspace(-1, 1, 9)
                    lines = [[np.interp([-0.6**0.5, 0.0, 0.6**0.5], zeta, line).min() for line in pad.T] for pad in over]
                    np.testing.assert_allclose(lines, least, atol=2e-8)
                # Some bumps touch at a part of the width alone.
                self.assertTrue(((over.min(axis=1) < 1e-8) & (over.max(axis=1) > 1e-7)).any())
                # Crests follow the top foil where they carry it.
                crests = np.hypot(*mesh.points(BUMP)[:, :2].T).reshape(-1, 9, 1 + 9 * bumps)[:, :, 1 + 4 :: 9]
                top = np.hypot(x, y).reshape(shape)[:, :, 1:-1]
                carried = state.normal_force_top_bump.values.reshape(-1, bumps) > 5.0
                self.assertGreater(carried.sum(), 3)
                np.testing.assert_allclose((crests - top)[:, 4][carried], 0.0, atol=1e-7)
                self.assertAlmostEqual(np.ptp(z), float(result.axial_length))

    def test_strips_under_a_whole_top_foil_have_no_parabola(self):
        result, files = self.export("cycle", "gen2-three-strips.toml", "cycle.directions=['+X']", "cycle.steps=2")
        self.assertTrue(result.top_parabola.isnull().all())
        for mesh, x in zip(files["cylinder"], result.x.values.ravel(), strict=True):
            self.assertTrue(np.isfinite(mesh.mesh.points).all())
            gap = mesh.data(TOP, "film_thickness").min()
            self.assertAlmostEqual(gap, max(0.0, float(result.radial_clearance) - x), delta=1e-7)

    def test_films_of_rigid_foils_and_paths(self):
        at = ['equilibrium.positions=[["15 um", "-4 um"]]', 'equilibrium.speeds=["45000 rpm"]', "film.rows=4"]
        result, files = self.export("film", "gen1.toml", *at)
        self.assert_film(result, files)
        self.assertEqual(sorted(files["cylinder"][0].cells), [TOP, JOURNAL])
        run("path", EXAMPLES / "gen1.toml", "-o", self.folder / "path", "--quiet", "--set", 'path.points=[["0 um", "0 um"], ["40 um", "20 um"]]')
        run("export", self.folder / "path", "--to", "vtk", "-o", self.folder / "there", "--quiet")
        mesh = Mesh(self.folder / "there" / "cylinder_0001.vtu")
        self.assertEqual(float(mesh.mesh.field_data["x"][0]), 40e-6)

    def test_what_is_there_is_replaced_on_request_only(self):
        self.export("cycle", "gen1.toml", "cycle.directions=['+X']", "cycle.steps=1")
        again = [PROGRAM, "export", self.folder / "results", "--to", "vtk", "--quiet"]
        self.assertEqual(subprocess.run(again, capture_output=True).returncode, 4)
        self.assertEqual(subprocess.run([*again, "--force"], capture_output=True).returncode, 0)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
