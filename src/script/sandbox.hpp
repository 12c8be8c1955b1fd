#pragma once
#include <atomic>
#include <condition_variable>
#include <exception>
#include <lua.hpp>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "base/error.hpp"
#include "script/limits.hpp"
#include "script/lines.hpp"

/// Where decks run: a Lua without files, processes, bytecode or C modules, limited in memory, instructions and time.
/// Decks are not trusted: they are mailed around like spreadsheets.
namespace ashlar {

/// A mistake in a deck met by a function that Lua called; the trampoline adds the line of the call.
class ScriptError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Ends the process when Lua stays too long in one C function, where no hook can fire (pattern matching).
class Watchdog {
 public:
  explicit Watchdog(double seconds);
  ~Watchdog();
  void begin(const std::string& what);
  void end();

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool running_ = false, closing_ = false;
  long call_ = 0;  ///< number of the present call
  std::string what_;
  std::thread thread_;
};

/// One deck's Lua state.
class Sandbox : public std::enable_shared_from_this<Sandbox> {
 public:
  /// `deck` is the path as given by the user; messages show it, and `require` and data files are relative to its
  /// folder.
  Sandbox(std::string deck, const ScriptLimits& limits);
  ~Sandbox();
  Sandbox(const Sandbox&) = delete;

  lua_State* state() const { return L_; }
  static Sandbox& of(lua_State* L);

  /// Calls the function below its `arguments` at the top of the stack, within the limits. Throws DeckError.
  void call(int arguments, int results, long instructions, const std::string& what);
  void run_text(const std::string& text, const std::string& name);
  void run_deck();
  /// Line of the deck that called the running C function; of `key` in the literal table of a noun if that can be told.
  Where where(const std::string& noun = "", const std::string& name = "", const std::string& key = "") const;
  /// Path of `file` relative to the folder of the file that is running. Throws ScriptError if it leaves the deck's
  /// folder.
  std::string data_file(const std::string& file) const;

  /// Names of the language that the deck gives another meaning, one note each.
  std::vector<std::string> hidden_names() const;
  /// Every Lua file that was read, sorted.
  std::vector<std::string> sources() const;

  Complaints complaints;  ///< found while reading; all are reported together
  std::mutex busy;        ///< held while a function of position runs: they may be asked from several threads
  const ScriptLimits limits;
  const std::string deck;    ///< path as given
  const std::string folder;  ///< of the deck, with a final slash, or ""

 private:
  static void* allocate(void* self, void* block, std::size_t old_size, std::size_t new_size);
  static void count(lua_State* L, lua_Debug*);
  static int open_libraries(lua_State* L);
  static int require(lua_State* L);
  std::string read_source(const std::string& path);

  std::map<std::string, DeckLines> lines_;  ///< by path
  std::size_t used_ = 0;
  long allowance_ = 0, budget_ = 0;  ///< instructions of the running call: given, left
  Where failed_at_;
  Watchdog watchdog_;
  lua_State* L_ = nullptr;
};

/// The one way into C++ from Lua: turns a C++ exception into a Lua error (Lua's own, thrown as a pointer, passes).
template <int (*function)(lua_State*)>
int guarded(lua_State* L) {
  std::string message;
  try {
    return function(L);
  } catch (const std::exception& error) {
    message = error.what();
    if (dynamic_cast<const ScriptError*>(&error)) message.insert(0, Sandbox::of(L).where().prefix());
  }
  lua_pushlstring(L, message.data(), message.size());
  message = {};
  return lua_error(L);
}

inline void push(lua_State* L, const std::string& text) { lua_pushlstring(L, text.data(), text.size()); }
inline std::string text_at(lua_State* L, int index) {
  std::size_t size = 0;
  const char* s = lua_tolstring(L, index, &size);
  return s ? std::string(s, size) : std::string();
}

/// The program's own Lua files, by name without ".lua" (lua/ of the sources, embedded at build time).
const std::map<std::string, std::string>& bundled_scripts();

}  // namespace ashlar
