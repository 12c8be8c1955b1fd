"""Polygons to draw: outer faces seen from a direction, plane sections, outlines, interface traces."""
import dataclasses
import heapq

import numpy as np

# Faces by VTK cell type, right-hand normals pointing out of the element (src/model/mesh.hpp).
FACES = {
    12: [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)],
    13: [(0, 2, 1), (3, 4, 5), (0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)],
    10: [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)],
}
EDGES = {kind: sorted({tuple(sorted((f[i], f[i - 1]))) for f in faces for i in range(len(f))})
         for kind, faces in FACES.items()}
CORNERS = {12: 8, 13: 6, 10: 4}
MOST_ORDERED = 20000  # polygons that are ordered pair by pair; more are small ones, ordered by their centres
VISIBLE = 0.005  # of the model's size: a gap that is drawn


@dataclasses.dataclass
class View:
    """Orthographic view: unit vectors to the right, upwards, and away from the eye."""
    right: np.ndarray
    up: np.ndarray
    away: np.ndarray
    labels: tuple

    def project(self, points):
        return np.stack([points @ self.right, points @ self.up], axis=-1)

    @property
    def flat(self):
        """True where the view shows two coordinates of the model in true length."""
        return all(self.labels)


def view_along(name):
    """View by name: "y" looks along +y (x to the right, z up), "x" along -x, "z" from above, "iso" obliquely."""
    x, y, z = np.eye(3)
    if name == "x":
        return View(y, z, -x, ("y", "z"))
    if name == "z":
        return View(x, y, -z, ("x", "y"))
    if name == "iso":
        away = np.array([0.55, 0.70, -0.45])
        away /= np.linalg.norm(away)
        right = np.cross(away, z)
        right /= np.linalg.norm(right)
        return View(right, np.cross(right, away), away, ("", ""))
    return View(x, z, y, ("x", "z"))


@dataclasses.dataclass
class Polygons:
    """Polygons whose corners lie on lines between two nodes: value = (1 - weight) f[first] + weight f[second]."""
    first: np.ndarray   # [corners] node
    second: np.ndarray  # [corners] node
    weight: np.ndarray  # [corners]
    start: np.ndarray   # [polygons + 1] offsets into the corners
    cell: np.ndarray    # [polygons] element that each belongs to

    def __len__(self):
        return len(self.cell)

    def at_corners(self, nodal):
        """Values of a nodal field, one row per corner."""
        w = self.weight.reshape((-1,) + (1,) * (nodal.ndim - 1))
        return (1 - w) * nodal[self.first] + w * nodal[self.second]

    def chosen(self, keep):
        """The polygons for which `keep` holds, in order."""
        index = np.flatnonzero(keep)
        counts = np.diff(self.start)[index]
        corners = np.concatenate([np.arange(self.start[i], self.start[i + 1]) for i in index]) if len(index) else []
        corners = np.asarray(corners, int)
        return Polygons(self.first[corners], self.second[corners], self.weight[corners],
                        np.concatenate([[0], np.cumsum(counts)]), self.cell[index])

    def owner(self):
        """[corners] number of the polygon that each corner belongs to."""
        return np.repeat(np.arange(len(self)), np.diff(self.start))

    def mean(self, corner_values):
        """[polygons] mean over the corners of each."""
        total = np.add.reduceat(corner_values, self.start[:-1], axis=0)
        return total / np.diff(self.start).reshape((-1,) + (1,) * (corner_values.ndim - 1))

    def edges(self):
        """[edges, 2] corner numbers, each polygon's edges in turn (edge i starts at corner i)."""
        following = np.arange(len(self.first)) + 1
        following[self.start[1:] - 1] = self.start[:-1]
        return np.stack([np.arange(len(self.first)), following], axis=1)


def merged_nodes(points):
    """[nodes] number shared by all nodes at one place (to a millionth of the model's size)."""
    grain = 1.0137e-6 * max(np.ptp(points, axis=0).max(), 1e-300)  # no round number: no coordinate lies between two grains
    return np.unique(np.round(points / grain).astype(np.int64), axis=0, return_inverse=True)[1]


def element_corners(mesh, kind):
    """(element numbers, [elements, corners] nodes) of one VTK cell type."""
    elements = np.flatnonzero(mesh.types == kind)
    return elements, mesh.connectivity[mesh.offsets[elements][:, None] + np.arange(CORNERS[kind])]


def parted(place, points):
    """`place` with numbers of their own for nodes of one place that lie visibly apart at `points`."""
    low, high = np.full((place.max() + 1, 3), np.inf), np.full((place.max() + 1, 3), -np.inf)
    np.minimum.at(low, place, points)
    np.maximum.at(high, place, points)
    apart = ((high - low).max(axis=1) > VISIBLE * np.ptp(points, axis=0).max())[place]
    return np.where(apart, place.max() + 1 + np.arange(len(place)), place)


