#include "script/schema.hpp"

#include <set>

#include "script/deck_text.hpp"
#include "script/quantity.hpp"

namespace ashlar {
namespace {

TEST(Schema, EveryNounAndEveryKeySaysWhatItIs) {
  for (const auto& noun : nouns()) {
    EXPECT_FALSE(noun.doc.empty()) << noun.name;
    for (const auto& key : noun.keys) EXPECT_FALSE(key.doc.empty()) << noun.name << "." << key.name;
    for (const auto& law : laws_of(noun)) {
      EXPECT_FALSE(law.doc.empty()) << law.name;
      for (const auto& key : law.keys) EXPECT_FALSE(key.doc.empty()) << law.name << "." << key.name;
    }
  }
}

TEST(Schema, LawKeysDoNotHideNounKeys) {
  for (const auto& noun : nouns())
    for (const auto& law : laws_of(noun))
      for (const auto& law_key : law.keys)
        for (const auto& key : noun.keys) EXPECT_NE(key.name, law_key.name) << noun.name << ", law " << law.name;
}

TEST(Schema, EveryExampleIsADeckThatReads) {
  for (const auto& noun : nouns()) {
    const test::DeckFolder folder;
    std::filesystem::copy_file(ASHLAR_TEST_DATA "/dam_D0_r1_ny1.msh", folder.path() + "dam.msh");
    folder.write("abutment.stl",
                 "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
                 "0\nendloop\nendfacet\nendsolid\n");
    // Names that an example refers to.
    const std::string around = noun.name == "expect" ? R"(
      stage "gravity" { solve = static {} }
      history "crest" { at = {0, 0, 60}, record = "displacement" })"
                                                     : "";
    EXPECT_NO_THROW(read_deck(folder.write("deck.lua", around + "\n" + noun.example), {})) << noun.example;
  }
}

TEST(Schema, HelpShowsEveryKeyAndEveryLaw) {
  for (const auto& noun : nouns()) {
    const std::string page = help(noun.name);
    for (const auto& key : noun.keys)
      EXPECT_NE(page.find("  " + key.name + " "), std::string::npos) << noun.name << "." << key.name;
    for (const auto& law : laws_of(noun)) EXPECT_NE(page.find("law = \"" + law.name + "\""), std::string::npos);
    EXPECT_NE(help_index().find("  " + noun.name + " "), std::string::npos);
  }
  EXPECT_THROW(help("materiel"), DeckError);
}

TEST(Schema, HelpAnswersEveryWordThatADeckMayContain) {
  std::set<std::string> words = {"units",     "functions", "deck",   "args",    "read_table",    "in_time",   "in_stage",
                                 "interpolate", "pairs",   "strict", "require", "safety_factor", "converged", "values",
                                 "local",     "function",  "math",   "math.sin", "displacement.x", "deck.args",
                                 "W/(m*K)",   "J/m^2"};
  for (const auto& unit : units()) words.insert(unit.name);
  const auto add = [&](const KeyRule& key) {
    words.insert(key.name);
    words.insert(key.choices.begin(), key.choices.end());
  };
  for (const auto& noun : nouns()) {
    for (const auto& key : noun.keys) add(key);
    for (const auto& law : laws_of(noun)) {
      words.insert(law.name);
      for (const auto& key : law.keys) add(rule_of(key));
    }
  }
  for (const auto& word : words) EXPECT_NO_THROW(help(word)) << word;
  EXPECT_NE(help("bbar").find("that of the element's mean"), std::string::npos);
  EXPECT_NE(help("MPa").find("1e6 Pa"), std::string::npos);
  EXPECT_NE(help("MPa").find("tensile_strength"), std::string::npos);
  EXPECT_NE(help("surface").find("also a key of fix"), std::string::npos);
  const auto refusal = [](const char* word) {
    try {
      return help(word);
    } catch (const DeckError& error) {
      return std::string(error.what());
    }
  };
  EXPECT_NE(refusal("E").find("did you mean 'young'"), std::string::npos);
  EXPECT_NE(refusal("mpa").find("did you mean 'MPa'"), std::string::npos);
  EXPECT_NE(refusal("hydrating").find("heat_source"), std::string::npos);
}

}  // namespace
}  // namespace ashlar
