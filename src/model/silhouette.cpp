#include "model/silhouette.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ashlar {

namespace {
constexpr double far = std::numeric_limits<double>::infinity();
}

Silhouette::Silhouette(const Mesh& mesh, const std::vector<Facet>& facets, int side)
    : mesh_(mesh), axis_(side / 2), sign_(side % 2 ? 1 : -1), tolerance_(1e-6 * mesh.extent()) {
  for (const auto& facet : facets)
    if (const auto area = mesh.facet_area(facet); sign_ * area[axis_] > 1e-6 * norm(area)) facets_.push_back(facet);

  low_ = {far, far};
  Across high{-far, -far};
  const auto widen = [&](const Facet& facet, Across& low, Across& up) {
    for (const int n : mesh.facet_nodes(facet))
      for (int a = 0; a < 2; ++a) {
        low[a] = std::min(low[a], across(mesh.points[n])[a]);
        up[a] = std::max(up[a], across(mesh.points[n])[a]);
      }
  };
  for (const auto& facet : facets_) widen(facet, low_, high);
  cells_ = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(facets_.size()))));
  for (int a = 0; a < 2; ++a) step_[a] = facets_.empty() ? 1 : std::max((high[a] - low_[a]) / cells_, tolerance_);
  bins_.resize(static_cast<std::size_t>(cells_) * cells_);
  for (int f = 0; f < static_cast<int>(facets_.size()); ++f) {
    Across from{far, far}, to{-far, -far};
    widen(facets_[f], from, to);
    for (int i = cell(from, 0); i <= cell(to, 0); ++i)
      for (int j = cell(from, 1); j <= cell(to, 1); ++j) bins_[i * cells_ + j].push_back(f);
  }
}

int Silhouette::cell(const Across& at, int a) const {
  return static_cast<int>(std::clamp((at[a] - low_[a]) / step_[a], 0.0, cells_ - 1.0));
}

bool Silhouette::hides(const Vec3<double>& p) const {
  if (facets_.empty()) return false;
  const auto at = across(p);
  for (const int f : bins_[cell(at, 0) * cells_ + cell(at, 1)]) {
    const auto nodes = mesh_.facet_nodes(facets_[f]);
    for (std::size_t i = 1; i + 1 < nodes.size(); ++i)
      if (triangle_hides(nodes[0], nodes[i], nodes[i + 1], p)) return true;
  }
  return false;
}

bool Silhouette::triangle_hides(int a, int b, int c, const Vec3<double>& p) const {
  const auto &pa = mesh_.points[a], &pb = mesh_.points[b], &pc = mesh_.points[c];
  const auto twice_area = [&](const Vec3<double>& u, const Vec3<double>& v, const Vec3<double>& w) {
    const auto A = across(u), B = across(v), C = across(w);
    return (B[0] - A[0]) * (C[1] - A[1]) - (B[1] - A[1]) * (C[0] - A[0]);
  };
  const double all = twice_area(pa, pb, pc);
  if (std::abs(all) <= tolerance_ * tolerance_) return false;
  // Area coordinates of p as seen from the side; edges belong to both their triangles.
  const double wa = twice_area(pb, pc, p) / all, wb = twice_area(pc, pa, p) / all, wc = 1 - wa - wb;
  if (std::min({wa, wb, wc}) < -1e-9) return false;
  return sign_ * (wa * pa[axis_] + wb * pb[axis_] + wc * pc[axis_] - p[axis_]) > tolerance_;
}

}  // namespace ashlar
