#!/usr/bin/python3
"""Everything that has to be true of an NVIDIA device, run on the machine that has one, in one report (markdown).

gpu_report.py                                       builds into build/ if there is no program yet
gpu_report.py --program ASHLAR --parity TEST_PARITY uses what has been built; needs nothing but python3 for that
gpu_report.py --time 600                            stops beginning rows that would not fit into 600 s; the report says so
gpu_report.py --device cpu                          the same steps without a device, to try the script

Parity of every phase, whole staged runs on both machines, a run that is killed and goes on, the refusal for lack of
memory, compute-sanitizer, the benchmark. A step that fails is written down and the others go on. Exit code: 0, or 1 if
something failed.
"""
import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
# Deck, arguments, precision.
RUNS = [("verify/d0_elastic", [], "double"), ("verify/d0_staged", [], "double"), ("verify/d0_exploded", [], "double"),
        ("verify/d0_heat", ["transient=true", "fine=true"], "double"), ("verify/pulled_blocks", [], "double"),
        ("verify/sliding_block", [], "double"), ("verify/tumbling_block", [], "double"), ("verify/crack_heat", [], "double"),
        ("verify/thick_cylinder_plastic", [], "double"),
        ("verify/shaken_bar", [], "double"), ("verify/yearly_ground", [], "double"), ("dam/koyna", [], "double"), ("dam/seasons", [], "double"),
        ("verify/d0_staged", [], "single"), ("verify/d0_heat", ["transient=true", "fine=true"], "single"),
        ("verify/shaken_bar", [], "single"), ("dam/seasons", [], "single")]
# Size, works, seconds that a row may take; hosts set up about 150 000 elements a second.
SIZES = [(30000, ("elastic", "heat", "crackable"), 120), (300000, ("elastic", "heat", "crackable"), 180),
         (2400000, ("elastic", "heat", "crackable"), 300), (20000000, ("elastic", "heat"), 900)]
SANITIZED = [("memcheck", "*Nvidia*double_mixed*:*Nvidia*double_sliding_r1*", 240),
             ("racecheck", "*Nvidia*single_mixed*", 400), ("initcheck", "*Nvidia*double_mixed*", 240)]


