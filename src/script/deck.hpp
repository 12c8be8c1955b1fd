#pragma once
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "script/limits.hpp"
#include "solve/result.hpp"

/// Reading a deck: Lua in, Model out. Nothing is meshed or solved here.
namespace ashlar {

class Sandbox;

/// `expect "name" { ... }`: a statement about the results.
struct Expect {
  std::string name;
  Where where;
  std::string history, component, stage;         ///< stage "": the last row
  std::optional<std::array<double, 2>> between;  ///< lowest and highest value, SI
  int function = 0;                              ///< of the deck, called with the result; 0: none
};

/// One `deck.args` entry.
struct Argument {
  std::string name, unit, doc;
  std::string fallback;  ///< as shown: "150 m"
  std::string value;     ///< in use in this run
  bool set = false;      ///< by --set
};

struct Deck {
  std::string path;                ///< as given
  std::vector<std::string> files;  ///< every file that was read: the deck, its modules, tables and meshes
  std::vector<Argument> arguments;
  Model model;  ///< not meshed yet: call build_mesh, then check_model
  std::vector<Expect> expects;
  std::shared_ptr<Sandbox> sandbox;  ///< keeps the deck's functions alive
};

/// Runs the deck and reads its mesh files. `settings` are the --set name=value pairs: a value is an expression such as
/// `155` (in the argument's unit) or `2*m`. Throws DeckError with everything that is wrong in the deck's tables.
Deck read_deck(const std::string& path, const std::map<std::string, std::string>& settings,
               const ScriptLimits& limits = {});

struct ExpectOutcome {
  std::string name;
  bool passed = false;
  double found = 0;                              ///< SI; NaN where a function decided or nothing was found
  std::optional<std::array<double, 2>> between;  ///< lowest and highest value allowed, SI
  std::string wanted;                            ///< "between -60 mm and -5 mm" or "function"
  std::string message;                           ///< one line for the summary
};

/// Compares a finished run with the deck's expects, in the deck's order. An expect whose stage was not reached fails.
std::vector<ExpectOutcome> evaluate(const Deck& deck, const RunResult& result);

/// `ashlar help WORD`, from the schema: a noun, key, law, choice, unit, function, value of a result, "units" or
/// "functions". Throws DeckError for a word that does not exist.
std::string help(const std::string& word);
/// `ashlar help`: every noun with one line.
std::string help_index();

}  // namespace ashlar
