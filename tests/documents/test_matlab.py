"""Programs for Octave in examples/ are programs for MATLAB, too: nothing in them is Octave's alone. MATLAB itself is not
at hand; these are its rules where the two differ.

Usage: test_matlab.py REPOSITORY
"""

import re
import sys
import unittest
from pathlib import Path

EXAMPLES = Path(sys.argv[1]).resolve() / "examples"

RULES = {
    r"!": "! for ~",
    r"\b(end(if|for|while|switch|function|parfor)|end_try_catch|(end_)?unwind_protect\w*|until|do)\b": "keyword of Octave",
    r"[-+*/^|&]=(?!=)": "assignment with an operator",
    r"\w\s*(\+\+|--)\s*(;|,|$)": "increment",
    r"\*\*": "** for ^",
    r"\)[({]": "index of an expression",
    r"\b(printf|puts|fputs|fdisp|rows|columns|pkg|graphics_toolkit|have_window_system|argv|isargout|print_usage)\b": "function of Octave",
}
GUARD = re.compile(r"if\s*\(?exist\('OCTAVE_VERSION', 'builtin'\)\)?$")
OPENS = re.compile(r"(if|for|parfor|while|switch|try|function)\b")


def strings_and_comments_apart(line):
    """The line with its strings as '' and without its comment, what it quotes with ", and whether # begins the comment."""
    code, quoted, at = "", [], 0
    while at < len(line):
        letter = line[at]
        # After a value ' transposes it.
        if letter == '"' or (letter == "'" and not re.search(r"[\w)\]}'.]$", code)):
            end = at + 1
            while end < len(line) and (line[end] != letter or line[end + 1 : end + 2] == letter):
                end += 2 if line[end] == letter else 1
            text = line[at : end + 1]
            code += text if letter == "'" and re.fullmatch(r"'\w+'", text) else "''"
            quoted += [text] if letter == '"' else []
            at = end + 1
        elif letter in "%#":
            return code, quoted, letter == "#"
        else:
            code += letter
            at += 1
    return code, quoted, False


def errors_of(program):
    """What MATLAB does not understand, with its line."""
    errors, depth, guarded = [], 0, None
    for number, line in enumerate(program.splitlines(), 1):
        code, quoted, hash_comment = strings_and_comments_apart(line)
        code = code.strip()
        if guarded is None and GUARD.match(code):
            guarded = depth
        errors += [(number, "comment with #")] if hash_comment else []
        errors += [(number, "escape in double quotes") for text in quoted if "\\" in text]
        for rule, name in RULES.items():
            if re.search(rule, code) and not (name == "function of Octave" and guarded is not None):
                errors.append((number, name))
        # The end of an index stands in brackets.
        depth += len(OPENS.findall(code.split("(")[0])) - len(re.findall(r"(?<![(\w:,+\-*/ ])end\b", code))
        if guarded is not None and depth <= guarded:
            guarded = None
    return errors


class Matlab(unittest.TestCase):
    def test_examples_are_for_matlab_too(self):
        examples = list(EXAMPLES.glob("*.m"))
        self.assertGreater(len(examples), 0)
        for example in examples:
            self.assertEqual(errors_of(example.read_text(encoding="utf-8")), [], example.name)

    def test_what_is_of_octave_alone_is_found(self):
        for line, error in {
            "if (! ready)": "! for ~",
            "if a != b": "! for ~",
            "x = 1; # of Octave": "comment with #",
            "# of Octave": "comment with #",
            "endif": "keyword of Octave",
            "endfunction": "keyword of Octave",
            "end_try_catch": "keyword of Octave",
            "unwind_protect": "keyword of Octave",
            "do": "keyword of Octave",
            "until x > 3": "keyword of Octave",
            "x += 1;": "assignment with an operator",
            "x *= 2;": "assignment with an operator",
            "x++;": "increment",
            "y = x ** 2;": "** for ^",
            "y = size(x)(1);": "index of an expression",
            "y = f(x){1};": "index of an expression",
            'disp("a\\tb");': "escape in double quotes",
            "printf('%g', x);": "function of Octave",
            "puts('x');": "function of Octave",
            "pkg load netcdf": "function of Octave",
        }.items():
            self.assertEqual(errors_of(f"x = 1;\n{line}\n"), [(2, error)], line)

    def test_what_both_know_is_let_pass(self):
        for line in (
            "y = x' * x.'; % 'transposed' # twice",
            "disp('it''s # no comment, x += 1, x != 2');",
            'disp("50 % of ""it""");',
            "if x ~= y && ~z, w = x(end); end",
            "y = a--b;",
            "f = @(d) sprintf('%g deg\\n', d);",
            "fprintf('%d\\n', x);",
            "z = [x(1) (2)];",
        ):
            self.assertEqual(errors_of(line), [], line)

    def test_what_octave_needs_stands_behind_a_question(self):
        guard = "if exist('OCTAVE_VERSION', 'builtin')\n  pkg load netcdf\n  if x\n    y = 1;\n  end\n  puts('x');\nend\n"
        self.assertEqual(errors_of(guard), [])
        self.assertEqual(errors_of(guard + "puts('x');\n"), [(8, "function of Octave")])
        self.assertEqual(errors_of("if exist('other', 'builtin')\n  pkg load netcdf\nend\n"), [(2, "function of Octave")])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