class Report:
    def __init__(self, path, budget):
        self.path, self.lines, self.failed, self.left_out = path, [], [], []
        self.end = time.monotonic() + budget if budget else float("inf")

    def add(self, *lines):
        self.lines += lines
        self.path.write_text("\n".join(self.lines) + "\n", encoding="utf-8")
        print("\n".join(lines), flush=True)

    def head(self, title):
        self.add("", f"## {title}", "")

    def table(self, *columns):
        self.add("| " + " | ".join(columns) + " |", "|" + "---|" * len(columns))

    def row(self, *cells):
        self.add("| " + " | ".join(str(cell) for cell in cells) + " |")

    def fail(self, what, words=""):
        self.failed.append(what)
        tail = [line for line in words.strip().splitlines() if line][-15:]
        self.add("", f"**FAILED: {what}**", *(["```", *tail, "```"] if tail else []), "")

    def room_for(self, what, seconds):
        if time.monotonic() + seconds <= self.end:
            return True
        self.left_out.append(what)
        return False

    def run(self, words, limit, **more):
        """Exit code (None: out of time or not there), output and seconds of a command."""
        start = time.monotonic()
        limit = max(1, min(limit, self.end - start))
        try:
            done = subprocess.run([str(w) for w in words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                  errors="replace", timeout=limit, check=False, **more)
            return done.returncode, done.stdout, time.monotonic() - start
        except subprocess.TimeoutExpired as late:
            words = late.stdout or b""
            words = words.decode(errors="replace") if isinstance(words, bytes) else words
            return None, f"{words}\nnot done after {limit:.0f} s", time.monotonic() - start
        except OSError as error:
            return None, str(error), 0.0


def build(report, options):
    """Program and parity test, built if they were not given."""
    if options.program and options.parity:
        return options.program, options.parity
    report.head("Build")
    cuda = "ON" if options.device.startswith("cuda") else "OFF"
    for words in (["cmake", "-S", ROOT, "-B", options.build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", f"-DASHLAR_CUDA={cuda}"],
                  ["cmake", "--build", options.build, "--target", "ashlar", "test_parity"]):
        code, words_out, seconds = report.run(words, 7200)
        report.add(f"`{' '.join(map(str, words))}`: {'done' if code == 0 else 'failed'} in {seconds:.0f} s", "")
        if code != 0:
            report.fail("build", words_out)
    return options.program or options.build / "ashlar", options.parity or options.build / "tests/test_parity"


def machine(report, program):
    report.head("Machine")
    for words in ([program, "info"], ["nvidia-smi", "--query-gpu=name,driver_version,memory.total,clocks.max.sm",
                                      "--format=csv"], ["git", "-C", ROOT, "log", "-1", "--format=commit %h of %cd"]):
        code, words_out, _ = report.run(words, 60)
        if code == 0:
            report.add("```", words_out.strip(), "```")
        elif words[0] == program:
            report.fail("ashlar info", words_out)


def parity(report, test, on_device):
    report.head("Parity: every phase, bit by bit")
    chosen = "*Nvidia*" if on_device else "-*Nvidia*"
    if not report.room_for("parity", 60):
        return
    code, words, seconds = report.run([test, f"--gtest_filter={chosen}"], 900)
    for line in words.splitlines():
        if "compared bit by bit" in line:
            report.add("- " + line.strip())
    passed = re.search(r"\[  PASSED  \] (\d+) test", words)
    skipped = re.search(r"\[  SKIPPED \] (\d+) test", words)
    report.add("", f"`{test.name} --gtest_filter='{chosen}'`: {passed[1] if passed else 0} passed in {seconds:.1f} s")
    if code != 0 or not passed or skipped:
        report.fail("parity", words)


def stages(folder):
    manifest = json.loads((folder / "manifest.json").read_text(encoding="utf-8"))
    return manifest["device"], manifest["stages"]


def whole_runs(report, program, device, work):
    report.head(f"Whole runs: cpu against {device}")
    report.table("deck", "precision", "cpu, s", f"{device}, s", "`compare --tolerance 0`")
    times = []
    for deck, arguments, precision in RUNS:
        name = " ".join([deck, *arguments])
        if not report.room_for(f"run {name}, {precision}", 30):
            continue
        folders, seconds, bad = [], [], False
        for where in ("cpu", device):
            folder = work / f"{deck.replace('/', '_')}_{precision}_{len(folders)}"
            settings = [word for a in arguments for word in ("--set", a)]
            code, words, taken = report.run([program, "run", ROOT / "decks" / f"{deck}.lua", "--device", where, "--precision",
                                             precision, "--out", folder, *settings], 900)
            folders.append(folder)
            seconds.append(f"{taken:.1f}")
            # A verification deck may ask for more than single precision gives.
            if code not in ((0,) if precision == "double" else (0, 3, 4)):
                report.fail(f"{name} on {where}, {precision}", words)
                bad = True
                break
        if bad:
            continue
        code, words, _ = report.run([program, "compare", *folders, "--tolerance", "0"], 300)
        report.row(name, precision, *seconds, "same bits" if code == 0 else "**they differ**")
        if code != 0:
            report.fail(f"{name}, {precision}: other bits on {device}", words)
        times.append((name, precision, folders))
    report.head("Wall time of stages, s")
    report.table("deck", "stage", "kind", "steps", "cpu", device, f"of {device}: by activity")
    for name, precision, folders in times:
        if precision != "double":
            continue
        (_, one), (_, other) = (stages(folder) for folder in folders)
        for a, b in zip(one, other):
            activities = ", ".join(f"{k} {v:.2g}" for k, v in b.get("activity_seconds", {}).items() if v > 0.02 * b["wall_seconds"])
            report.row(name, a["name"], a["kind"], a["steps"], f"{a['wall_seconds']:.3g}", f"{b['wall_seconds']:.3g}", activities)


def killed_run(report, program, device, work):
    report.head("A run that is killed goes on")
    if not report.room_for("killed run", 60):
        return
    deck, whole, killed = ROOT / "decks/dam/seasons.lua", work / "whole", work / "killed"
    options = ["--device", device]
    code, words, seconds = report.run([program, "run", deck, "--out", whole, *options], 300)
    with subprocess.Popen([program, "run", deck, "--out", killed, "--checkpoint-every", "1e-6", *options],
                          stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as run:
        try:
            run.wait(timeout=0.6 * seconds)
        except subprocess.TimeoutExpired:
            run.kill()
    resumed, resume_words, _ = report.run([program, "resume", killed, "--device", "cpu"], 300)
    same, compare_words, _ = report.run([program, "compare", whole, killed, "--tolerance", "0"], 60)
    report.add(f"seasons on {device}, killed after {0.6 * seconds:.1f} s, `resume --device cpu`: "
               f"{(resume_words.splitlines() or ['nothing'])[0]}; " + ("same bits" if same == 0 else "they differ"))
    if code != 0 or resumed != 0 or same != 0:
        report.fail("resume", words + resume_words + compare_words)


def lack_of_memory(report, program, device, work):
    report.head("Lack of memory is told before it is taken")
    if not report.room_for("lack of memory", 20):
        return
    code, words, _ = report.run([program, "run", ROOT / "decks/dam/seasons.lua", "--out", work / "none", "--device", device,
                                 "--memory", "0.0005"], 120)
    report.add(f"exit code {code}:", "```", words.strip(), "```")
    if code != 5 or "would fit" not in words:
        report.fail("lack of memory")


def sanitizer(report, test):
    report.head("compute-sanitizer")
    tool = shutil.which("compute-sanitizer") or next(
        (str(p) for p in [pathlib.Path("/usr/local/cuda/bin/compute-sanitizer")] if p.exists()), None)
    if not tool:
        report.left_out.append("compute-sanitizer: not installed")
        return report.add("not installed")
    report.table("tool", "tests", "seconds", "found")
    for name, chosen, limit in SANITIZED:
        if not report.room_for(f"compute-sanitizer {name}", limit / 2):
            continue
        code, words, seconds = report.run([tool, "--tool", name, "--error-exitcode", "9", test, f"--gtest_filter={chosen}"], limit)
        found = [line.strip("= ") for line in words.splitlines() if "SUMMARY" in line]
        report.row(name, f"`{chosen}`", f"{seconds:.0f}", found[-1] if found else "no summary")
        if code != 0 or not found:
            report.fail(f"compute-sanitizer {name}", words)


def bench(report, program, device, work):
    report.head("Benchmark")
    rows = []
    for size, works, limit in SIZES:
        for name in works:
            # Rows of the CPU too where they are quick; a device alone beyond.
            where = device if size > 3000000 and device != "cpu" else "auto" if device.startswith("cuda") else device
            if not report.room_for(f"bench {name}, {size} elements", limit / 2):
                continue
            file = work / f"bench_{name}_{size}.json"
            code, words, _ = report.run([program, "bench", name, "--elements", str(size), "--device", where, "--out", file], limit)
            if code != 0 or not file.exists():
                report.fail(f"bench {name}, {size} elements", words)
                continue
            rows += json.loads(file.read_text(encoding="utf-8"))["rows"]
    report.table("work", "shape", "elements", "device", "number", "M element-steps/s", "us a step", "share of copy", "B/element",
                 "x textbook", "x one core", "x all cores", "set-up, s", "shares, phases one by one")
    for r in rows:
        number = lambda key, form, r=r: format(r[key], form) if key in r else ""  # noqa: E731
        shares = ", ".join(f"{k} {100 * v:.0f} %" for k, v in r.get("share", {}).items() if v >= 0.005)
        report.row(r["work"], r["shape"], r["elements"], r["device"], r["precision"], f"{r['element_steps_per_second'] / 1e6:.2f}",
                   number("microseconds_per_step", ".1f"), number("share_of_copy_bandwidth", ".0%"),
                   number("memory_bytes_per_element", ".0f"), number("over_textbook", ".3g"), number("over_serial", ".3g"),
                   number("over_all_cores", ".3g"), number("set_up_seconds", ".1f"), shares)
    hex8 = [r for r in rows if r["work"] == "elastic" and r["shape"] == "hex8" and r["machine"] == "device" and r["elements"] > 2e6]
    for precision in ("double", "single"):
        bytes_each = [r["memory_bytes_per_element"] for r in hex8 if r["precision"] == precision]
        if bytes_each:
            report.add("", f"Elastic hex8, {precision}: {bytes_each[-1]:.0f} bytes an element, "
                           f"{80e9 / bytes_each[-1] / 1e6:.0f} million elements in 80 GB.")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=pathlib.Path, help="ashlar, already built")
    parser.add_argument("--parity", type=pathlib.Path, help="test_parity, already built")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build", help="folder to build in")
    parser.add_argument("--device", default="cuda", help="cuda, cuda:N, or cpu to try the script")
    parser.add_argument("--time", type=float, default=0, help="seconds in all (no limit)")
    parser.add_argument("--report", type=pathlib.Path, default=pathlib.Path("gpu_report.md"))
    parser.add_argument("--only", default="", help="steps, with commas: parity,runs,killed,memory,sanitizer,bench")
    options = parser.parse_args()
    report = Report(options.report, options.time)
    report.add("# Ashlar on " + ("an NVIDIA device" if options.device.startswith("cuda") else "the CPU (a trial of the script)"))
    program, test = build(report, options)
    program, test = program.resolve(), test.resolve()
    os.environ.setdefault("OMP_WAIT_POLICY", "passive")
    with tempfile.TemporaryDirectory() as place:
        work = pathlib.Path(place)
        steps = {"parity": lambda: parity(report, test, options.device.startswith("cuda")),
                 "memory": lambda: lack_of_memory(report, program, options.device, work),
                 "killed": lambda: killed_run(report, program, options.device, work),
                 "runs": lambda: whole_runs(report, program, options.device, work),
                 "bench": lambda: bench(report, program, options.device, work),
                 "sanitizer": lambda: sanitizer(report, test)}
        machine(report, program)
        for name, step in steps.items():
            if options.only and name not in options.only.split(","):
                report.left_out.append(f"{name}: not asked for")
                continue
            try:
                step()
            except Exception as error:  # noqa: BLE001: the other steps go on
                report.fail(f"{name}: {type(error).__name__}: {error}")
    report.head("Left out")
    report.add(*(["- " + what for what in report.left_out] or ["nothing"]))
    report.head("Failed")
    report.add(*(["- " + what for what in report.failed] or ["nothing"]))
    return 1 if report.failed else 0


if __name__ == "__main__":
    sys.exit(main())
