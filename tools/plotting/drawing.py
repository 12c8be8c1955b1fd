"""Drawing on matplotlib axes: banded contours, outlines, crack traces, colour bars with units, extremes with their place."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from matplotlib.collections import LineCollection, PolyCollection  # noqa: E402
from matplotlib.colors import BoundaryNorm  # noqa: E402
from matplotlib.ticker import MaxNLocator  # noqa: E402
from matplotlib.tri import Triangulation  # noqa: E402

plt.rcParams.update({"font.family": "DejaVu Sans", "font.size": 10, "axes.spines.top": False,
                     "axes.spines.right": False, "savefig.facecolor": "white"})

INK = "0.1"
MOST_MESH_LINES = 4000  # polygons; a finer mesh drawn in lines is only grey


def bands(low, high, around_zero=False):
    """Round boundaries of about a dozen colour bands that hold low and high."""
    if around_zero:
        high = max(abs(low), abs(high))
        low = -high
    if not high - low > 1e-9 * max(abs(low), abs(high)):  # one value: a narrow band around it
        half = max(abs(high), 1.0) * 1e-3
        return np.linspace(low - half, high + half, 4)
    return MaxNLocator(nbins=14, steps=[1, 2, 2.5, 5, 10]).tick_values(low, high)


def fill(axes, polygons, corners, values, levels, colours, view, outline):
    """Coloured polygons with their outline, [edges, 2] corner numbers. `values` has one entry per corner (banded
    contours) or per polygon (flat colours)."""
    flat = len(values) == len(polygons)
    norm = BoundaryNorm(levels, colours.N)
    if flat and view.flat:
        shapes = np.split(view.project(corners), polygons.start[1:-1])
        axes.add_collection(PolyCollection(shapes, facecolors=colours(norm(values)), edgecolors="face", linewidths=0.3))
    else:
        triangles, places, levels_at, owner = fans(polygons, corners, np.repeat(values, np.diff(polygons.start)) if flat
                                                   else values)
        if view.flat:
            fill_contours(axes, view.project(places), levels_at, triangles, levels, colours)
        else:
            colour = colours(norm(flattened(levels_at[triangles])))
            return by_depth(axes, places[triangles], owner, colour, polygons, corners, outline, view)
    mesh_lines(axes, polygons, corners, view)
    lines(axes, corners[outline], view, colors=INK, linewidths=0.9)


def plain(axes, polygons, corners, view, shades, outline):
    """Polygons in one grey each with their outline."""
    grey = np.column_stack([np.repeat(np.asarray(shades)[:, None], 3, axis=1), np.ones(len(shades))])
    if view.flat:
        axes.add_collection(PolyCollection(np.split(view.project(corners), polygons.start[1:-1]), facecolors=grey,
                                           edgecolors="face", linewidths=0.3))
        mesh_lines(axes, polygons, corners, view)
        lines(axes, corners[outline], view, colors=INK, linewidths=0.9)
    else:
        triangles, places, _, owner = fans(polygons, corners, np.zeros(len(corners)))
        by_depth(axes, places[triangles], owner, np.repeat(grey[owner], PARTS, axis=0), polygons, corners, outline, view)


def fans(polygons, corners, values):
    """Each polygon as triangles around its centre: (triangles, points, values, polygon of each triangle)."""
    edges = polygons.edges()
    owner = polygons.owner()
    places = np.concatenate([corners, polygons.mean(corners)])
    triangles = np.column_stack([edges, len(corners) + owner])
    return triangles, places, np.concatenate([values, polygons.mean(values)]), owner


def fill_contours(axes, at, values, triangles, levels, colours):
    # Corners at one place with one value become one node, so that contours run through elements that share it and stop
    # where the field jumps.
    grain = 1e-6 * max(np.ptp(at, axis=0).max(), 1e-300)
    step = 1e-6 * max(levels[-1] - levels[0], 1e-300)
    key = np.column_stack([np.round(at / grain), np.round(values / step)]).astype(np.int64)
    _, index, node = np.unique(key, axis=0, return_index=True, return_inverse=True)
    mesh = Triangulation(at[index, 0], at[index, 1], node[triangles])
    axes.tricontourf(mesh, np.clip(values[index], levels[0], levels[-1]), levels=levels, cmap=colours,
                     norm=BoundaryNorm(levels, colours.N), antialiased=False)


def by_depth(axes, triangles, owner, colour, polygons, corners, outline, view):
    """Painter's order: the polygons come far ones first; each is shaded by how it turns to the light, and its mesh and
    outline edges follow it, so that what lies nearer hides them too. `colour` has PARTS entries per triangle."""
    normal = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    normal /= np.maximum(np.linalg.norm(normal, axis=1), 1e-300)[:, None]
    light = -view.away + 0.6 * view.up - 0.4 * view.right
    shade = 0.68 + 0.32 * np.clip(normal @ (light / np.linalg.norm(light)), 0, 1)
    colour[:, :3] *= np.repeat(shade, PARTS)[:, None]

    edges = polygons.edges() if len(polygons) <= MOST_MESH_LINES else np.zeros((0, 2), int)
    parts = quarter(quarter(triangles))
    corner_owner = polygons.owner()
    shapes = [*view.project(parts), *view.project(corners[edges]), *view.project(corners[outline])]
    of = np.concatenate([np.repeat(owner, PARTS), corner_owner[edges[:, 0]], corner_owner[outline[:, 0]]])
    ink = np.concatenate([colour, np.tile([0.2, 0.2, 0.2, 0.5], (len(edges), 1)), np.tile([0.1, 0.1, 0.1, 1], (len(outline), 1))])
    width = np.concatenate([np.full(len(parts), 0.3), np.full(len(edges), 0.25), np.full(len(outline), 0.9)])
    order = np.argsort(of, kind="stable")
    axes.add_collection(PolyCollection([shapes[i] for i in order], facecolors=ink[order],
                                       edgecolors=ink[order], linewidths=width[order]))


PARTS = 16  # pieces that a triangle is cut into, so that the bands follow the field inside an element


def flattened(values):
    """[triangles, 3] corner values -> [PARTS triangles] means of the pieces."""
    return quarter(quarter(values)).mean(axis=1)


def quarter(t):
    """[triangles, 3, ...] -> [4 triangles, 3, ...] through the middles of the edges."""
    a, b, c = t[:, 0], t[:, 1], t[:, 2]
    ab, bc, ca = (a + b) / 2, (b + c) / 2, (c + a) / 2
    parts = [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    return np.stack([np.stack(part, axis=1) for part in parts], axis=1).reshape((-1,) + t.shape[1:])


def mesh_lines(axes, polygons, corners, view, colour="0.25", width=0.25):
    if len(polygons) <= MOST_MESH_LINES:
        axes.add_collection(PolyCollection(np.split(view.project(corners), polygons.start[1:-1]), facecolors="none",
                                           edgecolors=colour, linewidths=width, alpha=0.5))


def lines(axes, segments, view, **style):
    """[segments, 2, 3] -> lines."""
    return axes.add_collection(LineCollection(view.project(np.asarray(segments)), capstyle="round", **style))


def colour_bar(figure, axes, levels, colours, label):
    scale = matplotlib.cm.ScalarMappable(BoundaryNorm(levels, colours.N), colours)
    bar = figure.colorbar(scale, cax=axes.inset_axes([1.03, 0.05, 0.025, 0.9]), ticks=levels)
    bar.ax.set_yticklabels([f"{round(t, 12):g}" for t in levels])
    bar.set_label(label)
    bar.outline.set_linewidth(0.5)


def frame(axes, points, view, margin=0.04):
    """Equal scales, the given points inside."""
    at = view.project(points)
    low, high = at.min(axis=0), at.max(axis=0)
    pad = margin * max(high - low)
    axes.set_xlim(low[0] - pad, high[0] + pad)
    axes.set_ylim(low[1] - pad, high[1] + pad)
    axes.set_aspect("equal", adjustable="box")
    if view.flat:
        axes.set_xlabel(f"{view.labels[0]} [m]")
        axes.set_ylabel(f"{view.labels[1]} [m]")
    else:
        axes.set_axis_off()


def figure_for(points, view):
    """A figure whose shape suits the points that it shows."""
    at = view.project(points)
    wide, high = np.maximum(np.ptp(at, axis=0), 1e-9)
    shape = min(max(high / wide, 0.3), 1.6)
    width = 9.0 if shape < 1 else 7.5
    figure, axes = plt.subplots(figsize=(width, 1.7 + 0.8 * width * shape), layout="constrained")
    return figure, axes


def title(axes, first, second):
    """A bold line over one or more small ones."""
    axes.set_title(first, loc="left", fontsize=12, fontweight="bold", pad=8 + 13 * len(second.splitlines()))
    axes.annotate(second, (0, 1), xycoords="axes fraction", xytext=(0, 5), textcoords="offset points", fontsize=9,
                  color="0.3", va="bottom", linespacing=1.35)


def extremes(axes, corners, values, original, view, unit):
    """Marks the largest and smallest value and says where they are, in the undeformed model."""
    at = view.project(corners)
    note = []
    for word, index, mark in (("max", int(np.argmax(values)), "^"), ("min", int(np.argmin(values)), "v")):
        axes.plot(*at[index], mark, color="black", markersize=6, markeredgecolor="white", zorder=10, clip_on=False)
        place = ", ".join(f"{round(c, 2) + 0.0:g}" for c in original[index])
        note.append(f"{mark_name(mark)} {word} {values[index]:.4g} {unit} at ({place}) m")
    return "     ".join(note)


def mark_name(mark):
    return {"^": "\u25b2", "v": "\u25bc"}[mark]


def save(figure, path):
    figure.savefig(path, dpi=150)
    plt.close(figure)
