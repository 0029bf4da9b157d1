"""A case is the same whatever it is made of, and its errors are told in the words of the program."""

import pickle
import subprocess

import numpy as np
import pytest

import bumpfoil
from conftest import EXAMPLES, PROGRAM

GEN1 = EXAMPLES / "gen1.toml"


def test_file_text_and_dictionary_give_the_same_case():
    case = bumpfoil.Case(GEN1)
    assert bumpfoil.Case(GEN1.read_text()) == case
    assert bumpfoil.Case(case.to_dict()) == case
    assert bumpfoil.Case(**case.to_dict()) == case
    assert bumpfoil.Case(case.toml) == case
    assert pickle.loads(pickle.dumps(case)) == case
    assert hash(bumpfoil.Case(str(GEN1))) == hash(case)
    printed = subprocess.run([PROGRAM, "check", GEN1], check=True, capture_output=True, text=True).stdout
    assert printed == case.toml + "\n# cycle: ok\n"


def test_numbers_are_si_and_texts_have_units():
    by_number = bumpfoil.Case(GEN1, bearing={"radius": 0.02, "weld_angle": np.float64(np.pi)})
    by_text = bumpfoil.Case(GEN1, bearing={"radius": "20 mm", "weld_angle": "180 deg"})
    assert by_number == by_text
    assert by_number.to_dict()["bearing"]["radius"] == 0.02


def test_ranges_are_lists():
    speeds = {"from": "10000 rpm", "to": "60000 rpm", "points": 11}
    held = bumpfoil.Case(EXAMPLES / "running.toml", equilibrium={"speeds": speeds}).to_dict()["equilibrium"]["speeds"]
    np.testing.assert_allclose(held, np.linspace(10000, 60000, 11) * np.pi / 30, rtol=1e-14)
    with pytest.raises(bumpfoil.CaseError, match="has neither points nor step"):
        bumpfoil.Case(GEN1, cycle={"clearance_forces": {"from": "1 N", "to": "9 N"}})


def test_each_command_checks_what_it_uses():
    states = {"speeds": ["45000 rpm"], "loads": [["20 N", "0 N"]]}
    dry = bumpfoil.check(GEN1, solver={"name": "events"}, equilibrium=states)
    assert bumpfoil.run_cycle(dry, cycle={"steps": 2, "directions": ["+X"]}).status == "complete"
    with pytest.raises(bumpfoil.CaseError, match="solver.name"):
        bumpfoil.run_equilibrium(dry)
    with pytest.raises(bumpfoil.CaseError, match="would press the bumps flat"):
        bumpfoil.check(GEN1, cycle={"amplitude": "0.6 mm"})


def test_arrays_are_lists():
    errors = np.linspace(-1e-6, 1e-6, 26)
    case = bumpfoil.Case(GEN1, bump_foil={"height_errors": errors})
    assert case.to_dict()["bump_foil"]["height_errors"] == errors.tolist()
    assert case.replace({"cycle.steps": np.int64(7)}).to_dict()["cycle"]["steps"] == 7


def test_quantities_of_pint():
    units = pytest.importorskip("pint").UnitRegistry()
    case = bumpfoil.Case(
        GEN1,
        bearing={"radius": 19.05 * units.mm, "radial_clearance": 31.8 * units.um},
        bump_foil={"youngs_modulus": 214 * units.GPa, "height_errors": [1.0] * 26 * units.um},
        cycle={"load": 50 * units.newton, "amplitude": None},
    )
    assert case.to_dict()["bearing"]["radial_clearance"] == bumpfoil.Case(GEN1).to_dict()["bearing"]["radial_clearance"]
    assert case.to_dict()["bump_foil"]["height_errors"] == [1e-6] * 26


@pytest.mark.parametrize(
    ("key", "number", "unit", "text"),
    [
        ("equilibrium.speeds", [45000], "rpm", ["45000 rpm"]),
        ("equilibrium.speeds", [100], "turn/s", ["6000 rpm"]),
        ("equilibrium.frequencies", [0.2], "kHz", ["200 Hz"]),
        ("equilibrium.loads", [[1, 0], [2, 0]], "kN", [["1000 N", "0 N"], ["2000 N", "0 N"]]),
        ("friction.coefficient", 0.2, "", 0.2),
        ("friction.coefficient", 200, "um/mm", 0.2),
        ("bump_foil.youngs_modulus", 1000, "ksi", "6894757293.168361 Pa"),
        ("bump_foil.thickness", 4, "thou", "0.1016 mm"),
        ("gas.temperature", 20, "degC", "293.15 K"),
        ("bearing.weld_angle", 0.5, "turn", "180 deg"),
        ("gas.viscosity", 0.018, "cP", "18 uPa s"),
        ("asperity.density", 17000.0, "1/mm**2", "17000 1/mm2"),
        ("cycle.steps", 7, "", 7),
    ],
)
def test_any_unit_of_pint(key, number, unit, text):
    quantity = pytest.importorskip("pint").UnitRegistry().Quantity(number, unit)
    running = bumpfoil.Case(EXAMPLES / "running_from_rest.toml", cycle=bumpfoil.Case(GEN1).to_dict()["cycle"])
    table, name = key.split(".")
    held, expected = (running.replace({key: value}).to_dict()[table] for value in (quantity, text))
    if key == "friction.coefficient":
        assert held == expected
    else:
        np.testing.assert_allclose(held[name], expected[name], rtol=1e-14)


