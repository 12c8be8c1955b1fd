#pragma once
#include <map>
#include <set>
#include <string>

#include "script/deck.hpp"
#include "script/fields.hpp"

namespace ashlar {

/// Builds the model while the deck runs: one call per noun.
class DeckReader {
 public:
  DeckReader(Deck& deck, const std::map<std::string, std::string>& settings);
  /// Reports what is left over at the deck's end: settings that no argument took, names without a table.
  void finish();
  /// Reads the files of import_mesh and solid.
  void read_files();

 private:
  static int noun_called(lua_State* L);
  static int table_given(lua_State* L);
  static int arguments_declared(lua_State* L);
  static int table_read(lua_State* L);
  static DeckReader& of(lua_State* L);

  /// Reads the table at `index`; pushes what the noun returns and says how many values that is.
  int declare(const NounRule& noun, const std::string& name, int index);
  void add_argument(const std::string& name, int spec, int values);
  /// The value of a --set for an argument whose default has the given Lua type. Pushes it.
  void push_setting(const std::string& name, const std::string& text, int type);

  Deck& deck_;
  std::map<std::string, std::string> settings_;
  std::set<std::string> argument_names_, taken_;
  std::map<std::pair<std::string, std::string>, Where> declared_;  ///< noun family and name
  std::map<int, std::pair<std::string, Where>> open_;              ///< named calls that wait for their table
  int next_open_ = 1;
  struct FileCall {
    std::string noun, name;
    Fields fields;
  };
  std::vector<FileCall> files_;  ///< calls of nouns that read a file once the deck is right
  std::vector<Solve> solves_;
};

/// Adds a checked noun to the deck. A condition or a solve has its index in the returned handle.
/// Further complaints, about keys that do not fit together, go to the sandbox.
int add_to_deck(Deck& deck, std::vector<Solve>& solves, const NounRule& noun, const std::string& name,
                const Fields& fields);

}  // namespace ashlar
