#include "cli/arguments.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "base/nearest_name.hpp"

namespace ashlar {
namespace {

struct Option {
  std::string name;
  std::string value;  ///< what follows it, as usage lines show it; empty: nothing
  std::string doc;
};

const std::vector<Option>& options() {
  static const std::vector<Option> all = {
      {"--set", "NAME=VALUE", "gives an argument of the deck (deck.args); may be repeated"},
      {"--device", "DEVICE", "cpu, cuda, cuda:N or auto (cuda if there is a usable NVIDIA device, else cpu)"},
      {"--devices", "stress=D,thermal=D",
       "instead of --device: heat of coupled stages marches on the second device beside the stress on the first; may be "
       "the same device"},
      {"--precision", "PRECISION", "double, or single: half the memory; faster on NVIDIA devices (double)"},
      {"--threads", "N", "number of threads of the CPU (all cores)"},
      {"--memory", "GB", "most memory for the arrays of the machine that computes (what is free)"},
      {"--elements", "N", "one size of about N elements instead of the usual ones"},
      {"--out", "DIR", "folder for the results (DECK without .lua, plus .run)"},
      {"--checkpoint-every", "MINUTES",
       "time between checkpoints within a stage (10); there is one after every stage anyway"},
      {"--force", "", "replaces the results of an earlier run, or an exported file"},
      {"--to", "FILE",
       "file to export to: .msh (Gmsh), .vtu (ParaView), .inp (CalculiX, Abaqus); curves of material: .csv; "
       "interfaces of check: .vtu"},
      {"--confining", "P,P,...", "pressures of the triaxial tests of material, MPa (1,5)"},
      {"--tolerance", "T", "compare: largest relative difference that exit code 0 allows, beyond it 4 (0: the same bits)"},
      {"--line", "X,Y,Z,X,Y,Z", "compare: a table along a straight line from one point to another, m"},
      {"--stage", "NAME", "compare --line: at the end of this stage (the last one)"},
      {"--of", "FIELD", "compare --line: this field or component (displacement), such as stress.zz"},
      {"--size", "M", "length of the block in the tests of material, m; what laws that crack depend on (0.5)"},
      {"--strain", "E", "largest strain of the tests of material (until flow goes on)"},
  };
  return all;
}

std::string column(std::string text) {
  constexpr std::size_t width = 28;
  text.resize(std::max(width, text.size() + 1), ' ');
  return text;
}

std::string option_line(const Option& option) {
  return "  " + column(option.name + (option.value.empty() ? "" : " " + option.value)) + option.doc + "\n";
}

const Verb& verb_named(const std::string& word) {
  std::vector<std::string> names;
  for (const Verb& verb : verbs()) {
    if (verb.name == word) return verb;
    names.push_back(verb.name);
  }
  throw UsageError("unknown command '" + word + "'" + suggest_name(word, names));
}

int whole_number(const std::string& option, const std::string& text) {
  int count = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (error != std::errc() || end != text.data() + text.size() || count < 1)
    throw UsageError(option + " takes a whole number of at least 1, not '" + text + "'");
  return count;
}

std::vector<std::string> split_at_commas(const std::string& text) {
  std::vector<std::string> pieces;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    pieces.push_back(text.substr(from, comma - from));
    from = comma + 1;
  }
  return pieces;
}

/// NaN unless the whole text is a finite number.
double number_in(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && std::isfinite(value) ? value : std::nan("");
}

std::vector<double> numbers(const std::string& option, const std::string& text, std::size_t count) {
  std::vector<double> values;
  for (const std::string& piece : split_at_commas(text)) values.push_back(number_in(piece));
  if (values.size() != count || std::any_of(values.begin(), values.end(), [](double v) { return std::isnan(v); }))
    throw UsageError(option + " takes " + (count == 1 ? "a number" : std::to_string(count) + " numbers") + ", not '" +
                     text + "'");
  return values;
}

double positive_number(const std::string& option, const std::string& text) {
  const double value = number_in(text);
  if (!(value > 0 && value < 1e9)) throw UsageError(option + " takes positive numbers, not '" + text + "'");
  return value;
}

std::vector<double> positive_numbers(const std::string& option, const std::string& text) {
  std::vector<double> values;
  for (const std::string& piece : split_at_commas(text)) values.push_back(positive_number(option, piece));
  return values;
}

DeviceChoice device_named(const std::string& text) {
  const auto choice = device_choice(text);
  if (!choice) throw UsageError("--device takes cpu, cuda, cuda:N or auto, not '" + text + "'");
  return *choice;
}

LaneChoice lanes_named(const std::string& text) {
  const auto choice = lane_choice(text);
  if (!choice)
    throw UsageError("--devices takes stress=DEVICE,thermal=DEVICE, such as stress=cuda:0,thermal=cuda:1, not '" + text +
                     "'");
  return *choice;
}

Precision precision_named(const std::string& text) {
  if (text == "double") return Precision::double_precision;
  if (text == "single") return Precision::single_precision;
  throw UsageError("--precision takes double or single, not '" + text + "'");
}

std::pair<std::string, std::string> setting(const std::string& text) {
  const auto equals = text.find('=');
  if (equals == 0 || equals == std::string::npos)
    throw UsageError("--set takes NAME=VALUE, such as --set water=155, not '" + text + "'");
  return {text.substr(0, equals), text.substr(equals + 1)};
}

void take_option(Arguments& arguments, const std::string& name, const std::string& value) {
  if (name == "--set") arguments.settings.push_back(setting(value));
  if (name == "--device") arguments.device = device_named(value);
  if (name == "--devices") {
    const LaneChoice lanes = lanes_named(value);
    arguments.device = lanes.stress;
    arguments.heat_device = lanes.thermal;
  }
  if (name == "--precision") arguments.precision = precision_named(value);
  if (name == "--threads") arguments.threads = whole_number(name, value);
  if (name == "--memory") arguments.memory = positive_number(name, value);
  if (name == "--elements") arguments.elements = whole_number(name, value);
  if (name == "--out") arguments.out = value;
  if (name == "--force") arguments.force = true;
  if (name == "--checkpoint-every") arguments.checkpoint_every = positive_number(name, value);
  if (name == "--to") arguments.to = value;
  if (name == "--confining") arguments.confining = positive_numbers(name, value);
  if (name == "--tolerance") {
    arguments.tolerance = numbers(name, value, 1)[0];
    if (!(arguments.tolerance >= 0)) throw UsageError("--tolerance takes a number of at least 0, not '" + value + "'");
  }
  if (name == "--line") arguments.line = numbers(name, value, 6);
  if (name == "--stage") arguments.stage = value;
  if (name == "--of") arguments.of = value;
  if (name == "--size") arguments.size = positive_number(name, value);
  if (name == "--strain") arguments.strain = positive_number(name, value);
}

}  // namespace

