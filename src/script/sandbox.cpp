#include "script/sandbox.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "base/nearest_name.hpp"
#include "script/function_docs.hpp"
#include "script/in_time.hpp"
#include "script/quantity.hpp"
#include "script/schema.hpp"

namespace ashlar {
namespace {

constexpr int hook_interval = 1000;
constexpr std::uintmax_t largest_source = 16u << 20;

std::string folder_of(const std::string& path) {
  const auto slash = path.rfind('/');
  return slash == std::string::npos ? "" : path.substr(0, slash + 1);
}

std::string megabytes(std::size_t bytes) { return std::to_string(bytes >> 20) + " MB"; }

/// Names of the text keys of the table at `index`, sorted.
std::vector<std::string> text_keys(lua_State* L, int index) {
  std::vector<std::string> names;
  lua_pushnil(L);
  while (lua_next(L, index)) {
    lua_pop(L, 1);
    if (lua_type(L, -1) == LUA_TSTRING) names.push_back(text_at(L, -1));
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// A name that neither the deck nor the language knows.
int unknown_global(lua_State* L) {
  const std::string name = text_at(L, 2);
  static const std::set<std::string> closed = {"os",      "io",     "load",  "loadstring", "loadfile", "dofile",
                                               "package", "debug",  "pcall", "xpcall",     "next",     "collectgarbage",
                                               "rawset",  "rawget", "_G",    "coroutine",  "rawequal", "rawlen"};
  if (name == "next")
    throw ScriptError("'next' is not part of the deck language: its order changes from run to run; use pairs");
  if (closed.contains(name))
    throw ScriptError("'" + name +
                      "' is not part of the deck language: a deck describes a model and cannot start programs, "
                      "touch files or load code (data tables: deck.read_table)");
  const auto names = text_keys(L, 1);
  const std::string near = nearest_name(name, names);
  throw ScriptError("unknown name '" + name + "'" +
                    (near.empty() ? "; declare it with 'local' before use" : "; did you mean '" + near + "'?"));
}

/// "the unit s (second)", "the noun fix": what a name is in the deck language; "" if nothing.
std::string meaning(const std::string& name) {
  for (const auto& unit : units())
    if (unit.name == name) return "the unit " + name + " (" + unit.doc + ")";
  if (find_noun(name)) return "the noun " + name;
  for (const auto& function : function_docs())
    if (function.words.front() == name) return "the function " + name;
  return "";
}

int new_global(lua_State* L) {
  const std::string name = text_at(L, 2);
  if (const std::string own = meaning(name); !own.empty())
    throw ScriptError("'" + name + "' is " + own + " and keeps that meaning; choose another name: local my_" + name +
                      " = ...");
  throw ScriptError("global name '" + name + "' is assigned; write 'local " +
                    (lua_isfunction(L, 3) ? "function " + name + "(...)" : name + " = ...") + "'");
}

int unknown_key(lua_State* L) {
  const std::string key = text_at(L, 2);
  throw ScriptError("there is no " + text_at(L, lua_upvalueindex(1)) + " '" + key + "'" +
                    suggest_name(key, text_keys(L, 1)));
}

int constant_table(lua_State*) { throw ScriptError("this table cannot be changed"); }

/// strict(t, "argument"): t, which from now on answers a wrong key with the right ones.
int strict(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  luaL_checktype(L, 2, LUA_TSTRING);
  lua_newtable(L);
  lua_pushvalue(L, 2);
  lua_pushcclosure(L, guarded<unknown_key>, 1);
  lua_setfield(L, -2, "__index");
  lua_pushcfunction(L, guarded<constant_table>);
  lua_setfield(L, -2, "__newindex");
  lua_pushboolean(L, false);
  lua_setfield(L, -2, "__metatable");
  lua_pushvalue(L, 1);
  lua_insert(L, -2);
  lua_setmetatable(L, -2);
  return 1;
}

}  // namespace

Watchdog::Watchdog(double seconds)
    : thread_([this, limit = std::chrono::duration<double>(seconds)] {
        std::unique_lock lock(mutex_);
        while (!closing_) {
          changed_.wait(lock, [this] { return running_ || closing_; });
          if (closing_) return;
          // One of many short calls in a row may end and the next begin before this thread wakes.
          const auto over = [this, call = call_] { return !running_ || closing_ || call_ != call; };
          // Time of the processor: a busy machine takes longer. Waiting for what is left of it is never too long.
          const std::clock_t begin = std::clock();
          auto left = limit;
          while (left.count() > 0 && !changed_.wait_for(lock, left, over))
            left = limit - std::chrono::duration<double>(double(std::clock() - begin) / CLOCKS_PER_SEC);
          if (left.count() > 0) continue;
          std::fprintf(stderr, "%s: still not finished after %g s: an endless loop or a costly string search\n",
                       what_.c_str(), limit.count());
          std::fflush(stderr);
          _exit(2);
        }
      }) {}
Watchdog::~Watchdog() {
  {
    std::lock_guard lock(mutex_);
    closing_ = true;
  }
  changed_.notify_one();
  thread_.join();
}
void Watchdog::begin(const std::string& what) {
  std::lock_guard lock(mutex_);
  what_ = what;
  ++call_;
  running_ = true;
  changed_.notify_one();
}
void Watchdog::end() {
  std::lock_guard lock(mutex_);
  running_ = false;
  changed_.notify_one();
}

Sandbox::Sandbox(std::string deck_path, const ScriptLimits& given)
    : limits(given), deck(std::move(deck_path)), folder(folder_of(deck)), watchdog_(given.seconds) {
  lua_State* L = L_ = lua_newstate(allocate, this);
  if (!L) throw ResourceError("no memory for the deck's interpreter");
  *static_cast<Sandbox**>(lua_getextraspace(L)) = this;
  lua_pushcfunction(L, open_libraries);
  // The bundled prelude closes what a deck must not reach and then runs with the full table.
  if (lua_pcall(L, 0, 2, 0) != LUA_OK) throw ResourceError(text_at(L, -1));
  run_text(bundled_scripts().at("prelude"), "=prelude");
  lua_setmetatable(L, -2);
  lua_newtable(L);
  lua_newtable(L);
  lua_pushvalue(L, -3);
  lua_setfield(L, -2, "__index");
  lua_pushcfunction(L, guarded<new_global>);
  lua_setfield(L, -2, "__newindex");
  lua_pushboolean(L, false);
  lua_setfield(L, -2, "__metatable");
  lua_setmetatable(L, -2);
  lua_rawseti(L, LUA_REGISTRYINDEX, LUA_RIDX_GLOBALS);
  lua_setfield(L, LUA_REGISTRYINDEX, "names");  // the table behind: nouns are added to it
}

/// Pushes the table of every name that a deck sees and the metatable that it gets once the prelude has run.
int Sandbox::open_libraries(lua_State* L) {
  const std::pair<const char*, lua_CFunction> libraries[] = {{LUA_GNAME, luaopen_base},
                                                             {LUA_TABLIBNAME, luaopen_table},
                                                             {LUA_STRLIBNAME, luaopen_string},
                                                             {LUA_MATHLIBNAME, luaopen_math},
                                                             {LUA_UTF8LIBNAME, luaopen_utf8}};
  for (auto [name, open] : libraries) {
    luaL_requiref(L, name, open, 1);
    lua_pop(L, 1);
  }
  // `real` holds every name; decks see an empty table in front of it, so that no name is ever overwritten.
  lua_pushglobaltable(L);
  open_units(L);
  open_in_time(L);
  lua_pushcfunction(L, guarded<require>);
  lua_setfield(L, -2, "require");
  lua_pushcfunction(L, guarded<strict>);
  lua_setfield(L, -2, "strict");
  lua_newtable(L);
  lua_pushcfunction(L, guarded<unknown_global>);
  lua_setfield(L, -2, "__index");
  return 2;
}

Sandbox::~Sandbox() {
  if (L_) lua_close(L_);
}

Sandbox& Sandbox::of(lua_State* L) { return **static_cast<Sandbox**>(lua_getextraspace(L)); }

void* Sandbox::allocate(void* self, void* block, std::size_t old_size, std::size_t new_size) {
  auto& sandbox = *static_cast<Sandbox*>(self);
  if (!block) old_size = 0;  // then it is a type code
  if (new_size == 0) {
    std::free(block);
    sandbox.used_ -= old_size;
    return nullptr;
  }
  if (new_size > old_size && sandbox.used_ + (new_size - old_size) > sandbox.limits.memory) {
    sandbox.failed_at_ = sandbox.where();
    return nullptr;
  }
  void* moved = std::realloc(block, new_size);
  if (moved) sandbox.used_ += new_size - old_size;
  return moved;
}

void Sandbox::count(lua_State* L, lua_Debug*) {
  Sandbox& sandbox = of(L);
  if ((sandbox.budget_ -= hook_interval) > 0) return;
  sandbox.budget_ = 0;
  push(L, sandbox.where().prefix() + "still running after " + std::to_string(sandbox.allowance_ / 1'000'000) +
              " million instructions: an endless loop?");
  lua_error(L);
}

void Sandbox::call(int arguments, int results, long instructions, const std::string& what) {
  failed_at_ = {};
  budget_ = allowance_ = instructions;
  lua_sethook(L_, count, LUA_MASKCOUNT, hook_interval);
  watchdog_.begin(what);
  const int status = lua_pcall(L_, arguments, results, 0);
  watchdog_.end();
  if (status == LUA_OK) return;
  std::string message = text_at(L_, -1);
  if (status == LUA_ERRMEM || message == "not enough memory")
    message = (failed_at_.line ? failed_at_.prefix() : what + ": ") + "the deck needs more than " +
              megabytes(limits.memory) + " of memory";
  lua_pop(L_, 1);
  if (message.find("got ashlar quantity") != std::string::npos)
    message +=
        "; a value with a unit becomes a plain number when it is divided by one: x/m. In a function of time t is a "
        "plain "
        "number of seconds, and so is t*s/year one";
  // Lua's own error about a value of the wrong kind: "attempt to call a table value (local 'joint')".
  if (const auto at = message.find("(local '"); at != std::string::npos) {
    const std::string name = message.substr(at + 8, message.find('\'', at + 8) - at - 8), own = meaning(name);
    if (!own.empty()) message += "; it hides " + own + ", choose another name";
  }
  std::vector<std::string> lines;
  std::istringstream split(message);
  for (std::string line; std::getline(split, line);) lines.push_back(line);
  if (lines.empty()) lines.push_back(what + ": error() was called without a text");
  throw DeckError(lines);
}

void Sandbox::run_text(const std::string& text, const std::string& name) {
  if (luaL_loadbufferx(L_, text.data(), text.size(), name.c_str(), "t") != LUA_OK) {
    std::string message = text_at(L_, -1);
    lua_pop(L_, 1);
    if (message.find("malformed number") != std::string::npos) message += "; a unit is multiplied: 30*GPa";
    if (message.find("'}' expected") != std::string::npos) message += "; is a comma or a brace missing before it?";
    throw DeckError(std::vector{message});
  }
  call(0, 0, limits.instructions, deck);
}

std::string Sandbox::read_source(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw DeckError({}, path + ": this is a folder; name the deck in it, such as " +
                            (std::filesystem::path(path) / "dam.lua").string());
  if (!std::filesystem::is_regular_file(path, ignored)) throw DeckError({}, path + ": no such file");
  if (std::filesystem::file_size(path, ignored) > largest_source)
    throw DeckError({}, path + ": larger than " + megabytes(largest_source) + ", which no deck is");
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file) throw DeckError({}, path + ": cannot be read; may you read it?");
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);  // the mark that some editors begin UTF-8 with
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    throw DeckError({}, path + ": is written in UTF-16; save it as UTF-8");
  if (text.find('\0') != std::string::npos) throw DeckError({}, path + ": is no text; a deck is a Lua text in UTF-8");
  lines_[path] = DeckLines(text);
  return text;
}

std::vector<std::string> Sandbox::hidden_names() const {
  std::vector<std::string> notes;
  for (const auto& [path, lines] : lines_)
    for (const LocalName& local : lines.locals()) {
      const std::string own = meaning(local.name);
      const bool unit = own.starts_with("the unit");
      // A parameter t is time, and what lives in a few lines hides a unit only from those that would use it.
      if (own.empty() || (local.of_block && (!unit || !local.is_factor || local.name == "t"))) continue;
      notes.push_back(Where{path, local.line}.prefix() + "the name '" + local.name + "' hides " + own + ": " +
                      (unit ? "3*" + local.name + " has no unit" : local.name + " { ... } does not work") +
                      " where it is seen; choose another name");
    }
  return notes;
}

void Sandbox::run_deck() { run_text(read_source(deck), "@" + deck); }

std::vector<std::string> Sandbox::sources() const {
  std::vector<std::string> paths;
  for (const auto& [path, lines] : lines_) paths.push_back(path);
  return paths;
}

Where Sandbox::where(const std::string& noun, const std::string& name, const std::string& key) const {
  lua_Debug frame;
  for (int level = 0; L_ && lua_getstack(L_, level, &frame); ++level) {
    lua_getinfo(L_, "Sl", &frame);
    if (frame.source[0] != '@' || frame.currentline <= 0) continue;
    const std::string file = frame.source + 1;
    const auto lines = lines_.find(file);
    return {file, lines == lines_.end() ? frame.currentline : lines->second.line(frame.currentline, noun, name, key)};
  }
  return {};
}

std::string Sandbox::data_file(const std::string& file) const {
  const std::filesystem::path path(file);
  if (file.empty() || path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end())
    throw ScriptError("file '" + file + "': give a path inside the deck's own folder");
  const std::string full = folder_of(where().file) + file;
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(full, ignored)) throw ScriptError("file '" + full + "' does not exist");
  return full;
}

