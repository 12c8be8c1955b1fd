"""The pictures: fields on surfaces and sections, cracks, histories, profiles, curves of a material."""
import csv
import dataclasses
import pathlib

import numpy as np
from matplotlib import colormaps

from plotting import drawing, geometry


class PictureError(Exception):
    """What the user asked for does not exist; the message says what does."""


@dataclasses.dataclass
class Quantity:
    """How a field is shown: name in words, unit, factor from SI, colours."""
    words: str
    unit: str
    factor: float
    colours: str
    around_zero: bool = False


QUANTITIES = {
    "displacement": Quantity("displacement", "mm", 1e3, "viridis"),
    "temperature": Quantity("temperature", "\u00b0C", 1, "RdYlBu_r"),
    "stress": Quantity("stress", "MPa", 1e-6, "RdBu_r", True),
    "nodal_stress": Quantity("stress", "MPa", 1e-6, "RdBu_r", True),
    "principal_stress": Quantity("principal stress", "MPa", 1e-6, "RdBu_r", True),
    "plastic_strain": Quantity("plastic strain", "%", 1e2, "YlOrRd"),
    "damage": Quantity("damage", "", 1, "YlOrRd"),
    "normal_traction": Quantity("normal traction", "MPa", 1e-6, "RdBu_r", True),
    "shear_traction": Quantity("shear traction", "MPa", 1e-6, "YlOrRd"),
    "reaction": Quantity("reaction", "MN", 1e-6, "viridis"),
    "load": Quantity("load", "MN", 1e-6, "viridis"),
}
COMPONENTS = {1: [], 3: ["x", "y", "z"], 6: ["xx", "yy", "zz", "xy", "yz", "zx"]}
PRINCIPAL = ["largest", "middle", "smallest"]
CRACK_COLOURS = drawing.matplotlib.colors.LinearSegmentedColormap.from_list("cracks", ["#f4a582", "#d6301f", "#67001f"])

CLOSED = 1e-3            # mm
CLOSED_COLOUR = "#2b6cb0"


def quantity_of(field):
    return QUANTITIES.get(field, Quantity(field.replace("_", " "), "", 1, "viridis"))


def component_of(name, values):
    """(values [n], words) of "displacement" (magnitude), "displacement.x", "stress.zz", "principal_stress" (largest)."""
    field, _, component = name.partition(".")
    quantity = quantity_of(field)
    if values.ndim == 1:
        if component:
            raise PictureError(f"'{field}' has no component '{component}': it is one number")
        return values * quantity.factor, quantity.words
    names = PRINCIPAL if field == "principal_stress" else COMPONENTS.get(values.shape[1], [])
    if not component and field == "principal_stress":
        component = names[0]
    if not component and values.shape[1] == 3:
        return np.linalg.norm(values, axis=1) * quantity.factor, quantity.words
    if component not in names:
        raise PictureError(f"'{field}' needs a component: " + ", ".join(f"{field}.{n}" for n in names))
    return values[:, names.index(component)] * quantity.factor, f"{component} {quantity.words}" if component in PRINCIPAL else f"{quantity.words} {component}"


@dataclasses.dataclass
class Request:
    """One picture of a field or of the cracks."""
    of: str = "displacement"
    stage: str = ""            # "": the last one
    deform: float = 0          # magnification; 0: undeformed
    section: str = ""          # "": surface; "y": through the middle; "y=3.5"
    view: str = ""             # "": looking along y
    regions: tuple = ()        # (): all
    out: str = ""
    title: str = ""


def round_magnification(mesh, displacement):
    """1, 2 or 5 times a power of ten that shows the largest displacement as about 4 % of the model's size."""
    largest = np.linalg.norm(displacement, axis=1).max()
    if not largest > 0:
        return 0.0
    wanted = 0.04 * np.ptp(mesh.points, axis=0).max() / largest
    power = 10.0 ** np.floor(np.log10(wanted))
    return float(power * max(step for step in (1, 2, 5) if step * power <= wanted * (1 + 1e-12)))


def polygons_for(run, request, points=None):
    """(polygons, view, words of the place) that a request shows; of a surface those seen where it is drawn, at `points`
    (undeformed)."""
    mesh = run.mesh
    points = mesh.points if points is None else points
    unknown = [r for r in request.regions if r not in mesh.region_names]
    if unknown:
        raise PictureError(f"there is no region '{unknown[0]}'; regions: " + ", ".join(mesh.region_names))
    elements = np.isin(mesh.regions, [mesh.region_names.index(r) for r in request.regions]) if request.regions \
        else np.ones(len(mesh.types), bool)
    if not request.section:
        view = geometry.view_along(request.view or "y")
        polygons = geometry.facing(geometry.outer_faces(mesh, elements, points), points, view)
        return polygons, view, "surface"
    axis, place = section_plane(run, request)
    try:
        polygons = geometry.section(mesh, elements, axis, place)
    except ValueError as error:
        raise PictureError(str(error)) from error
    return polygons, geometry.view_along(request.view or "xyz"[axis]), f"section {'xyz'[axis]} = {place:g} m"


