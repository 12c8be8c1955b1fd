#include "solve/coarse_balance.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <map>

#include "kernels/balance.hpp"
#include "kernels/block_force.hpp"
#include "kernels/element_types.hpp"

namespace ashlar {

namespace {

using Block = std::array<double, rigid_modes * rigid_modes>;  ///< between the movements of two aggregates
using Blocks = std::map<std::pair<int, int>, Block>;

/// Patches, in large models several that follow each other.
CoarseBalance patch_aggregates(const Discretisation& d) {
  const Topology& t = d.blocks;
  const int together = std::max(1, (d.patch_count() + most_aggregates - 1) / most_aggregates);
  const int count = (d.patch_count() + together - 1) / together;
  CoarseBalance a;
  a.aggregate.assign(t.node_count, -1);
  for (int p = 0; p < d.patch_count(); ++p)
    for (int e = t.patch_first_entry[p]; e < t.patch_first_entry[p + 1]; ++e)
      if (a.aggregate[t.entry_node[e]] < 0) a.aggregate[t.entry_node[e]] = p / together;
  std::vector<int> size(count + 1);
  for (const int p : a.aggregate) ++size[p + 1];
  for (int p = 0; p < count; ++p) size[p + 1] += size[p];
  a.first = size;
  a.member.resize(t.node_count);
  a.centre.assign(3 * static_cast<std::size_t>(count), 0);
  for (int n = 0; n < t.node_count; ++n) a.member[size[a.aggregate[n]]++] = n;
  for (int n = 0; n < t.node_count; ++n) {
    const int p = a.aggregate[n];
    for (int c = 0; c < 3; ++c) a.centre[3 * p + c] += d.block_points[n][c] / (a.first[p + 1] - a.first[p]);
  }
  return a;
}

/// Displacement of a node in mode k of its aggregate; zero in held components.
Vec3<double> mode_at(int k, const Vec3<double>& arm, unsigned held) {
  Vec3<double> u;
  if (k < 3) u[k] = 1;
  if (k == 3) u = {0, -arm.z, arm.y};
  if (k == 4) u = {arm.z, 0, -arm.x};
  if (k == 5) u = {-arm.y, arm.x, 0};
  for (int c = 0; c < 3; ++c)
    if ((held >> c) & 1u) u[c] = 0;
  return u;
}

/// Everything that the stiffness of one element or spring needs to know of its nodes.
class Assembly {
 public:
  Assembly(const Problem& problem, const CoarseBalance& aggregates, const std::vector<double>& fixed)
      : problem_(problem), aggregates_(aggregates), fixed_(fixed) {}

  void add_elements() {
    const Discretisation& d = problem_.discretisation;
    const Setup setup = problem_.setup();
    for (const Batch& batch : d.batches)
      std::visit(
          [&](const auto& law) {
            const auto point = law.template prepare<double>().elastic();
            with_element(batch.shape, setup.bbar[batch.material],
                         [&](auto element) { add_batch(element, batch, point); });
          },
          setup.laws[batch.material]);
  }

  void add_springs() {
    const ContactPoints& contacts = problem_.contacts;
    const std::vector<int>& renumber = problem_.discretisation.blocks.new_node;
    in_parts(contacts.count(), [&](int c, Blocks& blocks) {
      std::vector<int> nodes;
      std::vector<double> weights;
      contacts.each_end(c, [&](int node, double weight) {
        nodes.push_back(renumber[node]);
        weights.push_back(weight);
      });
      if (contacts.is_tip(c) || rigid(nodes)) return;
      const Vec3<double>& n = contacts.normal[c];
      for (std::size_t i = 0; i < nodes.size(); ++i)
        for (int k = 0; k < rigid_modes; ++k) {
          const Vec3<double> gap = weights[i] * mode(nodes[i], k);
          const double along = dot(gap, n);
          const Vec3<double> pull = contacts.area[c] * (contacts.shear_stiffness[c] * (gap - along * n) +
                                                        contacts.normal_stiffness[c] * along * n);
          for (std::size_t j = 0; j < nodes.size(); ++j)
            for (int l = 0; l < rigid_modes; ++l)
              blocks[{aggregates_.aggregate[nodes[i]], aggregates_.aggregate[nodes[j]]}][rigid_modes * k + l] +=
                  weights[j] * dot(mode(nodes[j], l), pull);
        }
    });
  }

  Eigen::MatrixXd matrix() const {
    const int size = rigid_modes * aggregates_.count();
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(size, size);
    for (const auto& [pair, block] : blocks_)
      for (int k = 0; k < rigid_modes; ++k)
        for (int l = 0; l < rigid_modes; ++l)
          all(rigid_modes * pair.first + k, rigid_modes * pair.second + l) = block[rigid_modes * k + l];
    return all;
  }

