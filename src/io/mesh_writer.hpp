#pragma once
#include <string>
#include <vector>

#include "model/blocks.hpp"
#include "model/model.hpp"

/// Meshes and models for other programs. Nodes and elements keep their order and are numbered from 1; coordinates are
/// written so that they read back as the same numbers. Regions and surfaces become groups of the same names.
namespace ashlar {

/// Gmsh 4.1, text: regions are physical volumes, surfaces physical surfaces of triangles and quads.
std::string gmsh_text(const Mesh& mesh);

/// VTK unstructured grid (.vtu), text. Facets of surfaces follow the elements as triangles and quads, once for every
/// surface that they are in. The cell array `region` numbers regions from 1 and, behind them, surfaces; the field
/// arrays region_names and surface_names name them in that order.
std::string vtu_text(const Mesh& mesh);

/// Interfaces before anything is solved, VTK unstructured grid (.vtu), text: a polygon for every pair of faces that lie
/// on each other, for every overlap, and for every face that a joint leaves free, wholly or in part. Cell arrays:
/// interface (a number into the field array interface_names), match (0: corner on corner, 1: overlap, 2: partly free,
/// 3: free, beyond the tolerance), area [m^2] (of free faces: the free part), gap [m], block_a, block_b (-1: none).
std::string interfaces_vtu_text(const Model& model, const Blocks& blocks);

/// Forces and supports on mesh nodes, for one *STEP.
struct NodalStep {
  std::string name;
  std::vector<double> force;         ///< [3 * nodes] N
  std::vector<unsigned> held;        ///< [nodes] bits 0 1 2: displacement along x y z is given
  std::vector<double> displacement;  ///< [3 * nodes] m, where held
};

/// CalculiX and Abaqus input (.inp): the mesh; materials and sections of the model where it has them, elastic; a
/// *STATIC step for each of `steps`, whose loads are nodal forces, all of them in every step. `remarks` go on top as
/// comments. Names lose what Abaqus does not take in them. Throws DeckError where two of them become one.
std::string abaqus_text(const Model& model, const std::vector<NodalStep>& steps,
                        const std::vector<std::string>& remarks);

}  // namespace ashlar