def section_plane(run, request):
    """(axis, position) of the section that a request names, or None."""
    if not request.section:
        return None
    axis, _, position = request.section.partition("=")
    if axis not in ("x", "y", "z"):
        raise PictureError(f"section '{request.section}': give x, y or z, or a place such as y=3.5")
    number = "xyz".index(axis)
    along = run.mesh.points[:, number]
    try:
        return number, float(position) if position else (along.min() + along.max()) / 2
    except ValueError:
        raise PictureError(f"section '{request.section}': '{position}' is no number") from None


def field_picture(run, request, path):
    """Contours of a field on the surface or a section, on the deformed shape if asked."""
    output = run.output(request.stage)
    where, raw = run.field(request.of.partition(".")[0], output)
    values, words = component_of(request.of, raw)
    quantity = quantity_of(request.of.partition(".")[0])
    points, deform_words = deformed(run, request, output)
    polygons, view, place = polygons_for(run, request, points)
    original, moved = polygons.at_corners(run.mesh.points), polygons.at_corners(points)

    shown = polygons.at_corners(values) if where == "point" else values[polygons.cell]
    around_zero = quantity.around_zero or "." in request.of and shown.min() < 0 < shown.max()
    colours = colormaps["RdBu_r" if around_zero else quantity.colours]
    levels = drawing.bands(shown.min(), shown.max(), around_zero)

    figure, axes = drawing.figure_for(np.concatenate([original, moved]), view)
    draw_undeformed(axes, polygons, run, original, points, view)
    drawing.fill(axes, polygons, moved, shown, levels, colours, view, outline_of(run, polygons))
    drawing.frame(axes, np.concatenate([original, moved]), view)
    drawing.colour_bar(figure, axes, levels, colours, f"{words} [{quantity.unit}]")
    places = (moved, original) if where == "point" else (polygons.mean(moved), polygons.mean(original))
    note = drawing.extremes(axes, places[0], shown, places[1], view, quantity.unit)
    drawing.title(axes, request.title or f"{run.name}: {words}, {output.words}", f"{place}{deform_words}\n{note}")
    drawing.save(figure, path)


def deformed(run, request, output):
    """([nodes, 3] places of the deformed shape, words that say the magnification)."""
    if not request.deform:
        return run.mesh.points, ""
    displacement = run.field("displacement", output)[1]
    factor = request.deform if request.deform > 0 else round_magnification(run.mesh, displacement)
    return run.mesh.points + factor * displacement, f", deformed \u00d7{factor:g} (grey: undeformed)"


def outline_of(run, polygons):
    return geometry.outline(polygons, run.mesh.points, run.mesh.regions)


def draw_undeformed(axes, polygons, run, original, points, view):
    if points is not run.mesh.points:
        drawing.lines(axes, original[outline_of(run, polygons)], view, colors="0.55", linewidths=0.8,
                      linestyles=(0, (4, 2)), zorder=3)


def crack_picture(run, request, path):
    """Broken interface faces where they meet the surface or section, coloured by opening, over the grey body."""
    output = run.output(request.stage)
    polygons, view, place = polygons_for(run, request)
    points, deform_words = deformed(run, request, output)
    original, moved = polygons.at_corners(run.mesh.points), polygons.at_corners(points)
    faces = run.interfaces(output)
    halves, state, opening = geometry.traces(polygons, original, faces, section_plane(run, request))
    broken = state > 0
    begin, opening = halves[broken, 0], opening[broken] * 1e3
    ends = np.stack([moved[begin], (moved[begin] + moved[halves[broken, 1]]) / 2], axis=1)

    focus = np.concatenate([near(shown, original, faces.points) for shown in (original, moved)])
    figure, axes = drawing.figure_for(focus, view)
    tone = np.array([0.90, 0.80, 0.85, 0.75])[run.mesh.regions[polygons.cell] % 4]
    draw_undeformed(axes, polygons, run, original, points, view)
    drawing.plain(axes, polygons, moved, view, tone, outline_of(run, polygons))
    closed = opening < CLOSED
    if closed.any():
        drawing.lines(axes, ends[closed], view, colors=CLOSED_COLOUR, linewidths=2.2, zorder=4)
        axes.plot([], [], color=CLOSED_COLOUR, linewidth=2.2, label="cracked, closed")
        axes.legend(loc="upper right", fontsize=9, frameon=False)
    if not closed.all():
        levels = drawing.bands(0, opening.max())
        order = np.flatnonzero(~closed)[np.argsort(opening[~closed], kind="stable")]
        colours = CRACK_COLOURS(drawing.BoundaryNorm(levels, CRACK_COLOURS.N)(opening[order]))
        drawing.lines(axes, ends[order], view, colors=colours, linewidths=2.6, zorder=5)
        drawing.colour_bar(figure, axes, levels, CRACK_COLOURS, "crack opening [mm]")
    drawing.frame(axes, focus, view, margin=0.08)
    note = crack_note(faces)
    drawing.title(axes, request.title or f"{run.name}: cracks, {output.words}", f"{place}{deform_words}\n{note}")
    drawing.save(figure, path)


