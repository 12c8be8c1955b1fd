#include <gtest/gtest.h>

#include "cli/arguments.hpp"

namespace ashlar {
namespace {

std::string complaint(const std::vector<std::string>& words) {
  try {
    parse_arguments(words);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "none";
}

TEST(Arguments, OptionsMayStandBeforeAndAfterTheDeckWithOrWithoutAnEqualsSign) {
  const Arguments a = parse_arguments(
      {"run", "--threads", "3", "dam.lua", "--set=water=155", "--set", "size=2*m", "--out=here", "--force"});
  EXPECT_EQ(a.verb, "run");
  EXPECT_EQ(a.operands, std::vector<std::string>{"dam.lua"});
  EXPECT_EQ(a.threads, 3);
  EXPECT_EQ(a.out, "here");
  EXPECT_TRUE(a.force);
  const std::vector<std::pair<std::string, std::string>> settings = {{"water", "155"}, {"size", "2*m"}};
  EXPECT_EQ(a.settings, settings);
}

TEST(Arguments, NothingAsksForHelp) {
  EXPECT_EQ(parse_arguments({}).verb, "help");
  EXPECT_EQ(parse_arguments({"--help"}).verb, "help");
  EXPECT_EQ(parse_arguments({"--version"}).verb, "version");
}

TEST(Arguments, AMisspeltVerbOrOptionGetsTheNearestOne) {
  EXPECT_EQ(complaint({"chek", "dam.lua"}), "unknown command 'chek': did you mean 'check'?");
  EXPECT_EQ(complaint({"run", "dam.lua", "--thread", "2"}),
            "'run' has no option '--thread': did you mean '--threads'?");
  EXPECT_EQ(complaint({"check", "dam.lua", "--memory", "2"}), "'check' has no option '--memory'; valid: --set, --to, --force");
}

TEST(Arguments, WrongValuesSayWhatIsExpected) {
  for (const char* count : {"0", "-1", "two", "2x", ""})
    EXPECT_EQ(complaint({"run", "dam.lua", "--threads", count}),
              std::string("--threads takes a whole number of at least 1, not '") + count + "'");
  EXPECT_EQ(complaint({"run", "dam.lua", "--set", "water"}),
            "--set takes NAME=VALUE, such as --set water=155, not 'water'");
  EXPECT_EQ(complaint({"run", "dam.lua", "--out"}), "--out needs a value: --out DIR");
  EXPECT_EQ(complaint({"run", "dam.lua", "--force=yes"}), "--force takes no value");
}

TEST(Arguments, LanesTakeADeviceEach) {
  const Arguments a = parse_arguments({"run", "dam.lua", "--devices", "stress=cuda:1,thermal=cpu"});
  EXPECT_EQ(a.device.kind, DeviceChoice::cuda);
  EXPECT_EQ(a.device.index, 1);
  ASSERT_TRUE(a.heat_device);
  EXPECT_EQ(a.heat_device->kind, DeviceChoice::cpu);
  EXPECT_FALSE(parse_arguments({"run", "dam.lua", "--device", "cpu"}).heat_device);
  for (const char* lanes : {"", "cuda:0", "stress=cuda:0", "thermal=cpu,stress=cpu", "stress=cpu,thermal=cpu,", "stress=cpu,thermal=gpu"})
    EXPECT_EQ(complaint({"run", "dam.lua", "--devices", lanes}),
              std::string("--devices takes stress=DEVICE,thermal=DEVICE, such as stress=cuda:0,thermal=cuda:1, not '") +
                  lanes + "'");
  EXPECT_EQ(complaint({"run", "dam.lua", "--devices=stress=cpu,thermal=cpu", "--device=cpu"}),
            "give either --device or --devices");
}

TEST(Arguments, TooFewAndTooManyOperandsShowTheUsage) {
  EXPECT_EQ(complaint({"run"}), "usage: ashlar run DECK [options], see 'ashlar help'");
  EXPECT_EQ(complaint({"run", "a.lua", "b.lua"}), "usage: ashlar run DECK [options], see 'ashlar help'");
}

TEST(Arguments, EveryVerbAndOptionIsOnTheHelpPage) {
  const std::string page = usage_page();
  for (const Verb& verb : verbs()) {
    EXPECT_NE(page.find("\n  " + verb.name + " "), std::string::npos) << verb.name;
    for (const std::string& option : verb.options) EXPECT_NE(page.find("\n  " + option + " "), std::string::npos);
  }
}

TEST(Arguments, PlotPassesEverythingOn) {
  const Arguments a = parse_arguments({"plot", "dam.run", "--of", "temperature", "--anything"});
  EXPECT_EQ(a.passed, (std::vector<std::string>{"dam.run", "--of", "temperature", "--anything"}));
}

}  // namespace
}  // namespace ashlar