std::span<const Verb> verbs() {
  static const std::vector<Verb> all = {
      {"new", "NAME", 1, 1, {}, "writes NAME.lua, a commented deck to start from: a dam on rock"},
      {"run",
       "DECK",
       1,
       1,
       {"--set", "--device", "--devices", "--precision", "--threads", "--memory", "--out", "--checkpoint-every", "--force"},
       "solves a deck and writes its results"},
      {"resume",
       "RUN",
       1,
       1,
       {"--device", "--devices", "--threads", "--memory", "--checkpoint-every"},
       "goes on with a run that was stopped or killed, from its last checkpoint, to the same results"},
      {"check", "DECK", 1, 1, {"--set", "--to", "--force"},
       "reads a deck and shows mesh, contacts and plan without solving; with --to NAME.vtu it also writes all "
       "interfaces"},
      {"export",
       "DECK",
       1,
       1,
       {"--to", "--set", "--force"},
       "writes the mesh for another program, for .inp with loads"},
      {"material",
       "DECK NAME",
       2,
       2,
       {"--set", "--confining", "--size", "--strain", "--to", "--force"},
       "drives one point of a material through the tests of a laboratory and shows the curves"},
      {"plot",
       "RUN [--of FIELD ...]",
       0,
       0,
       {},
       "makes pictures of a run; 'ashlar plot --help' lists what it can draw"},
      {"info", "[RUN]", 0, 1, {}, "the summary of a finished run; without RUN: this program and this machine"},
      {"compare",
       "A B",
       2,
       2,
       {"--tolerance", "--line", "--stage", "--of"},
       "how far two runs (folders or result files) of one mesh are apart, field by field and stage by stage"},
      {"bench", "[WORK]", 0, 1, {"--device", "--threads", "--elements", "--out"}, "measures element-steps per second: elastic, crackable, heat; all of them unless one is named"},
      {"help", "[WORD]", 0, 1, {}, "this page, a noun of the deck language with its keys, any other word of it, or the options of a command"},
      {"version", "", 0, 0, {}, "the version"},
  };
  return all;
}