def outer_faces(mesh, elements, points):
    """Faces that exactly one of the chosen elements (a mask) has. Nodes of split blocks count as one place unless they
    lie apart at `points`, where the mesh is drawn."""
    place = parted(merged_nodes(mesh.points), points)
    rows, cells = [], []
    for kind, faces in FACES.items():
        numbers, corners = element_corners(mesh, kind)
        numbers, corners = numbers[elements[numbers]], corners[elements[numbers]]
        for face in faces:
            row = np.full((len(numbers), 4), -1)
            row[:, :len(face)] = corners[:, list(face)]
            rows.append(row)
            cells.append(numbers)
    rows, cells = np.concatenate(rows), np.concatenate(cells)
    key = np.sort(np.where(rows >= 0, place[rows], -1), axis=1)
    _, inverse, count = np.unique(key, axis=0, return_inverse=True, return_counts=True)
    outer = count[inverse] == 1
    rows, cells = rows[outer], cells[outer]
    order = np.argsort(cells, kind="stable")
    rows, cells = rows[order], cells[order]
    nodes = rows[rows >= 0]
    sizes = (rows >= 0).sum(axis=1)
    return Polygons(nodes, nodes, np.zeros(len(nodes)), np.concatenate([[0], np.cumsum(sizes)]), cells)


def normals(polygons, points):
    """[polygons, 3] unit right-hand normals (Newell)."""
    p = polygons.at_corners(points)
    edges = polygons.edges()
    n = np.add.reduceat(np.cross(p[edges[:, 0]], p[edges[:, 1]]), polygons.start[:-1], axis=0)
    return n / np.maximum(np.linalg.norm(n, axis=1), 1e-300)[:, None]


def facing(polygons, points, view):
    """The polygons that turn their outside to the eye, those that lie behind others first."""
    seen = polygons.chosen(normals(polygons, points) @ view.away < -0.05)
    at = seen.at_corners(points)
    order = behind_first(seen.start, view.project(at), at @ view.away) if len(seen) else []
    corners = np.concatenate([np.arange(seen.start[i], seen.start[i + 1]) for i in order]) if len(order) else []
    corners = np.asarray(corners, int)
    return Polygons(seen.first[corners], seen.second[corners], seen.weight[corners],
                    np.concatenate([[0], np.cumsum(np.diff(seen.start)[order])]), seen.cell[order])


def behind_first(start, screen, depth):
    """Numbers of convex polygons, each after all that it hides. `screen` [corners, 2], `depth` [corners] grows away from the
    eye. Where some hide each other in a ring the one whose centre is farthest comes first."""
    count = np.diff(start)
    if len(count) > MOST_ORDERED:
        return np.argsort(-np.add.reduceat(depth, start[:-1]) / count, kind="stable")
    corner = start[:-1, None] + np.minimum(np.arange(count.max()), count[:, None] - 1)  # the last one again and again
    shape, deep = screen[corner], depth[corner]
    low, high = shape.min(axis=1), shape.max(axis=1)
    grain = 1e-6 * max(np.ptp(screen, axis=0).max(), 1e-300)
    hidden, hides = [], []
    by_left = np.argsort(low[:, 0], kind="stable")
    ends = np.searchsorted(low[by_left, 0], high[:, 0] - grain)
    for place, i in enumerate(by_left):
        others = by_left[place + 1:ends[i]]
        others = others[(low[others, 1] < high[i, 1] - grain) & (high[others, 1] > low[i, 1] + grain)]
        if len(others) == 0:
            continue
        nearer = who_is_nearer(shape[i], deep[i], shape[others], deep[others], grain)
        for other in others[nearer > 0]:
            hidden.append(i)
            hides.append(other)
        for other in others[nearer < 0]:
            hidden.append(other)
            hides.append(i)
    return sorted_by_cover(deep.mean(axis=1), np.asarray(hidden, int), np.asarray(hides, int))


def who_is_nearer(shape, deep, others, deep_others, grain):
    """[others] 1: the other one hides the polygon where both lie on the screen, -1: it is hidden, 0: they do not meet."""
    count, n = others.shape[:2]
    mine = np.broadcast_to(shape, others.shape)
    along, along_others = np.roll(mine, -1, axis=1) - mine, np.roll(others, -1, axis=1) - others
    way = others[:, None] - mine[:, :, None]
    turn = cross2(along[:, :, None], along_others[:, None])
    turn = np.where(np.abs(turn) > grain * grain, turn, np.inf)
    first, second = cross2(way, along_others[:, None]) / turn, cross2(way, along[:, :, None]) / turn
    crosses = (first > 1e-6) & (first < 1 - 1e-6) & (second > 1e-6) & (second < 1 - 1e-6)
    crossing = mine[:, :, None] + first[..., None] * along[:, :, None]
    # The mean of all places that both polygons share at their rims lies inside both.
    places = np.concatenate([mine, others, crossing.reshape(count, n * n, 2)], axis=1)
    use = np.concatenate([inside(mine, others, along_others, grain), inside(others, mine, along, grain),
                          crosses.reshape(count, n * n)], axis=1)
    middle = (use[..., None] * places).sum(axis=1) / np.maximum(use.sum(axis=1), 1)[:, None]
    behind = plane_depth(shape[None], deep[None], middle) - plane_depth(others, deep_others, middle)
    return np.where(use.any(axis=1) & (np.abs(behind) > 10 * grain), np.sign(behind), 0)


