#include "script/deck.hpp"

#include "script/deck_text.hpp"

namespace ashlar {
namespace {

using test::complaint;
using test::DeckFolder;
using test::read_text;

TEST(Deck, ANameThatHidesAUnitOrANounIsNoted) {
  const auto notes = [](const std::string& text) {
    std::string all;
    for (const auto& note : read_text("model \"a\" {}\n" + text).model.notes) all += note.substr(note.rfind('/') + 1) + "\n";
    return all;
  };
  EXPECT_EQ(notes("local s = 3\nlocal depth = 3*m"),
            "deck.lua:2: the name 's' hides the unit s (second): 3*s has no unit where it is seen; choose another name\n");
  EXPECT_EQ(notes("\nlocal function fix() end"),
            "deck.lua:3: the name 'fix' hides the noun fix: fix { ... } does not work where it is seen; choose another "
            "name\n");
  EXPECT_NE(notes("local function f(m) return 3*m end"), "");
  // Time in its own functions, and short-lived names that are no factor.
  EXPECT_EQ(notes("local f = in_time(function(t) return 1 + 2*t end)\nlocal function g(result) local s = result end"), "");
}

TEST(Deck, NumbersReachTheModelInSI) {
  const Deck deck = read_text(R"(
    model "m" { reference_temperature = 10*degC }
    box "b" { from = {0, 0, 0}, to = {100*cm, 2, 3*m}, size = 0.5*m, elements = "tet4" }
    material "c" { region = "b", density = 2.4*t/m^3, young = 30*GPa, poisson = 0.2, conductivity = 2.6*W/(m*K) }
    water_pressure { surface = "s", level = 55 }
    convection { surface = "s", ambient = 28.2*degC, film = 15*W/(m^2*K), above = 3*m })");
  const Model& m = deck.model;
  EXPECT_EQ(m.name, "m");
  EXPECT_EQ(m.where.line, 2);
  EXPECT_EQ(m.reference_temperature, 10);
  EXPECT_EQ(m.boxes[0].cells, (std::array{2, 4, 6}));
  EXPECT_EQ(m.boxes[0].shape, Shape::tet4);
  EXPECT_DOUBLE_EQ(m.materials[0].density, 2400);
  EXPECT_EQ(m.materials[0].values.at("young"), 30e9);
  EXPECT_EQ(m.materials[0].values.at("expansion"), 0);
  EXPECT_EQ(m.materials[0].conductivity, 2.6);
  EXPECT_FALSE(m.materials[0].heat_capacity);
  EXPECT_EQ(std::get<WaterPressure>(m.conditions[0].kind).level, 55);
  EXPECT_EQ(std::get<WaterPressure>(m.conditions[0].kind).density, 1000);
  const auto& air = std::get<Convection>(m.conditions[1].kind);
  EXPECT_EQ(air.ambient({}), 28.2);
  EXPECT_EQ(air.above, 3);
  EXPECT_FALSE(air.below);
}

TEST(Deck, ConditionsActEverywhereUnlessAStageAppliesThem) {
  const Deck deck = read_text(R"(
    fix "base" { surface = "s", x = 0, z = 0 }
    local function climate(t) return { fixed_temperature { surface = "s", value = t }, { flux { surface = "s", value = 3 } } } end
    stage "summer" { apply = { climate(30*degC), gravity { z = -9.81 } }, solve = thermal { steady = true } }
    stage "winter" { apply = climate(-3*degC), remove = "base", solve = static { tolerance = 1e-8, damping = "local" }, reset_displacement = true })");
  const Model& m = deck.model;
  ASSERT_EQ(m.conditions.size(), 6u);
  EXPECT_TRUE(m.conditions[0].everywhere);
  const auto fix = std::get<Fix>(m.conditions[0].kind);
  EXPECT_TRUE(fix.x && !fix.y && fix.z && !fix.normal);
  for (int i = 1; i < 6; ++i) EXPECT_FALSE(m.conditions[i].everywhere);
  EXPECT_EQ(m.stages[0].apply, (std::vector{1, 2, 3}));
  EXPECT_EQ(m.stages[1].apply, (std::vector{4, 5}));
  EXPECT_EQ(m.stages[1].remove, std::vector<std::string>{"base"});
  EXPECT_TRUE(m.stages[1].reset_displacement);
  EXPECT_TRUE(std::get<ThermalSolve>(m.stages[0].solve).steady);
  EXPECT_EQ(std::get<StaticSolve>(m.stages[1].solve).relaxation.tolerance, 1e-8);
  EXPECT_EQ(std::get<StaticSolve>(m.stages[1].solve).relaxation.damping, Damping::local);
}

TEST(Deck, FunctionsOfPositionOutliveTheReading) {
  const Deck deck = read_text(
      "local top = 60*m\nfixed_temperature { surface = 's', value = function(x, y, z) return 10 + 5 * (z*m / top) end "
      "}");
  EXPECT_DOUBLE_EQ(std::get<FixedTemperature>(deck.model.conditions[0].kind).value({1, 2, 30}), 12.5);
}

TEST(Deck, AFunctionThatGivesNoNumberNamesThePoint) {
  const auto message = [](const std::string& body) {
    const Deck deck = read_text("flux { surface = 's',\n value = function(x, y, z) " + body + " end }");
    try {
      std::get<Flux>(deck.model.conditions[0].kind).value({1, 2, 3});
    } catch (const DeckError& error) {
      const std::string text = error.what();
      return text.substr(text.find("deck.lua"));
    }
    return std::string();
  };
  EXPECT_EQ(message("return nil"),
            "deck.lua:2: flux: 'value' at (1, 2, 3) is nil, the value of what was not set or returned; "
            "expected a heat flux, such as 20*W/m^2");
  EXPECT_EQ(message("return 0/0"), "deck.lua:2: flux: 'value' at (1, 2, 3) is not a finite number (nan)");
  EXPECT_EQ(message("return y + nothing"), "deck.lua:2: unknown name 'nothing'; declare it with 'local' before use");
  EXPECT_EQ(message("while true do end"), "deck.lua:2: still running after 5 million instructions: an endless loop?");
  EXPECT_EQ(message("fix { surface = 's', x = 0 }"),
            "deck.lua:2: the deck has been read: a function of the results cannot declare anything");
}

TEST(Deck, ImportedMeshesAreScaledAndRenamed) {
  const DeckFolder folder;
  std::filesystem::copy_file(ASHLAR_TEST_DATA "/dam_D0_r1_ny1.msh", folder.path() + "dam.msh");
  const Deck deck = read_deck(
      folder.write(
          "deck.lua",
          R"(import_mesh { file = "dam.msh", unit = mm, regions = { concrete = "dam" }, surfaces = { up_wet = "wet" } })"),
      {});
  const Mesh& mesh = deck.model.imports[0].mesh;
  EXPECT_GE(mesh.find_region("dam"), 0);
  EXPECT_LT(mesh.find_region("concrete"), 0);
  EXPECT_TRUE(mesh.find_surface("wet"));
  double highest = 0;
  for (const auto& p : mesh.points) highest = std::max(highest, p.z);
  EXPECT_NEAR(highest, 0.060, 1e-12);
  EXPECT_EQ(deck.files, (std::vector{folder.path() + "deck.lua", folder.path() + "dam.msh"}));
}

TEST(Deck, ArgumentsTakeTheirUnitAndRange) {
  const std::string text = R"(local args = deck.args {
    water = { default = 150, unit = m, range = {0, 200*m}, doc = "level" },
    young = { default = 30*GPa, unit = GPa, doc = "modulus" },
    fine  = { default = false, doc = "small elements" },
    site  = { default = "alpine", doc = "where" },
  }
  assert(args.water == expected_water and args.young == 25*GPa and args.fine and args.site == "coast"))";
  const auto with = [&](const std::string& water) { return "local expected_water = " + water + "\n" + text; };
  const std::map<std::string, std::string> others{{"young", "25"}, {"fine", "true"}, {"site", "coast"}};
  auto settings = others;
  EXPECT_EQ(complaint(with("150*m"), settings), "");
  settings["water"] = "100 + 55";
  EXPECT_EQ(complaint(with("155*m"), settings), "");
  settings["water"] = "0.15*km";
  EXPECT_EQ(complaint(with("150*m"), settings), "");
  const Deck deck = read_text(with("150*m"), settings);
  ASSERT_EQ(deck.arguments.size(), 4u);
  EXPECT_EQ(deck.arguments[2].name, "water");
  EXPECT_EQ(deck.arguments[2].value, "150 m");
  EXPECT_TRUE(deck.arguments[2].set);
  EXPECT_EQ(deck.arguments[3].fallback, "30 GPa");
  EXPECT_EQ(deck.arguments[3].value, "25 GPa");
  settings["water"] = "250";
  EXPECT_EQ(complaint(with("150*m"), settings),
            "deck.lua:3: deck.args: argument 'water' is 250 m; its range is 0 m to 200 m");
  settings["water"] = "2*";
  EXPECT_EQ(complaint(with("150*m"), settings), "--set water=2*: the value is not an expression such as 155 or 2*m");
  EXPECT_EQ(complaint("local args = deck.args { water = { default = 1, doc = 'x' } }\nlocal a = args.watr"),
            "deck.lua:2: there is no argument 'watr': did you mean 'water'?");
  EXPECT_EQ(complaint("model 'm' {}", {{"water", "3"}}), "--set water=3: this deck has no arguments (deck.args)");
}