 private:
  Vec3<double> mode(int node, int k) const {
    const int a = aggregates_.aggregate[node];
    const Vec3<double> centre{aggregates_.centre[3 * a], aggregates_.centre[3 * a + 1], aggregates_.centre[3 * a + 2]};
    return mode_at(k, problem_.discretisation.block_points[node] - centre, static_cast<unsigned>(fixed_[node]));
  }
  /// All nodes in one aggregate and none of them held: a rigid movement strains nothing.
  bool rigid(std::span<const int> nodes) const {
    for (const int n : nodes)
      if (aggregates_.aggregate[n] != aggregates_.aggregate[nodes[0]] || fixed_[n] != 0) return false;
    return true;
  }
  /// Calls work(i, blocks) for i < count: parts side by side, each with blocks of its own, which are added in order, so
  /// that sums depend on no number of threads.
  template <class Work>
  void in_parts(int count, const Work& work) {
    constexpr int each = 8192;
    std::vector<Blocks> parts((static_cast<std::size_t>(count) + each - 1) / each);
#pragma omp parallel for schedule(dynamic) if (parts.size() > 1)
    for (std::size_t p = 0; p < parts.size(); ++p)
      for (int i = static_cast<int>(p) * each; i < std::min(count, static_cast<int>(p + 1) * each); ++i)
        work(i, parts[p]);
    for (const Blocks& part : parts)
      for (const auto& [pair, block] : part)
        for (std::size_t i = 0; i < block.size(); ++i) blocks_[pair][i] += block[i];
  }

  template <template <class> class Element, class Point>
  void add_batch(ElementTag<Element>, const Batch& batch, const Point& law) {
    constexpr int corners = Element<double>::corners;
    const Discretisation& d = problem_.discretisation;
    in_parts(batch.element_count, [&](int e, Blocks& blocks) {
      int nodes[corners];
      double x[3][corners], u[3][corners], f[3][corners];
      for (int k = 0; k < corners; ++k) {
        nodes[k] = d.blocks.corner_node[batch.first_slot + e * corners + k];
        for (int c = 0; c < 3; ++c) x[c][k] = d.block_points[nodes[k]][c];
      }
      if (rigid(nodes)) return;
      std::vector<int> touched;
      for (const int n : nodes) touched.push_back(aggregates_.aggregate[n]);
      std::sort(touched.begin(), touched.end());
      touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
      for (const int a : touched)
        for (int k = 0; k < rigid_modes; ++k) {
          for (int q = 0; q < corners; ++q) {
            const Vec3<double> m = aggregates_.aggregate[nodes[q]] == a ? mode(nodes[q], k) : Vec3<double>{};
            for (int c = 0; c < 3; ++c) u[c][q] = m[c];
          }
          element_force<Element, false>(law, x, u, NoPoints{}, f);
          for (const int b : touched) {
            Block& between = blocks[{a, b}];
            for (int l = 0; l < rigid_modes; ++l) {
              double value = 0;
              for (int q = 0; q < corners; ++q)
                if (aggregates_.aggregate[nodes[q]] == b)
                  value += dot(mode(nodes[q], l), Vec3<double>{f[0][q], f[1][q], f[2][q]});
              between[rigid_modes * k + l] += value;
            }
          }
        }
    });
  }

  const Problem& problem_;
  const CoarseBalance& aggregates_;
  const std::vector<double>& fixed_;
  Blocks blocks_;
};

}  // namespace

CoarseBalance coarse_balance(const Problem& problem, const std::vector<double>& fixed) {
  CoarseBalance coarse = patch_aggregates(problem.discretisation);
  Assembly assembly(problem, coarse, fixed);
  assembly.add_elements();
  assembly.add_springs();
  Eigen::MatrixXd matrix = assembly.matrix();
  // Movements that nothing resists (held throughout, or one node's rotation) get a stiffness of their own.
  matrix.diagonal().array() += 1e-9 * matrix.diagonal().maxCoeff();
  const Eigen::Index size = matrix.rows();
  const Eigen::MatrixXd inverse = matrix.ldlt().solve(Eigen::MatrixXd::Identity(size, size));
  coarse.compliance.resize(static_cast<std::size_t>(size * size));
  Eigen::MatrixXd::Map(coarse.compliance.data(), size, size) = 0.5 * (inverse + inverse.transpose());
  return coarse;
}

}  // namespace ashlar