Arguments parse_arguments(const std::vector<std::string>& words) {
  Arguments arguments;
  if (words.empty() || words[0] == "-h" || words[0] == "--help") {
    arguments.verb = "help";
    return arguments;
  }
  const Verb& verb = verb_named(words[0] == "--version" ? "version" : words[0]);
  arguments.verb = verb.name;
  if (verb.name == "plot") {
    arguments.passed.assign(words.begin() + 1, words.end());
    return arguments;
  }
  std::set<std::string> taken;
  for (std::size_t i = 1; i < words.size(); ++i) {
    std::string name = words[i];
    if (name.size() < 2 || name[0] != '-') {
      arguments.operands.push_back(name);
      continue;
    }
    const auto equals = name.find('=');
    const bool joined = equals != std::string::npos;
    const std::string after = joined ? name.substr(equals + 1) : "";
    name = name.substr(0, equals);
    if (std::find(verb.options.begin(), verb.options.end(), name) == verb.options.end())
      throw UsageError("'" + verb.name + "' has no option '" + name + "'" + suggest_name(name, verb.options));
    taken.insert(name);
    const Option& option = *std::find_if(options().begin(), options().end(), [&](auto& o) { return o.name == name; });
    if (option.value.empty()) {
      if (joined) throw UsageError(name + " takes no value");
      take_option(arguments, name, "");
    } else if (joined) {
      take_option(arguments, name, after);
    } else {
      if (i + 1 == words.size()) throw UsageError(name + " needs a value: " + name + " " + option.value);
      take_option(arguments, name, words[++i]);
    }
  }
  if (taken.contains("--device") && taken.contains("--devices"))
    throw UsageError("give either --device or --devices");
  const int given = static_cast<int>(arguments.operands.size());
  if (given < verb.fewest_operands || given > verb.most_operands)
    throw UsageError("usage: ashlar " + verb.name + (verb.operands.empty() ? "" : " " + verb.operands) +
                     (verb.options.empty() ? "" : " [options]") + ", see 'ashlar help'");
  return arguments;
}

std::string usage_of(const std::string& name) {
  for (const Verb& verb : verbs()) {
    if (verb.name != name) continue;
    std::string page = "usage: ashlar " + verb.name + (verb.operands.empty() ? "" : " " + verb.operands) +
                       (verb.options.empty() ? "" : " [options]") + "\n\n" + verb.doc + "\n\n";
    for (const Option& option : options())
      if (std::find(verb.options.begin(), verb.options.end(), option.name) != verb.options.end())
        page += option_line(option);
    return page;
  }
  return "";
}

std::string usage_page() {
  std::string page = "usage: ashlar COMMAND [operands] [options]\n\n";
  for (const Verb& verb : verbs())
    page += "  " + column(verb.name + (verb.operands.empty() ? "" : " " + verb.operands)) + verb.doc + "\n";
  page += "\noptions; 'ashlar help COMMAND' shows those of a command\n";
  for (const Option& option : options()) page += option_line(option);
  page +=
      "\nexit codes: 0 done, 1 error in the program, 2 wrong deck or command, 3 not converged, 4 an expect failed,\n"
      "            5 memory, disk or device missing, 130 interrupted\n";
  return page;
}

}  // namespace ashlar