def near(moved, original, points):
    """The drawn corners inside the box around the given points, widened by a tenth."""
    low, high = points.min(axis=0), points.max(axis=0)
    pad = 0.1 * (high - low).max()
    return moved[np.all((original > low - pad) & (original < high + pad), axis=1)]


def crack_note(faces):
    broken = np.flatnonzero(faces.state > 0)
    if not len(broken):
        return f"no crack: {len(faces)} interface faces intact"
    worst = broken[np.argmax(faces.opening[broken])]
    at = ", ".join(f"{round(c, 2) + 0.0:g}" for c in faces.points[worst])
    return (f"{np.count_nonzero(faces.cracked_share)} of {len(faces)} interface faces cracked, "
            f"{faces.area @ faces.cracked_share:.4g} m\u00b2; widest {1e3 * faces.opening[worst]:.3g} mm at ({at}) m")


def along_a_stage(table, stage):
    """(places, label) of the rows of one stage: its time or its load factor."""
    rows = table.rows_of(stage)
    seconds = table.seconds[rows]
    if not seconds.any():
        return table.load_factor[rows], "load factor"
    for unit, length in (("years", 365.25 * 86400), ("days", 86400), ("h", 3600), ("s", 1)):
        if seconds.max() > 3 * length or unit == "s":
            return seconds / length, f"time [{unit}]"


def history_picture(run, name, path, stage=""):
    """One panel per quantity, one line per component: along a stage, the only one with a way unless named, else over
    all stages."""
    table = run.history(name)
    if stage and stage not in table.stages:
        raise PictureError(f"history '{name}' has no row of a stage '{stage}'; stages: "
                           + ", ".join(dict.fromkeys(table.stages)))
    if not stage and len(table.stages_with_a_way) == 1:
        stage = table.stages_with_a_way[0]
    rows = table.rows_of(stage) if stage else np.ones(len(table.time), bool)
    places, label = along_a_stage(table, stage) if stage else \
        (table.time, "stages done, with the fraction of the present one")
    balanced = table.balanced[rows]
    groups = {}
    for column in table.columns:
        if column != "seconds":
            groups.setdefault(column.partition(".")[0], []).append(column)
    figure, panels = drawing.plt.subplots(len(groups), 1, figsize=(8, 1.2 + 2.4 * len(groups)), sharex=True,
                                          squeeze=False, layout="constrained")
    for axes, (field, columns) in zip(panels[:, 0], groups.items()):
        quantity = quantity_of(field)
        for column in columns:
            values = table.values[column][rows] * quantity.factor
            drawn, = axes.plot(places[balanced], values[balanced], "o-", markersize=3, linewidth=1.3,
                               label=column.partition(".")[2] or field)
            axes.plot(places[~balanced], values[~balanced], "x", markersize=8, color=drawn.get_color(),
                      label="not in balance" if not balanced.all() and column == columns[-1] else None)
        axes.set_ylabel(f"{field} [{quantity.unit or table.units[columns[0]]}]")
        axes.grid(alpha=0.3)
        if len(columns) > 1 or not balanced.all():
            axes.legend(fontsize=8, ncols=4, frameon=False)
    if not stage:
        for end, ended in table.stage_ends:
            for axes in panels[:, 0]:
                axes.axvline(end, color="0.7", linewidth=0.8)
            panels[0, 0].annotate(ended, (end, 1.0), xycoords=("data", "axes fraction"), xytext=(-3, 3), ha="right",
                                  textcoords="offset points", fontsize=8, color="0.3")
    panels[-1, 0].set_xlabel(label)
    figure.suptitle(f"{run.name}: history {name}" + (f", stage {stage}" if stage else ""), fontsize=12,
                    fontweight="bold", x=0.01, ha="left")
    drawing.save(figure, path)


