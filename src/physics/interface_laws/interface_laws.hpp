#pragma once
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "physics/interface_laws/brittle.hpp"
#include "physics/interface_laws/elastic.hpp"
#include "physics/interface_laws/frictional.hpp"
#include "physics/interface_laws/softening.hpp"

/// The register of interface laws. Adding one: its header, its name in this list, its test.
namespace ashlar {

using InterfaceLaws = std::tuple<ElasticInterface, BrittleInterface, FrictionalInterface, SofteningInterface>;

std::vector<LawDoc> interface_law_docs();

/// An interface as springs need it.
struct InterfaceConstants {
  SpringLaw<double> law;
  StiffnessKeys stiffness;
  double stiffness_ratio = 0;  ///< shear over normal stiffness where the law ties them; 0: it does not
};

/// Constants of the law called `law` with the deck's `values`. `what` names the declaration in messages: "joint
/// 'base'". Throws DeckError: no such law, inconsistent strengths.
InterfaceConstants interface_constants(const std::string& law, const std::map<std::string, double>& values,
                                       const Where& where, const std::string& what);

}  // namespace ashlar
