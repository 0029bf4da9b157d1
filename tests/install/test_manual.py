"""The man page and the completions of bash say what the program itself says of its command line.

Usage: test_manual.py BUMPFOIL FOLDER_OF_THE_MANUAL
"""

import os
import re
import shlex
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM = sys.argv[1]
MANUAL = Path(sys.argv[2])


def run(*command, **options):
    return subprocess.run(command, check=True, capture_output=True, text=True, **options)


def help_of(*command):
    return run(PROGRAM, *command, "--help").stdout


def commands():
    """Names in the list of subcommands of the help."""
    listed = help_of().split("Subcommands:\n")[1].split("\n\n")[0]
    return re.findall(r"^  (\w+)", listed, re.MULTILINE)


def options_of(*command):
    """Spellings of the options in the help of a command."""
    listed = help_of(*command).split("Options:\n")[1].split("\n\n")[0]
    heads = re.findall(r"^  (-[\w,-]+)", listed, re.MULTILINE)
    return [spelling for head in heads for spelling in head.split(",")]


class ManPage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        environment = {**os.environ, "GROFF_NO_SGR": "1"}
        groff = run("groff", "-man", "-ww", "-Tutf8", "-rLL=100n", MANUAL / "bumpfoil.1", env=environment)
        cls.warnings = groff.stderr
        cls.text = re.sub(".\b", "", groff.stdout)

    def test_gives_no_reason_to_warn(self):
        self.assertEqual(self.warnings, "")

    def test_has_every_command_with_every_option(self):
        self.assertGreater(len(commands()), 10)
        sections = re.split(r"^   (\w+)$", self.text.split("\nCOMMANDS\n")[1], flags=re.MULTILINE)
        self.assertEqual(sections[1::2], commands())
        for command, section in zip(sections[1::2], sections[2::2]):
            listed = [option for head in re.findall(r"^       (-.*)", section, re.MULTILINE)
                      for option in re.findall(r"(?<!\S)-[\w-]+", head)]
            self.assertEqual(listed, options_of(command), command)

    def test_has_values_defaults_and_examples_as_they_are(self):
        self.assertIn("-o, --output DIR", self.text)
        self.assertIn("One of newton, uzawa, events.", self.text)
        self.assertIn("Default: gen1.", self.text)
        self.assertIn("--set 'cycle.directions=[\"+X\"]'", self.text)
        self.assertIn(run(PROGRAM, "--version").stdout.split()[1], self.text)


class Completion(unittest.TestCase):
    def complete(self, line, folder="/"):
        """What bash offers for the last word of a line, whose words and "=" are apart by spaces."""
        words = line.split(" ")
        script = f"""source {shlex.quote(str(MANUAL / "bumpfoil.bash"))}
            compopt() {{ :; }}  # it works in a terminal alone
            COMP_WORDS=({" ".join(map(shlex.quote, words))}); COMP_CWORD={len(words) - 1}
            _bumpfoil; printf '%s\\n' "${{COMPREPLY[@]}}" """
        result = run("bash", "--norc", "-c", script, cwd=folder)
        self.assertEqual(result.stderr, "")
        return result.stdout.split()

    def test_offers_commands(self):
        self.assertEqual(self.complete("bumpfoil "), ["help", *commands(), *options_of()])
        self.assertEqual(self.complete("bumpfoil mon"), ["montecarlo"])
        self.assertEqual(self.complete("bumpfoil help sw"), ["sweep"])

    def test_offers_options_of_the_command(self):
        for command in commands():
            self.assertEqual(self.complete(f"bumpfoil --quiet {command} -"), [*options_of(command), "--quiet"])
        self.assertEqual(self.complete("bumpfoil cycle case.toml --force --so"), ["--solver"])

    def test_offers_values(self):
        self.assertEqual(self.complete("bumpfoil cycle --solver "), ["newton", "uzawa", "events"])
        self.assertEqual(self.complete("bumpfoil sweep --command = str"), ["strip"])
        self.assertEqual(self.complete("bumpfoil montecarlo --samples "), [])

    def test_offers_keys_of_the_case_file(self):
        self.assertEqual(self.complete("bumpfoil cycle --set friction.co"), ["friction.coefficient="])
        self.assertEqual(self.complete("bumpfoil sweep --over bump_foil.truss.k"),
                         [f"bump_foil.truss.k{i}=" for i in (1, 2, 3, 4)])
        self.assertGreater(len(self.complete("bumpfoil check --set ")), 100)

    def test_offers_files_and_folders(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("case.toml", "casual.csv"):
                (Path(folder) / name).touch()
            (Path(folder) / "cases").mkdir()
            self.assertEqual(sorted(self.complete("bumpfoil cycle cas", folder)), ["case.toml", "cases"])
            self.assertEqual(sorted(self.complete("bumpfoil cycle --force cas", folder)), ["case.toml", "cases"])
            self.assertEqual(self.complete("bumpfoil cycle case.toml -o cas", folder), ["cases"])
            self.assertEqual(self.complete("bumpfoil cycle --output = cas", folder), ["cases"])
            self.assertEqual(self.complete("bumpfoil report ", folder), ["cases"])
            self.assertEqual(len(self.complete("bumpfoil report --measured cas", folder)), 3)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
