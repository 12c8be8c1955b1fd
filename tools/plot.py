#!/usr/bin/python3
"""Pictures of a run: `ashlar plot RUN`. Needs Debian's python3-numpy, python3-h5py and python3-matplotlib; no display."""
import argparse
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

from plotting import pictures, results  # noqa: E402

EXAMPLES = """
examples
  ashlar plot dam.run                                        the pictures that the deck asks for
  ashlar plot dam.run --of temperature --stage winter
  ashlar plot dam.run --of displacement.x --stage gravity --deform auto
  ashlar plot dam.run --of stress.zz --section y=2.5 --regions dam
  ashlar plot dam.run --of cracks --deform 200 --view iso
  ashlar plot dam.run --history crest                        over all stages, or along the one that takes time
  ashlar plot dam.run --history crest --stage year           along one stage
  ashlar plot rock.csv                                       the curves of ashlar material dam.lua rock --to rock.csv
  ashlar plot dam.run --of temperature --profile 0,30:60,30  from (x, z) to (x, z)
"""


def magnification(word):
    if word == "auto":
        return -1.0
    value = float(word)
    if value < 0:
        raise argparse.ArgumentTypeError("a magnification is not negative")
    return value


def line(word):
    try:
        start, end = (tuple(float(c) for c in point.split(",")) for point in word.split(":"))
        assert len(start) == len(end) == 2 and start != end
    except (ValueError, AssertionError):
        raise argparse.ArgumentTypeError(f"'{word}' is not of the form x0,z0:x1,z1") from None
    return start, end


def read_arguments(words):
    parser = argparse.ArgumentParser(prog="ashlar plot", description="Makes pictures (PNG) of a run.", epilog=EXAMPLES,
                                     formatter_class=argparse.RawDescriptionHelpFormatter, allow_abbrev=False)
    parser.add_argument("run", metavar="RUN", help="folder of a run, or curves of `ashlar material` (.csv)")
    parser.add_argument("--of", metavar="FIELD", help="displacement, temperature, stress.zz, ..., or cracks")
    parser.add_argument("--stage", default="", help="at the end of this stage (the last); of a history: along this stage")
    parser.add_argument("--deform", metavar="X", type=magnification, default=0.0,
                        help="magnification of the displacement, or auto (undeformed)")
    parser.add_argument("--section", default="", metavar="PLANE", help="y: cut at mid thickness; y=3.5: there (surface)")
    parser.add_argument("--view", default="", choices=["x", "y", "z", "iso"], help="direction of view (y)")
    parser.add_argument("--regions", default="", metavar="A,B", help="only these regions (all)")
    parser.add_argument("--history", metavar="NAME", help="curves of a history")
    parser.add_argument("--profile", metavar="X0,Z0:X1,Z1", type=line, help="a field along a line of a section")
    parser.add_argument("--out", metavar="FILE", help="picture file (in the folder of the run)")
    return parser.parse_args(words)


def draw(run, request, path):
    if request.of in ("cracks", "broken"):
        pictures.crack_picture(run, request, path)
    else:
        pictures.field_picture(run, request, path)


def asked_pictures(run):
    """(name, request) of the pictures that the deck asks for, else a set that shows each stage."""
    asked = [(p["name"], pictures.Request(of=p["of"], stage=p["stage"], deform=p["deform"], section=p["section"]))
             for p in run.manifest["pictures"]]
    return asked or pictures.sensible_set(run)


def main(words):
    arguments = read_arguments(words)
    if arguments.run.endswith(".csv"):
        path = pathlib.Path(arguments.out or pathlib.Path(arguments.run).with_suffix(".png"))
        pictures.material_picture(arguments.run, path)
        print(path)
        return
    run = results.Run(arguments.run)
    if len(words) == 1:
        made = []
        for name, request in asked_pictures(run):
            path = run.folder / f"{name}.png"
            draw(run, request, path)
            made.append(path)
    else:
        request = pictures.Request(of=arguments.of or "displacement", stage=arguments.stage, deform=arguments.deform,
                                   section=arguments.section, view=arguments.view,
                                   regions=tuple(r for r in arguments.regions.split(",") if r))
        parts = [arguments.history or request.of, request.stage, "profile" if arguments.profile else "", request.view]
        path = arguments.out or run.folder / ("-".join(p for p in parts if p).replace("=", "") + ".png")
        if arguments.history:
            pictures.history_picture(run, arguments.history, path, request.stage)
        elif arguments.profile:
            pictures.profile_picture(run, request, *arguments.profile, path)
        else:
            draw(run, request, path)
        made = [path]
    for path in made:
        print(path)


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except (pictures.PictureError, results.ResultsError) as error:
        print(f"ashlar plot: {error}", file=sys.stderr)
        sys.exit(2)
