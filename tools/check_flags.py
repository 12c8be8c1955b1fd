#!/usr/bin/python3
"""Checks that every source is compiled with the flags that the bits of its numbers depend on (src/ARCHITECTURE.md).

usage: check_flags.py BUILD          BUILD is a folder that CMake made for Ninja
Prints one line per violation; exit code 1 if there is any.
"""
import json
import re
import subprocess
import sys

CXX_FLAGS = ["-ffp-contract=off", "-fno-math-errno"]
CUDA_FLAGS = ["-fmad=false", "-ftz=false", "-prec-div=true", "-prec-sqrt=true"]
FORBIDDEN = re.compile(r"^(-Ofast|-ffast-math|-funsafe-math-optimizations|-fassociative-math|-frounding-math"
                       r"|-use_fast_math|--use_fast_math|-DNDEBUG)$")
MARCH = re.compile(r"-march=([\w-]+)")


def complaints_about(command, file, machines):
    """Yields what is wrong with one compile command; adds its instruction set to `machines`."""
    words = re.split(r"[\s,]+|(?<==)(?=-f)", command)
    cuda = file.endswith(".cu")
    for flag in CXX_FLAGS + (CUDA_FLAGS if cuda else []):
        if not any(word.endswith(flag) for word in words):
            yield f"{file}: compiled without {flag}"
    for word in words:
        if FORBIDDEN.match(word) and not (word == "-frounding-math" and "/cgal/" in file):  # CGAL cannot do without
            yield f"{file}: compiled with {word}"
    found = MARCH.findall(command)
    if not found:
        yield f"{file}: compiled without -march"
    machines.update(found)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    listing = subprocess.run(["ninja", "-C", sys.argv[1], "-t", "compdb"], capture_output=True, text=True, check=True)
    commands = sorted((entry["file"], entry["command"]) for entry in json.loads(listing.stdout)
                      if entry["file"].endswith((".cpp", ".cu")) and " -c " in entry["command"])
    if not commands:
        sys.exit(f"check_flags: {sys.argv[1]} compiles nothing")
    machines = set()
    wrong = [text for file, command in commands for text in complaints_about(command, file, machines)]
    if len(machines) > 1:
        wrong.append("more than one instruction set in one build: " + ", ".join(sorted(machines)))
    print("\n".join(wrong) if wrong else f"{len(commands)} sources, one instruction set, the flags of equal bits")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
