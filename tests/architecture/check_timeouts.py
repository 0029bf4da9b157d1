"""Fails where a test could hang for ever: every test has a TIMEOUT and a label.

Usage: check_timeouts.py CTEST BUILD
"""

import json
import subprocess
import sys


def find_errors(tests):
    for test in tests:
        properties = {entry["name"]: entry["value"] for entry in test.get("properties", [])}
        for name in ("TIMEOUT", "LABELS"):
            if name not in properties:
                yield f"{test['name']}: no {name}; see tests/CMakeLists.txt"


if __name__ == "__main__":
    ctest, build = sys.argv[1:]
    shown = subprocess.run([ctest, "--test-dir", build, "--show-only=json-v1"], check=True, capture_output=True)
    tests = json.loads(shown.stdout)["tests"]
    found = list(find_errors(tests))
    print("\n".join(found) or f"{len(tests)} tests, each with a time to end in.")
    sys.exit(1 if found or not tests else 0)
