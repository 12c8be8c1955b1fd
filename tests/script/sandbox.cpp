#include "script/sandbox.hpp"

#include "script/deck_text.hpp"

namespace ashlar {
namespace {

using test::complaint;

TEST(Sandbox, NothingReachesFilesProcessesOrCode) {
  for (const char* name :
       {"os", "io", "load", "loadstring", "loadfile", "dofile", "package", "debug", "collectgarbage", "pcall", "xpcall",
        "coroutine", "_G", "getmetatable", "rawset", "rawget", "next", "print_to_file"})
    EXPECT_NE(complaint(std::string("local x = ") + name), "") << name;
  EXPECT_NE(complaint("local x = string.dump(function() end)"), "");
  EXPECT_NE(complaint("setmetatable({}, { __gc = function() end })"), "");
  EXPECT_NE(complaint("(m).__index = 3"), "");
}

TEST(Sandbox, BytecodeIsNotADeck) {
  const test::DeckFolder folder;
  const std::string path = folder.write("deck.lua", "\x1bLua\x54");
  EXPECT_THROW(read_deck(path, {}), DeckError);
}

TEST(Sandbox, NamesOfTheLanguageCannotBeReplaced) {
  EXPECT_EQ(complaint("fix = 3"),
            "deck.lua:1: 'fix' is the noun fix and keeps that meaning; choose another name: local my_fix = ...");
  EXPECT_EQ(complaint("\ns = 3"),
            "deck.lua:2: 's' is the unit s (second) and keeps that meaning; choose another name: local my_s = ...");
  EXPECT_EQ(complaint("heigth = 3"), "deck.lua:1: global name 'heigth' is assigned; write 'local heigth = ...'");
  EXPECT_NE(complaint("local box = {}\nbox 'a' {}")
                .find("deck.lua:2: attempt to call a table value (local 'box'); it hides the noun box, choose another"),
            std::string::npos);
  EXPECT_EQ(complaint("function climate() end"),
            "deck.lua:1: global name 'climate' is assigned; write 'local function climate(...)'");
  EXPECT_EQ(complaint("local x = materal"), "deck.lua:1: unknown name 'materal'; did you mean 'material'?");
}

TEST(Sandbox, MemoryAndInstructionsAreLimited) {
  ScriptLimits small;
  small.memory = std::size_t{8} << 20;
  small.instructions = 2'000'000;
  EXPECT_EQ(complaint("local x = 'x'\nwhile true do x = x .. x end", {}, small),
            "deck.lua:2: the deck needs more than 8 MB of memory");
  EXPECT_EQ(complaint("local t = {}\nfor i = 1, 1e9 do t[i] = i end", {}, small),
            "deck.lua:2: the deck needs more than 8 MB of memory");
  EXPECT_EQ(complaint("local function f() return f() end\nf()", {}, small),
            "deck.lua:1: still running after 2 million instructions: an endless loop?");
  EXPECT_NE(complaint("local function f() return 1 + f() end\nf()").find("deck.lua:1: stack overflow"),
            std::string::npos);
}

TEST(SandboxDeathTest, ACostlyPatternEndsTheProcessWithCodeTwo) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  ScriptLimits short_time;
  short_time.seconds = 0.3;
  EXPECT_EXIT(complaint("return (string.rep('a', 50000)):find(string.rep('a*', 30) .. 'b')", {}, short_time),
              testing::ExitedWithCode(2), "still not finished after 0.3 s");
}

TEST(Sandbox, TheSameDeckIsTheSameEveryTime) {
  // Keys in sorted order, whatever their addresses; one seed.
  const std::string text = R"(
    local order = {}
    for key, value in pairs { pear = 1, apple = 2, [10] = 3, [2] = 4, fig = 5, [true] = 6 } do order[#order + 1] = tostring(key) end
    assert(table.concat(order, " ") == "2 10 apple fig pear true", table.concat(order, " "))
    error("drawn " .. math.random(1000000) .. " " .. math.random(1000000)))";
  const std::string first = complaint(text);
  EXPECT_NE(first.find("drawn"), std::string::npos) << first;
  EXPECT_EQ(first, complaint(text));
}

}  // namespace
}  // namespace ashlar