def material_picture(table, path):
    """Curves that `ashlar material --to` wrote: stress over strain, and what the law counts, one panel a test."""
    try:
        with open(table, encoding="utf-8", newline="") as file:
            header, *rows = csv.reader(file)
        tests = dict.fromkeys(row[0] for row in rows)
        values = {test: np.array([row[1:] for row in rows if row[0] == test], float) for test in tests}
        counted = header[5]
    except (OSError, ValueError, IndexError) as error:
        raise PictureError(f"{table} is no table of `ashlar material DECK NAME --to FILE.csv`: {error}") from None
    figure, panels = drawing.plt.subplots(2, (len(tests) + 1) // 2, figsize=(3.6 * ((len(tests) + 1) // 2), 6.5),
                                          squeeze=False, layout="constrained")
    for axes, (test, v) in zip(panels.flat, values.items()):
        axes.plot(100 * v[:, 0], v[:, 1] / 1e6, linewidth=1.5, label="stress")
        axes.plot(100 * v[:, 0], v[:, 2] / 1e6, "--", linewidth=1, label="lateral stress")
        axes.set_title(test, fontsize=9, loc="left")
        axes.set_xlabel("strain [%]")
        axes.set_ylabel("stress [MPa]")
        axes.grid(alpha=0.3)
        other = axes.twinx()
        other.plot(100 * v[:, 0], v[:, 4], ":", color="0.4", linewidth=1.2)
        other.set_ylabel(counted.replace("_", " ") + " (dotted)", fontsize=8, color="0.4")
    for axes in panels.flat[len(tests):]:
        axes.set_visible(False)
    panels.flat[0].legend(fontsize=8, frameon=False)
    figure.suptitle(f"{pathlib.Path(table).stem}: one point, tension positive", fontsize=12, fontweight="bold", x=0.01,
                    ha="left")
    drawing.save(figure, path)


def profile_picture(run, request, start, end, path, samples=200):
    """A field along a straight line in the plane of a section."""
    output = run.output(request.stage)
    field = request.of.partition(".")[0]
    where, raw = run.field(field, output)
    values, words = component_of(request.of, raw)
    quantity = quantity_of(field)
    polygons, view, place = polygons_for(run, dataclasses.replace(request, section=request.section or "y"))
    corners = polygons.at_corners(run.mesh.points)
    shown = polygons.at_corners(values) if where == "point" else np.repeat(values[polygons.cell], np.diff(polygons.start))
    triangles, places, levels_at, _ = drawing.fans(polygons, corners, shown)
    at = view.project(places)
    share = np.linspace(0, 1, samples)
    line = np.outer(1 - share, start) + np.outer(share, end)
    found = geometry.sample(view.project(places)[triangles], levels_at[triangles], line)
    if np.isnan(found).all():
        raise PictureError(f"the profile from {tuple(start)} to {tuple(end)} misses the model")
    upright = abs(end[1] - start[1]) > abs(end[0] - start[0])
    figure, axes = drawing.plt.subplots(figsize=(5.5, 6.5) if upright else (8, 4.5), layout="constrained")
    label = f"{words} [{quantity.unit}]"
    if upright:
        axes.plot(found, line[:, 1], linewidth=1.5)
        axes.set_xlabel(label)
        axes.set_ylabel(f"{view.labels[1]} [m]")
    else:
        axes.plot(line[:, 0], found, linewidth=1.5)
        axes.set_xlabel(f"{view.labels[0]} [m]")
        axes.set_ylabel(label)
    axes.grid(alpha=0.3)
    ends = " to ".join(f"({p[0]:g}, {p[1]:g})" for p in (start, end))
    drawing.title(axes, f"{run.name}: {words}, {output.words}", f"{place}, ({', '.join(view.labels)}) from {ends} m")
    drawing.save(figure, path)


def sensible_set(run):
    """(name, request) of pictures that show every stage: what moved, how warm, what broke."""
    chosen = []
    for stage in dict.fromkeys(o.stage for o in run.outputs):
        if stage in run.thermal_stages():
            chosen.append((f"temperature-{stage}", Request(of="temperature", stage=stage)))
        else:
            chosen.append((f"displacement-{stage}", Request(of="displacement", stage=stage, deform=-1)))
    if run.has_interfaces():
        chosen.append(("cracks", Request(of="cracks", deform=-1)))
    return chosen
