#include "solve/crack_paths.hpp"

#include <algorithm>
#include <set>

#include "model/check_mesh.hpp"
#include "physics/principal.hpp"

namespace ashlar {

namespace {
constexpr int length_number = 11, slip_number = 12;  // in CrackPoint::History
}

/// Histories at an equilibrium, element by element.
struct CrackPaths::State {
  const CrackPaths& paths;
  std::vector<double> values;
  std::vector<char> cracked;  ///< [elements] part of a crack

  double& at(const Element& e, int number, int point) {
    return values[std::size_t(number) * paths.points_ + e.first + point * e.step];
  }
  double at(const Element& e, int number, int point) const { return const_cast<State*>(this)->at(e, number, point); }
  double damage(const Element& e) const {
    double most = 0;
    for (int g = 0; g < e.points; ++g) most = std::max(most, at(e, measure_number, g));
    return most;
  }
  Vec3<double> vector(const Element& e, int first, int point) const {
    return {at(e, first, point), at(e, first + 1, point), at(e, first + 2, point)};
  }
  /// Whether it cracked by sliding, at this equilibrium: what opens first bears no shear.
  bool slid(const Element& e) const {
    double most = 0;
    for (int g = 0; g < e.points; ++g) most = std::max(most, norm(vector(e, slip_number, g)));
    return most > e.least_slip;
  }
  bool held(const Element& e) const { return at(e, length_number, 0) < 0; }
  void hold(const Element& e, bool holds) {
    for (int g = 0; g < e.points; ++g) at(e, length_number, g) = holds ? CrackPoint<double>::held : 0;
  }
};

CrackPaths::CrackPaths(const Problem& problem) : problem_(problem) {
  const Mesh& mesh = problem.model.mesh;
  const Setup setup = problem.setup();
  const std::vector<int> first = setup.first_history();
  points_ = first.back();
  for (std::size_t b = 0; b < problem.discretisation.batches.size(); ++b) {
    const Batch& batch = problem.discretisation.batches[b];
    const auto* law = std::get_if<Breakage>(&setup.laws[batch.material]);
    if (!law || !(law->crack_spacing > 0)) continue;
    for (int i = 0; i < batch.element_count; ++i) {
      const int e = problem.discretisation.source_element[batch.first_element + i];
      elements_.push_back({e, first[b] + i, batch.element_count, gauss_count(batch.shape), law->crack_spacing,
                           element_volume(mesh, e), law->cohesion / law->shear() / 2, mesh.centroid(e)});
    }
  }
  if (elements_.empty()) return;
  first_.assign(mesh.points.size() + 1, 0);
  for (const Element& e : elements_)
    for (const int n : mesh.element(e.source)) ++first_[n + 1];
  for (std::size_t n = 1; n < first_.size(); ++n) first_[n] += first_[n - 1];
  around_.resize(first_.back());
  std::vector<int> next = first_;
  for (std::size_t i = 0; i < elements_.size(); ++i)
    for (const int n : mesh.element(elements_[i].source)) around_[next[n]++] = static_cast<int>(i);
}

/// Those that share a node with one, and itself.
std::vector<int> CrackPaths::around(int element) const {
  std::vector<int> found;
  for (const int n : problem_.model.mesh.element(elements_[element].source))
    found.insert(found.end(), around_.begin() + first_[n], around_.begin() + first_[n + 1]);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

/// Whether the mean plane of the cracked elements nearby (up to the second neighbours, by damaged volume) leads through
/// an element.
bool CrackPaths::lies_ahead(int element, const State& state) const {
  std::set<int> near;
  for (const int i : around(element))
    for (const int j : around(i))
      if (state.cracked[j]) near.insert(j);
  if (near.empty()) return false;
  Vec3<double> centre{};
  Sym3<double> normals{};
  double weight = 0;
  for (const int i : near) {
    const Element& e = elements_[i];
    for (int g = 0; g < e.points; ++g) {
      const Vec3<double> n = state.vector(e, normal_number, g);
      const double share = e.volume / e.points * state.at(e, measure_number, g);
      const double products[6] = {n.x * n.x, n.y * n.y, n.z * n.z, n.x * n.y, n.y * n.z, n.z * n.x};
      for (int c = 0; c < 6; ++c) normals[c] += share * products[c];
      centre = centre + share * e.centre;
      weight += share;
    }
  }
  centre = (1 / weight) * centre;
  const Vec3<double> normal = principal(normals).direction[0];
  double low = 0, high = 0;
  bool any = false;
  for (const int n : problem_.model.mesh.element(elements_[element].source)) {
    const double height = dot(problem_.model.mesh.points[n] - centre, normal);
    low = any ? std::min(low, height) : height;
    high = any ? std::max(high, height) : height;
    any = true;
  }
  const double rounding = 1e-9 * (high - low);
  return low < rounding && high > -rounding;
}

bool CrackPaths::far_from_cracks(int element, const State& state) const {
  for (std::size_t i = 0; i < elements_.size(); ++i)
    if (state.cracked[i] && norm(elements_[i].centre - elements_[element].centre) < elements_[element].spacing)
      return false;
  return true;
}

bool CrackPaths::advance() {
  Backend& backend = *problem_.backend;
  const int count = static_cast<int>(elements_.size());
  State before{*this, backend.read(Field::history), std::vector<char>(count)};
  backend.run(Phase::advance_history);
  State state{*this, backend.read(Field::history), std::vector<char>(count)};

  std::vector<int> fresh;
  for (int i = 0; i < count; ++i) {
    state.cracked[i] = before.damage(elements_[i]) > 0;
    if (!state.cracked[i] && state.damage(elements_[i]) > 0) fresh.push_back(i);
  }
  const bool cracks = !fresh.empty();
  std::stable_sort(fresh.begin(), fresh.end(),
                   [&](int a, int b) { return state.damage(elements_[a]) > state.damage(elements_[b]); });
  // The most damaged begins a crack; others belong to it if it leads into them. What slides nothing holds.
  std::vector<int> joined;
  for (bool more = true; more;) {
    more = false;
    for (const int i : fresh) {
      if (state.cracked[i]) continue;
      if (!state.slid(elements_[i]) && !far_from_cracks(i, state) && !lies_ahead(i, state)) continue;
      state.cracked[i] = more = true;
      joined.push_back(i);
    }
  }
  for (const int i : fresh)
    if (!state.cracked[i])
      for (std::size_t number = 0; number < state.values.size() / points_; ++number)
        for (int g = 0; g < elements_[i].points; ++g)
          state.at(elements_[i], static_cast<int>(number), g) = before.at(elements_[i], static_cast<int>(number), g);

  std::vector<char> beside(count);
  for (int i = 0; i < count; ++i)
    if (state.cracked[i])
      for (const int j : around(i))
        for (const int k : around(j)) beside[k] = true;
  bool changed = cracks;
  for (int i = 0; i < count; ++i) {
    const Element& e = elements_[i];
    if (state.cracked[i]) continue;
    bool holds = beside[i] ? !lies_ahead(i, state) : state.held(e);
    for (std::size_t k = 0; k < joined.size() && !beside[i] && !holds; ++k)
      holds = norm(elements_[joined[k]].centre - e.centre) < e.spacing;
    if (holds == state.held(e)) continue;
    state.hold(e, holds);
    changed = true;
  }
  if (changed) backend.write(Field::history, state.values);
  return cracks;
}

}  // namespace ashlar
