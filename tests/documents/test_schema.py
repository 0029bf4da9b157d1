"""The schema of case files accepts all examples and presets, and refuses what the reader refuses, by an independent
validator.

Usage: test_schema.py REPOSITORY PROGRAM
"""

import copy
import json
import re
import subprocess
import sys
import tempfile
import tomllib
import unittest
from pathlib import Path

import jsonschema

EXAMPLES = Path(sys.argv[1]).resolve() / "examples"
PROGRAM = Path(sys.argv[2]).resolve()


def run(*arguments):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, check=True).stdout


SCHEMA = json.loads(run("schema"))
VALIDATOR = jsonschema.Draft7Validator(SCHEMA)


def paths_of(errors):
    return sorted(".".join(str(part) for part in error.absolute_path) for error in errors)


def tables_of(schema, path=()):
    """Every table of the schema with its path; one of a list as its entries."""
    for name, value in schema.get("properties", {}).items():
        inner = value.get("items", value) if "anyOf" in value else value
        if inner.get("type") == "object":
            yield (*path, name), inner
            yield from tables_of(inner, (*path, name))


class CaseSchema(unittest.TestCase):
    def setUp(self):
        self.case = tomllib.loads((EXAMPLES / "gen1.toml").read_text(encoding="utf-8"))

    def errors(self, case):
        return paths_of(VALIDATOR.iter_errors(case))

    def test_is_a_schema(self):
        jsonschema.Draft7Validator.check_schema(SCHEMA)

    def test_accepts_examples_and_presets(self):
        cases = sorted(EXAMPLES.glob("*.toml"))
        self.assertGreater(len(cases), 20)
        for path in cases:
            with self.subTest(case=path.name):
                self.assertEqual(self.errors(tomllib.loads(path.read_text(encoding="utf-8"))), [])

    def test_accepts_what_cases_show_as_comments(self):
        """Keys and tables that are commented out in the presets, and the case of the former model without a top foil."""
        preset = run("init", "--preset", "running")
        # A key that may stand instead of another, or twice, has one hash more or its own.
        lines = [re.sub(r"^(# )+(?=\[|\w+ = )", "", line) for line in preset.splitlines()]
        kept, seen = [], set()
        for line in lines:
            if line.startswith("["):
                seen = set()
            key = line.split(" = ")[0]
            if "..." in line or (" = " in line and key in seen):
                continue
            seen.add(key)
            kept.append(line if re.match(r"\[|\w+ = ", line) else "")
        everything = tomllib.loads("\n".join(kept))
        self.assertIn("montecarlo", everything)
        self.assertIn("data", everything["fit"])
        del everything["rotor"]["matrix"]  # its matrices are shown as [...]
        self.assertEqual(self.errors(everything), [])
        del self.case["top_foil"]
        self.case["bump_foil"]["model"] = "former"
        self.assertEqual(self.errors(self.case), [])

    def test_accepts_all_forms(self):
        foil, cycle = self.case["bump_foil"], self.case["cycle"]
        foil["pitch"] = {"start": "4 mm", "end": 5e-3, "law": "geometric"}
        foil["height"] = ["0.5 mm", 5e-4]
        foil["shim"] = {"from": 1, "to": 2, "thickness": "20µm"}  # one alone
        cycle["directions"] = {"from": "0 deg", "to": "90 degrees", "step": "0.25 rev"}
        cycle["preload"] = ["0 N", "-5.0e1 kilonewtons"]
        self.case["top_foil"]["formed_radius"] = "seated"
        self.case["gas"] = {"viscosity": "18.5 uPa s", "temperature": "293 K"}
        self.case["equilibrium"] = {"speeds": ["45000 rpm", "45000 1/min", "45000 min-1", "300 rad/s"], "loads": [[5, 0]]}
        self.case["bump_foil"]["truss"] = {"k1": "150 MN/m", "k2": "1 kg m/(s2 m)"}
        self.case["asperity"] = {"density": "40000 1/mm2"}
        self.case["fit"] = {
            "data": [{"file": "loop.csv"}],
            "parameter": [
                {"key": "friction.coefficient", "start": 0.1, "lower": 0, "upper": 0.5},
                {"key": "bearing.radial_clearance", "start": "30 um", "lower": "20 um", "upper": "50 um"},
            ],
        }
        self.assertEqual([error for error in self.errors(self.case) if not error.startswith("asperity")], [])

    def test_refuses_misspelt_keys_in_every_table(self):
        tables = list(tables_of(SCHEMA))
        self.assertGreater(len(tables), 40)
        for path, table in [((), SCHEMA), *tables]:
            with self.subTest(table=".".join(path)):
                self.assertIs(table["additionalProperties"], False)
                for key, value in table["properties"].items():
                    self.assertTrue(value["title"], key)
        misspelt = copy.deepcopy(self.case)
        misspelt["bump_foil"]["hight"] = misspelt["bump_foil"].pop("height")
        missing, unknown = sorted(VALIDATOR.iter_errors(misspelt), key=lambda error: error.message)
        self.assertIn("'height' is a required property", missing.message + unknown.message)
        self.assertIn("'hight' was unexpected", missing.message + unknown.message)

    def test_refuses_what_the_reader_refuses(self):
        wrong = [
            ("bump_foil", "bumps", 26.5),
            ("bump_foil", "bumps", "26"),
            ("bump_foil", "model", "trus"),
            ("bump_foil", "height", "0.5 N"),
            ("bump_foil", "height", "0.5"),
            ("bump_foil", "height", "0,5 mm"),
            ("bump_foil", "height", True),
            ("bump_foil", "poisson_ratio", 0.6),
            ("bump_foil", "youngs_modulus", "214 mm"),
            ("bump_foil", "youngs_modulus", 214),
            ("bump_foil", "stiffness_follows_height", "yes"),
            ("bearing", "radius", -0.02),
            ("bearing", "weld_angle", 180),
            ("bearing", "wrap", 1),
            ("friction", "coefficient", 1.5),
            ("friction", "coefficient", "0.1"),
            ("cycle", "directions", ["+Z"]),
            ("cycle", "directions", "+X"),
            ("cycle", "steps", 0),
            ("equilibrium", "speeds", ["750 1/s"]),
            ("equilibrium", "speeds", ["45000 min"]),
            ("cycle", "preload", ["0 N", "1 N", "2 N"]),
            ("title", None, 1),
            ("solver", None, "newton"),
        ]
        self.assertEqual(self.errors(self.case), [])
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "case.toml"
            text = (EXAMPLES / "gen1.toml").read_text(encoding="utf-8")
            file.write_text(text, encoding="utf-8")
            for table, key, value in wrong:
                with self.subTest(table=table, key=key, value=value):
                    case = copy.deepcopy(self.case)
                    if key is None:
                        case[table] = value
                    else:
                        case.setdefault(table, {})[key] = value
                    self.assertEqual([error.split(".")[0] for error in self.errors(case)][:1], [table])
                    name = table if key is None else f"{table}.{key}"
                    checked = subprocess.run([PROGRAM, "check", file, "--set", f"{name}={json.dumps(value)}"], capture_output=True)
                    self.assertEqual(checked.returncode, 2)

    def test_bounds_are_those_of_the_reader(self):
        properties = SCHEMA["properties"]
        self.assertEqual(properties["friction"]["properties"]["coefficient"]["maximum"], 1.0)
        fit = properties["fit"]["properties"]
        points = fit["data"]["items"]["properties"]["points"]
        self.assertEqual((points["minimum"], points["maximum"], points["default"]), (8.0, 10000.0, 100))
        bounded = json.dumps(SCHEMA).count('"minimum"')
        self.assertGreater(bounded, 100)

    def test_its_own_examples_are_valid(self):
        shown = 0
        for path, table in [((), SCHEMA), *tables_of(SCHEMA)]:
            for key, value in table["properties"].items():
                for example in [*value.get("examples", []), *([value["default"]] if "default" in value else [])]:
                    shown += 1
                    with self.subTest(key=".".join((*path, key))):
                        jsonschema.validate(example, value, jsonschema.Draft7Validator)
        self.assertGreater(shown, 200)

    def test_init_writes_it_beside_the_case(self):
        with tempfile.TemporaryDirectory() as folder:
            case = Path(folder) / "rig" / "first.toml"
            case.parent.mkdir()
            run("init", "-o", case)
            named = re.match(r"#:schema \./(\S+)\n", case.read_text(encoding="utf-8"))[1]
            written = case.parent / named
            self.assertEqual(json.loads(written.read_text(encoding="utf-8")), SCHEMA)
            # One that is there stays.
            written.write_text("{}", encoding="utf-8")
            run("init", "-o", case.with_name("second.toml"))
            self.assertEqual(written.read_text(encoding="utf-8"), "{}")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
