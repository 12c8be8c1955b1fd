#include "script/function_docs.hpp"

namespace ashlar {

const std::vector<FunctionDoc>& function_docs() {
  static const std::vector<FunctionDoc> all = {
      {{"deck", "args", "default", "unit", "range", "doc"}, R"(  deck.args { size = { default = 4, unit = m, range = {1, 20}, doc = "element size" } }
      declares arguments and returns their values; ashlar run dam.lua --set size=2 changes one.
      Bare numbers are in the argument's unit. Defaults may be texts, true or false too.
)"},
      {{"deck", "read_table"}, R"(  deck.read_table "air.csv"     deck.read_table("air.csv", { time = days, temperature = degC })
      columns of numbers by the names in the first line: air.time[1], air.temperature[1]. Without names they are time,
      value, value_2, ... Numbers are SI (seconds) or in the units given by column.
      The file lies beside the file that names it, or below.
)"},
      {{"in_time"}, R"(  in_time { {0*days, -2*degC}, {180*days, 28*degC} }     in_time(function(t) return 10 + 8*math.sin(t/5e6) end)
      values that follow time, for every key that "may change in time"; straight lines between rows, constant before
      the first and after the last. Bare rows do too: ambient = { {0*days, 5*degC}, {30*days, 9*degC} }. So does a table
      read from a file with one column beside time; of more columns: in_time(air.time, air.temperature).
      Time is that of the run, in seconds: the durations of thermal, coupled and dynamic stages, one after the other. Other stages
      take no time: they see the values of the time reached. A function of t is sampled when the deck has been read;
      a function of position is written function(x, y, z), one of both function(x, y, z, t): it is sampled at so many
      times, when its stage begins, that straight lines between them are 1e-4 of the change off at most.
)"},
      {{"in_stage"}, R"(  in_stage { ... }   in_stage(function(t) ... end)
      the same, with time counted from the beginning of the stage where the condition first acts, as for a shaken base.
)"},
      {{"interpolate"}, R"(  interpolate(places, values, x)
      value at x of the polyline through the points; places ascend; constant beyond the ends.
)"},
      {{"pairs"}, R"(  pairs(t)
      visits keys in a fixed order: numbers, then texts, each ascending.
)"},
      {{"strict"}, R"(  strict(t, "what")
      t, which from then on answers a wrong key with the right ones.
)"},
      {{"require"}, R"(  require "seasons"
      runs seasons.lua beside the deck, once, and returns what it returns.
)"},
  };
  return all;
}

}  // namespace ashlar