def inside(corners, polygons, along, grain):
    """[polygons, corners] which corners lie inside the convex polygon of the same row, whose edges are `along`."""
    side = cross2(along[:, None], corners[:, :, None] - polygons[:, None])
    margin = grain * np.linalg.norm(along, axis=-1)[:, None]
    none = margin < grain * grain  # an edge without length
    return ((side > margin) | none).all(axis=2) | ((side < -margin) | none).all(axis=2)


def cross2(a, b):
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]


def plane_depth(shape, deep, at):
    """Depth of polygons at places of the screen, by the plane through their corners (least squares)."""
    middle, level = shape.mean(axis=1), deep.mean(axis=1)
    x = shape - middle[:, None]
    products = np.einsum("pki,pkj->pij", x, x)
    slope = np.einsum("pij,pj->pi", np.linalg.pinv(products), np.einsum("pki,pk->pi", x, deep - level[:, None]))
    return level + np.einsum("pi,pi->p", np.broadcast_to(slope, at.shape), at - middle)


def sorted_by_cover(depth, hidden, hides):
    """Every number of `hidden` before the number of `hides` beside it, else far ones first."""
    follow = [[] for _ in depth]
    waits = np.zeros(len(depth), int)
    for back, front in zip(hidden, hides):
        follow[back].append(front)
        waits[front] += 1
    ready = [(-depth[i], i) for i in np.flatnonzero(waits == 0)]
    heapq.heapify(ready)
    far = iter(np.argsort(-depth, kind="stable"))
    order, done = [], np.zeros(len(depth), bool)
    while len(order) < len(depth):
        i = heapq.heappop(ready)[1] if ready else next(k for k in far if not done[k])
        if done[i]:
            continue
        done[i] = True
        order.append(i)
        for k in follow[i]:
            waits[k] -= 1
            if waits[k] == 0 and not done[k]:
                heapq.heappush(ready, (-depth[k], k))
    return np.asarray(order, int)


def section(mesh, elements, axis, position):
    """Cut of the chosen elements (a mask) by the plane `axis` (0, 1, 2) = position."""
    grain = 1e-6 * np.ptp(mesh.points, axis=0).max()
    distance = mesh.points[:, axis] - position
    distance = np.where(np.abs(distance) < grain, grain, distance)  # a plane through nodes is moved beside them
    first, second, sizes, cells = [], [], [], []
    for kind, edges in EDGES.items():
        numbers, corners = element_corners(mesh, kind)
        numbers, corners = numbers[elements[numbers]], corners[elements[numbers]]
        pattern = ((distance[corners] > 0) << np.arange(CORNERS[kind])).sum(axis=1)
        for bits in np.unique(pattern):
            cut = [(a, b) for a, b in edges if (bits >> a & 1) != (bits >> b & 1)]
            if len(cut) < 3:
                continue
            chosen = pattern == bits
            nodes = corners[chosen]
            cut = np.array(cut)[order_around(mesh.points, distance, nodes[0], np.array(cut), axis)]
            first.append(nodes[:, cut[:, 0]].ravel())
            second.append(nodes[:, cut[:, 1]].ravel())
            sizes.append(np.full(chosen.sum(), len(cut)))
            cells.append(numbers[chosen])
    if not first:
        low, high = mesh.points[:, axis].min(), mesh.points[:, axis].max()
        raise ValueError(f"the section {'xyz'[axis]} = {position:g} m misses the model ({low:g} to {high:g} m)")
    first, second, sizes = np.concatenate(first), np.concatenate(second), np.concatenate(sizes)
    weight = distance[first] / (distance[first] - distance[second])
    return Polygons(first, second, weight, np.concatenate([[0], np.cumsum(sizes)]), np.concatenate(cells))


def order_around(points, distance, nodes, cut, axis):
    """Order of the cut edges of one element around the polygon that they span."""
    a, b = nodes[cut[:, 0]], nodes[cut[:, 1]]
    w = (distance[a] / (distance[a] - distance[b]))[:, None]
    p = np.delete((1 - w) * points[a] + w * points[b], axis, axis=1)
    p = p - p.mean(axis=0)
    return np.argsort(np.arctan2(p[:, 1], p[:, 0]))