@pytest.mark.parametrize(("number", "unit"), [(3, "N"), (3, "N*rad"), (3, "rad"), (3, "furlong*s")])
def test_quantities_of_another_kind_are_refused(number, unit):
    quantity = pytest.importorskip("pint").UnitRegistry().Quantity(number, unit)
    with pytest.raises(bumpfoil.CaseError, match=r"^bearing\.radius = 3"):
        bumpfoil.check(GEN1, bearing={"radius": quantity})
    with pytest.raises(bumpfoil.CaseError, match=r"^friction\.coefficient = 3"):
        bumpfoil.check(GEN1, friction={"coefficient": quantity})


def test_laws_take_the_place_of_values():
    law = {"start": "4.4 mm", "end": "4.6 mm", "law": "linear"}
    graded = bumpfoil.Case(GEN1, bump_foil={"pitch": law})
    assert graded.to_dict()["bump_foil"]["pitch"] == {"start": 0.0044, "end": 0.0046, "law": "linear"}
    assert graded == bumpfoil.Case(GEN1).replace({"bump_foil.pitch": law})
    # One value of a law that is there; a number in place of a law.
    assert graded.replace({"bump_foil": {"pitch": {"end": 0.0045}}}).to_dict()["bump_foil"]["pitch"]["end"] == 0.0045
    assert graded.replace({"bump_foil.pitch": "4.572 mm"}) == bumpfoil.Case(GEN1)


def test_changes_leave_the_case_as_it_was():
    case = bumpfoil.Case(GEN1)
    changed = case.replace({"friction.coefficient": 0.3}, cycle={"steps": 10})
    assert changed.to_dict()["cycle"]["steps"] == 10
    assert changed.to_dict()["friction"] != case.to_dict()["friction"]
    assert case == bumpfoil.Case(GEN1)
    # Of a dictionary, too, the other keys of the table stay.
    assert bumpfoil.Case(case.to_dict(), cycle={"steps": 10}) == case.replace({"cycle.steps": 10})


def test_errors_are_those_of_the_program(tmp_path):
    wrong = tmp_path / "wrong.toml"
    wrong.write_text(GEN1.read_text().replace('radius = "19.05 mm"', 'radius = "19.05 N"').replace("bumps = ", "bmups = "))
    told = subprocess.run([PROGRAM, "check", wrong], capture_output=True, text=True)
    assert told.returncode == 2
    with pytest.raises(bumpfoil.CaseError) as caught:
        bumpfoil.Case(wrong)
    assert str(caught.value) == told.stderr.rstrip("\n")
    assert caught.value.errors == told.stderr.splitlines()
    assert len(caught.value.errors) > 2
    assert caught.value.faults == caught.value.errors  # the former name
    assert isinstance(caught.value, ValueError)


def test_errors_of_what_python_gave_go_by_their_keys():
    with pytest.raises(bumpfoil.CaseError, match=r"^bearing\.radius = -1: must be positive"):
        bumpfoil.check(GEN1, bearing={"radius": -1})
    tables = bumpfoil.Case(GEN1).to_dict()
    tables["bearing"]["radius"] = "3 N"
    with pytest.raises(bumpfoil.CaseError, match=r"^bearing\.radius = 3 N: is a force"):
        bumpfoil.check(tables)
    with pytest.raises(bumpfoil.CaseError, match="did you mean"):
        bumpfoil.check(tables, friction={"coeficient": 0.1})
    with pytest.raises(bumpfoil.CaseError, match=r"TOML text:1: bearing\.radius = false"):
        bumpfoil.check("bearing.radius = false\n")
    with pytest.raises(TypeError, match="complex"):
        bumpfoil.check(GEN1, bearing={"radius": 1j})


def test_files_that_cannot_be_read(tmp_path):
    with pytest.raises(bumpfoil.FileError, match="nowhere.toml") as caught:
        bumpfoil.Case(tmp_path / "nowhere.toml")
    assert isinstance(caught.value, OSError)


def test_a_command_needs_its_table():
    with pytest.raises(bumpfoil.CaseError, match=r"strip: this table is missing"):
        bumpfoil.run_strip(GEN1)


def test_template_and_saved_case(tmp_path):
    case = bumpfoil.Case(bumpfoil.template("gen1"))
    case.save(tmp_path / "case.toml")
    assert bumpfoil.Case(tmp_path / "case.toml") == case
    with pytest.raises(FileExistsError):
        case.save(tmp_path / "case.toml")


def test_properties_are_those_of_the_program():
    properties = bumpfoil.properties(GEN1)
    printed = subprocess.run([PROGRAM, "properties", GEN1, "--json"], check=True, capture_output=True, text=True).stdout
    import json

    assert properties == json.loads(printed)