TEST(Deck, TablesAndModulesLieBesideTheDeck) {
  const DeckFolder folder;
  folder.write("air.csv", "# measured\nday, air\n1, 28.2\n2, -1.5e0\n");
  folder.write("seasons.lua", "local air = deck.read_table 'air.csv'\nreturn { air = air }");
  const Deck deck = read_deck(folder.write("deck.lua", R"(
    local air = require("seasons").air
    assert(#air.day == 2 and air.air[1] == 28.2 and interpolate(air.day, air.air, 1.5) == 13.35)
    assert(require("seasons").air == air))"),
                              {});
  EXPECT_EQ(deck.files.size(), 3u);
  EXPECT_EQ(complaint("require 'os'"), "deck.lua:1: require 'os': there is no file os.lua");
  EXPECT_EQ(complaint("require '../deck'"),
            "deck.lua:1: require '../deck': names a file beside the deck, without '.lua'");
  EXPECT_EQ(complaint("deck.read_table '../secret.csv'"),
            "deck.lua:1: file '../secret.csv': give a path inside the deck's own folder");
  EXPECT_EQ(complaint("deck.read_table '/etc/passwd'"),
            "deck.lua:1: file '/etc/passwd': give a path inside the deck's own folder");
}

TEST(Deck, BadNumbersInATableAreNamed) {
  const DeckFolder folder;
  folder.write("air.csv", "day,air\n1,warm\n");
  try {
    read_deck(folder.write("deck.lua", "deck.read_table 'air.csv'"), {});
    FAIL();
  } catch (const DeckError& error) {
    EXPECT_EQ(error.what(), folder.path() + "air.csv:2: column 'air': 'warm' is not a number");
  }
}

TEST(Deck, EveryMistakeIsReportedAndALoopDoesNotBuryThem) {
  EXPECT_EQ(complaint("fix 'a' { x = 0 }\nflux { surface = 's' }\nlocal x = nothing"),
            "deck.lua:1: fix 'a': missing 'surface': surfaces where it acts: declared with `surface`, sides of "
            "regions such as \"dam.bottom\" (left, right, front, back, bottom, top), or groups of the "
            "mesh file\n"
            "deck.lua:2: flux: missing 'value' [W/m^2]: heat per area and time into the body, a number or a function "
            "of x, y, z\n"
            "deck.lua:3: unknown name 'nothing'; declare it with 'local' before use");
  const std::string many = complaint("for i = 1, 1000 do gravity { w = i } end");
  EXPECT_EQ(std::count(many.begin(), many.end(), '\n'), 40);
  EXPECT_NE(many.find("... and 960 more mistakes"), std::string::npos);
}

TEST(Deck, TablesThatHoldThemselvesAndErrorsWithoutTextAreRefused) {
  EXPECT_EQ(complaint("local t = {}\nt[1] = t\nstage 'a' { apply = t, solve = static {} }"),
            "deck.lua:3: stage 'a': 'apply' has lists inside lists without end");
  EXPECT_EQ(complaint("error({})"), "deck.lua: error() was called without a text");
  EXPECT_EQ(complaint("local a = { default = 1, doc = 'x' }\ndeck.args { a = a }\ndeck.args { a = a }"),
            "deck.lua:3: deck.args: argument 'a' is declared a second time");
}

TEST(Deck, ATableInAVariableFallsBackToTheLineOfTheCall) {
  EXPECT_EQ(complaint("local keys = {\n  surface = 's',\n  z = 5*s,\n}\ndisplacement(keys)"),
            "deck.lua:5: displacement: 'z' is 5 s; expected a length, such as 2*m");
}

RunResult finished_run() {
  RunResult result;
  StageResult gravity;
  gravity.name = "gravity";
  gravity.converged = true;
  gravity.steps = 120;
  gravity.events = {{0.55, {}, 1, "base", "tension"}};
  result.stages = {gravity};
  HistoryTable crest;
  crest.name = "crest";
  crest.columns = {"displacement.x", "displacement.y", "displacement.z"};
  crest.units = {"m", "m", "m"};
  crest.rows = {{"gravity", 1, 1, {2.3e-3, 0, -4.4e-3}}};
  result.histories = {crest};
  return result;
}

TEST(Expect, ComparesHistoriesAndAsksFunctions) {
  const Deck deck = read_text(R"(
    stage "gravity" { solve = static {} }
    stage "winter"  { solve = static {} }
    history "crest" { at = {0, 0, 60*m}, record = "displacement" }
    expect "a" { history = "crest", component = "displacement.x", stage = "gravity", between = { 2*mm, 2.5*mm } }
    expect "b" { history = "crest", component = "displacement.z", stage = "gravity", value = -4.5*mm, tolerance = 0.05*mm }
    expect "c" { history = "crest", component = "displacement.z", value = -4.5*mm, relative = 0.05 }
    expect "d" { history = "crest", component = "displacement.z", stage = "winter", between = { -1, 1 } }
    expect "e" { that = function(r) return r.stage("gravity").converged and r.stage("gravity").first_crack == 0.55 end }
    expect "f" { that = function(r) return r.history("crest").at("displacement.z", "gravity") > 0, "crest rises" end }
    expect "g" { that = function(r) return r.stage("summer").converged end }
    expect "h" { that = function(r) return r.stage("gravity").convergd end })");
  const auto outcomes = evaluate(deck, finished_run());
  std::string passed;
  for (const auto& o : outcomes) passed += o.passed ? "y" : "n";
  EXPECT_EQ(passed, "ynynynnn");
  EXPECT_EQ(outcomes[0].message, "crest displacement.x after gravity is 2.3 mm, between 2 mm and 2.5 mm");
  EXPECT_EQ(outcomes[1].message, "crest displacement.z after gravity is -4.4 mm; wanted between -4.55 mm and -4.45 mm");
  EXPECT_EQ(outcomes[5].message, "crest rises");
  EXPECT_NE(outcomes[6].message.find("deck.lua:11: there is no finished stage 'summer'; valid: gravity"),
            std::string::npos);
  EXPECT_NE(outcomes[7].message.find("there is no value of a stage 'convergd': did you mean 'converged'?"),
            std::string::npos);
}

}  // namespace
}  // namespace ashlar
