"""The architecture check must pass a good tree and name every error of a bad one."""

import tempfile
import unittest
from pathlib import Path

from check_architecture import find_errors


class CheckArchitecture(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.TemporaryDirectory()
        self.addCleanup(self.directory.cleanup)
        self.root = Path(self.directory.name)
        self.write("include/bumpfoil/core/vector.hpp", "#pragma once\n#include <vector>\n")
        self.write("tests/unit/core/test_vector.cpp", '#include "bumpfoil/core/vector.hpp"\n')

    def write(self, path, text):
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")

    def assert_one_error(self, *fragments):
        errors = find_errors(self.root)
        self.assertEqual(len(errors), 1, errors)
        for fragment in fragments:
            self.assertIn(fragment, errors[0])

    def test_good_tree(self):
        self.write(
            "src/contact/solve.cpp",
            '#include "contact/detail.hpp"\n#include "bumpfoil/core/vector.hpp"\n#include <cmath>\n'
            "// A bump may be named in a comment.\nnamespace bumpfoil {\nBUMPFOIL_ASSERT(true);\n}\n",
        )
        self.write("src/contact/detail.hpp", "#pragma once\n")
        self.write("src/pages/report.cpp", '#include <fstream>\n#include "bumpfoil/experiments/cycle/cycle.hpp"\n')
        self.assertEqual(find_errors(self.root), [])

    def test_include_against_the_direction(self):
        self.write("src/core/vector.cpp", '#include "bumpfoil/core/vector.hpp"\n#include "bumpfoil/model/case.hpp"\n')
        self.assert_one_error("src/core/vector.cpp:2", "core must not include model")

    def test_contact_includes_only_core(self):
        self.write("src/contact/solve.cpp", '#include "bumpfoil/structure/foil_structure.hpp"\n')
        self.assert_one_error("src/contact/solve.cpp:1", "contact must not include structure")

    def test_structure_does_not_include_contact(self):
        self.write("src/structure/truss.cpp", "#include <bumpfoil/contact/problem.hpp>\n")
        self.assert_one_error("structure must not include contact")

    def test_structure_does_not_include_the_case(self):
        self.write("src/structure/truss.cpp", '#include "bumpfoil/model/foil_design.hpp"\n')
        self.assertEqual(find_errors(self.root), [])
        self.write("src/structure/truss.cpp", '#include "bumpfoil/model/case.hpp"\n')
        self.assert_one_error("src/structure/truss.cpp:1", "bumpfoil/model/case.hpp")

    def test_the_case_stops_at_the_door(self):
        for module in ("bearing", "motion"):
            file = f"src/{module}/state.cpp"
            self.write(file, '#include "bumpfoil/model/geometry.hpp"\n')
            self.assertEqual(find_errors(self.root), [])
            for name in ("case", "validation"):
                self.write(file, f'#include "bumpfoil/model/{name}.hpp"\n')
                self.assert_one_error(f"{file}:1", f"{module} must not include", f"bumpfoil/model/{name}.hpp")
            self.write(file, "")
        self.write("src/motion/state.hpp", '#pragma once\n#include "motion/other.hpp"\n')
        self.write("src/motion/other.hpp", "#pragma once\n")
        self.write("src/motion/state.cpp", '#include "motion/state.hpp"\n')
        self.assertEqual(find_errors(self.root), [])
        self.write("src/motion/other.hpp", '#pragma once\n#include "bumpfoil/model/case.hpp"\n')
        errors = find_errors(self.root)
        self.assertEqual(len(errors), 3, errors)
        self.assertIn('src/motion/state.cpp:1: motion must not include "bumpfoil/model/case.hpp" through', errors[1])
        self.write("src/motion/other.hpp", "#pragma once\n")
        self.write("src/experiments/build.cpp", '#include "bumpfoil/model/case.hpp"\n')
        self.assertEqual(find_errors(self.root), [])

    def test_names_of_tests(self):
        self.write("tests/unit/core/test_vector.cpp", '#include "bumpfoil/core/vector.hpp"\nTEST_P(Vector, Grows) {}\n')
        self.write("tests/CMakeLists.txt", "set(SLOW */Vector.Grows/1\n  Vector.Shrinks)\n")
        self.assert_one_error("tests/CMakeLists.txt:2", "no test Vector.Shrinks")

    def test_include_that_leaves_the_folder(self):
        self.write("src/core/vector.cpp", '#include "../model/case.hpp"\n')
        self.assert_one_error("src/core/vector.cpp:1", "names no module")

    def test_unknown_module(self):
        self.write("src/wear/depth.cpp", "\n")
        self.assert_one_error("module 'wear'")

    def test_studies_stand_above_pages(self):
        self.write("src/studies/study.cpp", '#include <filesystem>\n#include "bumpfoil/results/result_set.hpp"\n')
        self.assertEqual(find_errors(self.root), [])
        self.write("src/pages/report.cpp", '#include "bumpfoil/studies/study.hpp"\n')
        self.assert_one_error("src/pages/report.cpp:1", "pages must not include studies")

    def test_private_headers_stay_inside_the_library(self):
        self.write("src/film/faces.hpp", "#pragma once\n")
        self.write("src/film/film.cpp", '#include "film/faces.hpp"\n')
        self.write("tests/unit/film/test_faces.cpp", '#include "film/faces.hpp"\n')
        self.assertEqual(find_errors(self.root), [])
        self.write("src/bearing/bearing.cpp", '#include <vector>\n#include "film/faces.hpp"\n')
        self.assertEqual(find_errors(self.root), [])

    def test_origin_is_reached_through_its_door(self):
        uzawa = '#include "bumpfoil/origin/uzawa.hpp"\n'
        self.write("src/experiments/build.cpp", uzawa)
        self.write("src/origin/uzawa.cpp", uzawa)
        self.assertEqual(find_errors(self.root), [])
        self.write("src/experiments/cycle/cycle.cpp", uzawa)
        self.assert_one_error("src/experiments/cycle/cycle.cpp:1", "experiments must not include origin")
        self.write("src/experiments/cycle/cycle.cpp", "")
        self.write("bench/bench.cpp", uzawa)
        self.assert_one_error("bench/bench.cpp:1", "src/experiments/build.cpp")

    def test_programs_use_public_headers(self):
        self.write("src/film/faces.hpp", "#pragma once\n")
        self.write("bench/bench_film.cpp", '#include "film/faces.hpp"\n')
        self.assert_one_error("bench/bench_film.cpp:1", '"film/faces.hpp" is private to the library')

    def test_printing_below_io(self):
        self.write("src/bearing/foils.cpp", "#include <iostream>\n")
        self.assert_one_error("<iostream>", "not to bearing")

    def test_printing_past_the_one_place_for_it(self):
        self.write("apps/output.cpp", "void print() { std::fputs(text, stderr); }\n")
        self.assertEqual(find_errors(self.root), [])
        self.write("apps/check.cpp", '// On stdout.\nvoid print() { fmt::print("{}", title); }\n')
        self.assert_one_error("apps/check.cpp:2", "'fmt::print'", "apps/output.hpp")

    def test_contact_has_never_heard_of_a_bump(self):
        self.write("src/contact/solve.cpp", "namespace bumpfoil {\nint bump_count();\n}\n")
        self.assert_one_error("src/contact/solve.cpp:2", "'bump_count'")

    def test_structure_has_never_heard_of_friction(self):
        self.write("src/structure/truss.cpp", "/* Two\n lines. */\ndouble friction_coefficient;\n")
        self.assert_one_error("src/structure/truss.cpp:3", "'friction_coefficient'")

    def test_header_without_guard(self):
        self.write("src/model/angles.hpp", "int f();\n")
        self.assert_one_error("src/model/angles.hpp", "#pragma once")

    def test_header_without_unit_test(self):
        self.write("include/bumpfoil/model/case.hpp", "#pragma once\n")
        self.assert_one_error("include/bumpfoil/model/case.hpp", "tests/unit/model/test_case.cpp")

    def test_header_that_need_not_compile_alone(self):
        self.write("tests/unit/core/test_vector.cpp", '#include <cmath>\n#include "bumpfoil/core/vector.hpp"\n')
        self.assert_one_error("tests/unit/core/test_vector.cpp", '"bumpfoil/core/vector.hpp" first')
        self.write("tests/unit/core/test_vector.cpp", "int main() {}\n")
        self.assert_one_error("tests/unit/core/test_vector.cpp", '"bumpfoil/core/vector.hpp" first')

    def test_public_header_with_what_users_have_not(self):
        good = "#pragma once\n#include <Eigen/Core>\n#include <string_view>\n"
        self.write("include/bumpfoil/core/vector.hpp", good)
        self.assertEqual(find_errors(self.root), [])
        self.write("include/bumpfoil/core/vector.hpp", good + '#include "core/detail.hpp"\n')
        self.assert_one_error("include/bumpfoil/core/vector.hpp:4", "have no core/detail.hpp")
        self.write("include/bumpfoil/core/vector.hpp", good + "#include <fmt/format.h>\n")
        self.assert_one_error("include/bumpfoil/core/vector.hpp:4", "have no fmt/format.h")


if __name__ == "__main__":
    unittest.main()
