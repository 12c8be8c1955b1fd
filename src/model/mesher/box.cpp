#include <cmath>

#include "model/mesher/lattice.hpp"

namespace ashlar {

void check_cell_count(const Where& where, const std::string& what, int nx, int ny, int nz) {
  constexpr double most = 4e7;  // six tetrahedra of each still have corner numbers below 2^31
  const double cells = static_cast<double>(nx) * ny * nz;
  if (cells > most)
    throw DeckError(where, what + " would have " + std::to_string(nx) + " x " + std::to_string(ny) + " x " +
                               std::to_string(nz) + " cells, more than 40 million; make the elements larger");
}

namespace {

/// Whether every cell is left-handed at its first corner.
bool inside_out(const Lattice& lattice) {
  for (int k = 0; k < lattice.nz; ++k)
    for (int j = 0; j < lattice.ny; ++j)
      for (int i = 0; i < lattice.nx; ++i) {
        const auto corner = [&](int c) { return lattice.points[lattice.cell(i, j, k)[c]]; };
        const Vec3<double> a = corner(1) - corner(0), b = corner(3) - corner(0), c = corner(4) - corner(0);
        if (!(dot(a, cross(b, c)) < 0)) return false;
      }
  return true;
}

}  // namespace

Lattice mesh_box(const Box& box) {
  constexpr const char* axis_names[] = {"x", "y", "z"};
  Complaints complaints;
  for (int a = 0; a < 3; ++a) {
    const std::string axis = axis_names[a];
    if (!std::isfinite(box.from[a]) || !std::isfinite(box.to[a]))
      complaints.add(box.where, "box '" + box.name + "': 'from' and 'to' must be finite; " + axis + " is not");
    else if (box.to[a] <= box.from[a])
      complaints.add(box.where, "box '" + box.name + "': 'to' must lie beyond 'from' along " + axis);
    if (box.cells[a] < 1)
      complaints.add(box.where, "box '" + box.name + "': needs at least one cell along " + axis + ", got " +
                                    std::to_string(box.cells[a]));
  }
  complaints.raise();
  check_cell_count(box.where, "box '" + box.name + "'", box.cells[0], box.cells[1], box.cells[2]);

  Lattice lattice{box.cells[0], box.cells[1], box.cells[2], {}, box.shape, false};
  const auto coordinate = [&](int axis, int i) {
    const double t = static_cast<double>(i) / box.cells[axis];
    return i == box.cells[axis] ? box.to[axis] : box.from[axis] + t * (box.to[axis] - box.from[axis]);
  };
  for (int k = 0; k <= lattice.nz; ++k)
    for (int j = 0; j <= lattice.ny; ++j)
      for (int i = 0; i <= lattice.nx; ++i)
        lattice.points.push_back({coordinate(0, i), coordinate(1, j), coordinate(2, k)});
  for (auto& point : lattice.points) {
    const Vec3<double> straight = point;
    for (int a = 0; a < 3; ++a)
      if (box.bent[a]) point[a] = (*box.bent[a])(straight);
  }
  if (inside_out(lattice))
    throw DeckError(box.where, "box '" + box.name + "': its functions x, y, z turn it inside out, as a mirror does; " +
                                   "let one of them run the other way");
  return lattice;
}

}  // namespace ashlar
