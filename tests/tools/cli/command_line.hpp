// A user at the shell: runs the scenelore that was built, in a folder of the test's own.
#pragma once

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "process.hpp"

namespace scenelore::test {

class CommandLine : public testing::Test {
 protected:
  /// `scenelore arguments…`; a name that starts with "@" lies in the test's folder.
  Finished scenelore(std::vector<std::string> arguments) { return run(full(std::move(arguments)), folder_); }

  std::vector<std::string> full(std::vector<std::string> arguments) const {
    for (std::string& argument : arguments) {
      if (argument.starts_with('@')) argument = (folder_ / argument.substr(1)).string();
    }
    arguments.insert(arguments.begin(), SCENELORE_BINARY);
    return arguments;
  }

  /// A small simulated office as "@office.ply".
  void make_scan() {
    const Finished made = scenelore({"simulate", "@office.ply", "--seed", "3", "--points", "60000"});
    ASSERT_EQ(made.code, 0) << made.err;
  }

  /// "@office.ply" and its labelled knowledge base "@office.gpkg".
  void make_labelled() {
    make_scan();
    const Finished labelled = scenelore({"run", "@office.ply"});
    ASSERT_EQ(labelled.code, 0) << labelled.err;
  }

  /// What a user's sqlite3 would do; throws with SQLite's message.
  void edit(const std::string& file, const std::string& sql) const {
    sqlite3* base = nullptr;
    char* message = nullptr;
    const bool ok = sqlite3_open((folder_ / file).c_str(), &base) == SQLITE_OK &&
                    sqlite3_exec(base, sql.c_str(), nullptr, nullptr, &message) == SQLITE_OK;
    const std::string text = ok ? "" : message ? message : sqlite3_errmsg(base);
    sqlite3_free(message);
    sqlite3_close(base);
    if (!ok) throw std::runtime_error(text);
  }

  /// CSV answer of a query, without its header line.
  std::string ask(const std::string& file, const std::string& sql) {
    const Finished answer = scenelore({"query", "@" + file, sql, "--csv"});
    EXPECT_EQ(answer.code, 0) << answer.err;
    return answer.out.substr(std::min(answer.out.size(), answer.out.find('\n') + 1));
  }

  TemporaryFolder folder_;
};

}  // namespace scenelore::test
