// One Lua state with limits: every call into it ends, within instructions, time and memory, with a result or an Error.
#pragma once

#include <lua.hpp>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <string>
#include <string_view>

#include "scenelore/rules/rule_set.hpp"

namespace scenelore::rules {

/// Owns the lua_State. Not movable: the state's allocator knows where the object is.
class LuaState {
 public:
  static constexpr const char* kPrelude = "prelude.lua";  ///< chunk whose lines no rule author knows

  /// Not counted: without limits of instructions and time, for files that are part of the program and have no loops. Counting takes a
  /// quarter of the time of a call.
  explicit LuaState(const Budget& budget, bool counted = true);
  ~LuaState();
  LuaState(const LuaState&) = delete;
  LuaState& operator=(const LuaState&) = delete;

  [[nodiscard]] lua_State* get() const { return lua_; }

  /// Calls the function below `arguments` values on the stack, as lua_pcall does. Throws Error with the text of what
  /// went wrong; text and file positions are as a rule author should read them.
  void call(int arguments, int results);

  /// Gives what runs from here on a whole budget, instructions and time; call() does.
  void start_counting();

  /// Pushes the function that a text compiles to. `shown` is the name in messages. Throws Error: syntax error, bytecode.
  void load(std::string_view text, const std::string& shown);

  /// Pushes the prelude, which is compiled once a process: every rule file's state runs it.
  void load_prelude();

  /// The file that messages are about from now on: that which was loaded last, unless another is named here.
  void speak_of(const std::string& shown);
  /// Name under which that file stands in messages before its full name replaces it.
  [[nodiscard]] const std::string& chunk() const { return chunk_; }

  /// Memory that the host itself puts into the state while one of these lives is not the rule's.
  class HostMemory {
   public:
    explicit HostMemory(LuaState& state) : state_(state) { ++state_.host_; }
    ~HostMemory() { --state_.host_; }
    HostMemory(const HostMemory&) = delete;
    HostMemory& operator=(const HostMemory&) = delete;

   private:
    LuaState& state_;
  };

 private:
  static LuaState& of(lua_State* state) { return **static_cast<LuaState**>(lua_getextraspace(state)); }
  static void* allocate(void* self, void* block, std::size_t old_size, std::size_t size);
  static void count_hook(lua_State* state, lua_Debug* activation);
  static int describe_error(lua_State* state);
  void load_as(std::string_view text, const std::string& shown, const char* mode);
  [[nodiscard]] std::string with_path(std::string message) const;

  Budget budget_;
  bool counted_;
  lua_State* lua_ = nullptr;
  std::size_t used_ = 0, limit_ = 0;
  int host_ = 0;
  bool refused_memory_ = false;
  std::string refused_at_;       // file:line at which memory was refused
  char refused_place_[80] = {};  // the same while inside the allocator, which must not allocate
  std::int64_t spent_ = 0;
  bool exhausted_ = false;
  std::chrono::steady_clock::time_point start_;  // of this call, from when the hook first ran
  bool timed_ = false;
  std::string shown_, chunk_;
  char traceback_[600] = {};  // of the error that is being described
};

/// The trampoline: a C++ function as a Lua function. An exception ends here and goes on as a Lua error; the function
/// itself keeps no object with a destructor alive across a Lua call that may fail.
template <lua_CFunction function>
int guarded(lua_State* state) {
  char message[300];
  try {
    return function(state);
  } catch (const std::exception& error) {
    std::string_view text = error.what();
    text = text.substr(0, sizeof message - 1);
    message[text.copy(message, text.size())] = '\0';
  } catch (...) {
    message[0] = '?';
    message[1] = '\0';
  }
  return luaL_error(state, "%s", message);
}

}  // namespace scenelore::rules