int Sandbox::require(lua_State* L) {
  Sandbox& sandbox = of(L);
  const std::string name = luaL_checkstring(L, 1);
  luaL_getsubtable(L, LUA_REGISTRYINDEX, LUA_LOADED_TABLE);
  if (lua_getfield(L, -1, ("deck:" + name).c_str()) != LUA_TNIL) return 1;
  for (char c : name)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_' && c != '-' && c != '/')
      throw ScriptError("require '" + name + "': names a file beside the deck, without '.lua'");
  const std::string path = sandbox.folder + name + ".lua";
  std::error_code ignored;
  const bool beside = name[0] != '/' && std::filesystem::is_regular_file(path, ignored);
  const auto bundled = bundled_scripts().find(name);
  if (!beside && bundled == bundled_scripts().end())
    throw ScriptError("require '" + name + "': there is no file " + path);
  const std::string text = beside ? sandbox.read_source(path) : bundled->second;
  if (luaL_loadbufferx(L, text.data(), text.size(), (beside ? "@" + path : "=" + name).c_str(), "t") != LUA_OK)
    return lua_error(L);
  lua_call(L, 0, 1);
  if (lua_isnil(L, -1)) {
    lua_pop(L, 1);
    lua_pushboolean(L, true);
  }
  lua_pushvalue(L, -1);
  lua_setfield(L, 2, ("deck:" + name).c_str());
  return 1;
}

}  // namespace ashlar
