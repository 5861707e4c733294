#include "lua_state.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "lua_files.hpp"
#include "scenelore/rules/error.hpp"

namespace scenelore::rules {

namespace {

/// The hook runs after so many instructions. Small, since a single instruction can take milliseconds (a call that moves
/// a large table): what a rule overruns its time by is at most so many of these.
constexpr int kStep = 100;
constexpr std::size_t kLongestMessage = 1000;
constexpr std::size_t kLongestText = 1u << 20;  // bytes of a rule file

void put_place(lua_State* state, int level, char* out, std::size_t size) {
  lua_Debug frame;
  out[0] = '\0';
  for (; lua_getstack(state, level, &frame) != 0; ++level) {
    lua_getinfo(state, "Sl", &frame);
    if (frame.currentline <= 0 || std::strcmp(frame.short_src, LuaState::kPrelude) == 0) continue;
    std::snprintf(out, size, "%s:%d: ", frame.short_src, frame.currentline);
    return;
  }
}

/// "  above.lua:12: in degree\n…" for the calls that are active, as many as fit.
void put_traceback(lua_State* state, char* out, std::size_t size) {
  lua_Debug frame;
  std::size_t used = 0;
  out[0] = '\0';
  for (int level = 1; lua_getstack(state, level, &frame) != 0; ++level) {
    lua_getinfo(state, "Sln", &frame);
    if (frame.currentline <= 0 || std::strcmp(frame.short_src, LuaState::kPrelude) == 0) continue;
    const int written = std::snprintf(out + used, size - used, "  %s:%d: in %s\n", frame.short_src, frame.currentline,
                                      frame.name != nullptr ? frame.name : "the function declared there");
    if (written < 0 || static_cast<std::size_t>(written) >= size - used) {
      out[used] = '\0';
      return;
    }
    used += static_cast<std::size_t>(written);
  }
}

}  // namespace

LuaState::LuaState(const Budget& budget, bool counted) : budget_(budget), counted_(counted), limit_(budget.memory_bytes) {
  lua_ = lua_newstate(allocate, this);
  if (lua_ == nullptr) throw Error("a Lua state does not fit into " + std::to_string(budget.memory_bytes) + " bytes");
  *static_cast<LuaState**>(lua_getextraspace(lua_)) = this;
}

LuaState::~LuaState() {
  ++host_;
  lua_close(lua_);
}

void* LuaState::allocate(void* self, void* block, std::size_t old_size, std::size_t size) {
  LuaState& state = *static_cast<LuaState*>(self);
  if (block == nullptr) old_size = 0;  // Lua tells a kind of object there
  if (size == 0) {
    std::free(block);
    state.used_ -= old_size;
    return nullptr;
  }
  if (size > old_size) {
    const std::size_t more = size - old_size;
    if (state.host_ > 0) {
      state.limit_ += more;
    } else if (more > state.limit_ - std::min(state.limit_, state.used_)) {
      state.refused_memory_ = true;
      if (state.lua_ != nullptr) put_place(state.lua_, 0, state.refused_place_, sizeof state.refused_place_);
      return nullptr;
    }
  }
  void* moved = std::realloc(block, size);
  if (moved != nullptr) state.used_ += size - old_size;
  return moved;
}

void LuaState::start_counting() {
  spent_ = 0;
  timed_ = false;  // most calls end before the hook runs and never look at the clock
  if (counted_ && (exhausted_ || lua_gethook(lua_) == nullptr)) lua_sethook(lua_, count_hook, LUA_MASKCOUNT, kStep);
  exhausted_ = false;
  refused_memory_ = false;
}

void LuaState::count_hook(lua_State* state, lua_Debug*) {
  LuaState& self = of(state);
  self.spent_ += kStep;
  const auto now = std::chrono::steady_clock::now();
  if (!self.timed_) self.start_ = now;
  self.timed_ = true;
  const bool too_long = now - self.start_ > self.budget_.time;
  if (!self.exhausted_ && self.spent_ <= self.budget_.instructions && !too_long) return;
  if (!self.exhausted_) lua_sethook(state, count_hook, LUA_MASKCOUNT, 1);  // a pcall around this must not run on
  self.exhausted_ = true;
  char place[80];
  put_place(state, 0, place, sizeof place);
  if (too_long) {
    luaL_error(state, "%sstopped after %d ms: does it loop for ever?", place,
               static_cast<int>(self.budget_.time.count()));
  }
  luaL_error(state, "%sstopped after %I instructions: does it loop for ever?", place,
             static_cast<lua_Integer>(self.budget_.instructions));
}

/// Message handler: whatever was thrown becomes a text of bounded length.
int LuaState::describe_error(lua_State* state) {
  ++of(state).host_;
  put_traceback(state, of(state).traceback_, sizeof of(state).traceback_);
  if (lua_type(state, 1) != LUA_TSTRING) {
    char place[80];
    put_place(state, 1, place, sizeof place);
    if (lua_type(state, 1) == LUA_TNUMBER) {
      lua_pushfstring(state, "%serror %s", place, lua_tostring(state, 1));
    } else {
      lua_pushfstring(state, "%serror with a %s instead of a text", place, luaL_typename(state, 1));
    }
  } else {
    std::size_t length = 0;
    const char* text = lua_tolstring(state, 1, &length);
    // A wrong argument noticed inside the prelude is the caller's mistake: the position is his.
    const std::string_view whole(text, length), prelude(kPrelude);
    if (whole.substr(0, prelude.size()) == prelude && whole.substr(prelude.size(), 1) == ":") {
      const std::size_t number_end = whole.find(": ", prelude.size() + 1);
      char place[80];
      put_place(state, 1, place, sizeof place);
      lua_pushfstring(state, "%s%s", place, number_end == whole.npos ? text : text + number_end + 2);
    } else if (length > kLongestMessage) {
      lua_pushlstring(state, text, kLongestMessage);
      lua_pushliteral(state, " …");
      lua_concat(state, 2);
    }
  }
  --of(state).host_;
  return 1;
}

void LuaState::call(int arguments, int results) {
  const int handler = lua_gettop(lua_) - arguments;
  lua_pushcfunction(lua_, describe_error);
  lua_insert(lua_, handler);
  start_counting();
  traceback_[0] = '\0';
  const int status = lua_pcall(lua_, arguments, results, handler);
  lua_remove(lua_, handler);
  if (status == LUA_OK) return;
  std::string message;
  if (status == LUA_ERRMEM) {
    refused_at_ = refused_place_;
    message = refused_at_ + "used more than " + std::to_string(budget_.memory_bytes >> 20) + " MB of memory";
  } else if (std::size_t length = 0; const char* text = lua_tolstring(lua_, -1, &length)) {
    message.assign(text, length);
  } else {
    message = "an error without a text";
  }
  lua_pop(lua_, 1);
  if (status == LUA_ERRMEM) lua_gc(lua_, LUA_GCCOLLECT);
  throw Error(with_path(std::move(message)), traceback_);
}

void LuaState::load(std::string_view text, const std::string& shown) {
  if (text.size() > kLongestText) throw Error(shown + ": longer than 1 MB; a rule file is a text of some lines");
  if (text.starts_with(LUA_SIGNATURE[0])) throw Error(shown + ": is compiled Lua; only text is loaded");
  load_as(text, shown, "t");
}

void LuaState::load_prelude() {
  static const std::string compiled = [] {
    LuaState state({});
    state.load(embedded("rules/lua/prelude.lua"), kPrelude);
    std::string code;
    const lua_Writer append = [](lua_State*, const void* bytes, std::size_t size, void* out) {
      try {
        static_cast<std::string*>(out)->append(static_cast<const char*>(bytes), size);
        return 0;
      } catch (...) {
        return 1;
      }
    };
    if (lua_dump(state.get(), append, &code, 0) != 0) throw Error("there is no memory for the prelude");
    return code;
  }();
  load_as(compiled, kPrelude, "b");
}

/// Lua shortens long names in messages, so it is given the last part and the message gets the whole one back.
void LuaState::speak_of(const std::string& shown) {
  if (shown == shown_) return;
  shown_ = shown;
  chunk_ = shown.substr(shown.find_last_of('/') + 1);
  if (chunk_.size() > 50) chunk_ = chunk_.substr(chunk_.size() - 50);
}

void LuaState::load_as(std::string_view text, const std::string& shown, const char* mode) {
  speak_of(shown);
  const int status = luaL_loadbufferx(lua_, text.data(), text.size(), ("@" + chunk_).c_str(), mode);
  if (status == LUA_OK) return;
  std::string message = status == LUA_ERRMEM ? chunk_ + ": too large for the memory limit" : lua_tostring(lua_, -1);
  lua_pop(lua_, 1);
  throw Error(with_path(std::move(message)));
}

std::string LuaState::with_path(std::string message) const {
  if (!chunk_.empty() && chunk_ != shown_ && message.compare(0, chunk_.size() + 1, chunk_ + ":") == 0) {
    message.replace(0, chunk_.size(), shown_);
  }
  return message;
}

}  // namespace scenelore::rules