def outline(polygons, points, regions):
    """[edges, 2] corner numbers of the edges that bound the drawn polygons or separate two regions, or a sharp corner."""
    place = merged_nodes(polygons.at_corners(points))
    edges = polygons.edges()
    key = np.sort(place[edges], axis=1)
    owner = polygons.owner()
    order = np.lexsort((key[:, 1], key[:, 0]))
    key, edges, owner = key[order], edges[order], owner[order]
    same = np.all(key[1:] == key[:-1], axis=1)
    n = normals(polygons, points)
    bend = np.abs(np.einsum("ij,ij->i", n[owner[1:]], n[owner[:-1]])) < 0.85
    border = (regions[polygons.cell[owner[1:]]] != regions[polygons.cell[owner[:-1]]]) | bend
    inner = same & ~border
    drop = np.concatenate([[False], inner]) | np.concatenate([inner, [False]])
    return edges[~drop]


def traces(polygons, corners, faces, plane=None):
    """Half edges of the drawn polygons that lie on interface faces: ([halves, 2] corner numbers, state, opening).

    A half runs from its first corner halfway to its second, and has the state of the contact point at its first.
    `plane` is (axis, position) where a section is drawn, else the edges of the faces themselves are looked for.
    """
    halves = np.concatenate([polygons.edges(), polygons.edges()[:, ::-1]])
    ends, state, opening = segments(faces) if plane is None else cut_segments(faces, *plane)
    ends, state, opening = (np.concatenate([v, v[:, ::-1]]) for v in (ends, state, opening))
    if not len(ends):
        return halves[:0], state[:, 0], opening[:, 0]
    share = np.array([0.75, 0.25])
    drawn = np.einsum("e,ned->nd", share, corners[halves])
    key = merged_nodes(np.concatenate([drawn, np.einsum("e,ned->nd", share, ends)]))
    # Where a half edge lies on several faces the one that is broken and open widest is shown.
    order = np.lexsort((opening[:, 0], state[:, 0] > 0))
    on = np.full(key.max() + 1, -1)
    on[key[len(halves):][order]] = order
    found = on[key[:len(halves)]]
    return halves[found >= 0], state[found[found >= 0], 0], opening[found[found >= 0]] @ share


def segments(faces):
    """Edges of the faces: ([edges, 2, 3] ends, [edges, 2] state, [edges, 2] opening)."""
    edges = faces.first[faces.edges()]
    return faces.points[edges], faces.state[edges], faces.opening[edges]


def cut_segments(faces, axis, position):
    """The same for the segments in which the faces meet the plane `axis` = position; each is given once."""
    grain = 1e-6 * np.ptp(faces.points, axis=0).max()
    distance = faces.points[:, axis] - position
    distance = np.where(np.abs(distance) < grain, grain, distance)[faces.first]
    edges, owner = faces.edges(), faces.owner()
    crossing = np.flatnonzero((distance[edges[:, 0]] > 0) != (distance[edges[:, 1]] > 0))
    crossing = crossing[:len(crossing) // 2 * 2]
    a, b = edges[crossing].T
    w = distance[a] / (distance[a] - distance[b])
    a, b = faces.first[a], faces.first[b]
    ends = (1 - w)[:, None] * faces.points[a] + w[:, None] * faces.points[b]
    opening = (1 - w) * faces.opening[a] + w * faces.opening[b]
    state = np.maximum(faces.state[a], faces.state[b])
    pairs = owner[crossing].reshape(-1, 2)
    assert np.all(pairs[:, 0] == pairs[:, 1]), "a convex face meets a plane in one segment"
    return ends.reshape(-1, 2, 3), state.reshape(-1, 2), opening.reshape(-1, 2)


def sample(triangles, values, points):
    """Values at points of the plane, linear in the first triangle that holds each; NaN outside.

    `triangles` [triangles, 3, 2], `values` [triangles, 3], `points` [points, 2].
    """
    a, b, c = triangles[:, 0], triangles[:, 1], triangles[:, 2]
    u, v = b - a, c - a
    twice_area = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
    sound = twice_area != 0
    a, u, v, twice_area, values = a[sound], u[sound], v[sound], twice_area[sound], values[sound]
    found = np.full(len(points), np.nan)
    for i, point in enumerate(points):
        d = point - a
        second = (d[:, 0] * v[:, 1] - d[:, 1] * v[:, 0]) / twice_area
        third = (u[:, 0] * d[:, 1] - u[:, 1] * d[:, 0]) / twice_area
        inside = np.flatnonzero((second > -1e-9) & (third > -1e-9) & (second + third < 1 + 1e-9))
        if len(inside):
            t = inside[0]
            found[i] = values[t] @ [1 - second[t] - third[t], second[t], third[t]]
    return found
