#pragma once
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "backend/device.hpp"

namespace ashlar {

/// What was typed makes no sense; the message says what would. Exit code 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The command line after the program's name.
struct Arguments {
  std::string verb;
  std::vector<std::string> operands;                          ///< words that are no options
  std::vector<std::pair<std::string, std::string>> settings;  ///< --set name=value, in order
  int threads = 0;                                            ///< --threads; 0: all cores
  DeviceChoice device;                                        ///< --device; automatic unless given; stress of --devices
  std::optional<DeviceChoice> heat_device;                    ///< thermal of --devices
  Precision precision = Precision::double_precision;          ///< --precision
  double memory = 0;                                          ///< --memory, GB; 0: what is free
  int elements = 0;                                           ///< --elements; 0: the usual sizes
  std::string out;                                            ///< --out
  bool force = false;                                         ///< --force
  double checkpoint_every = 10;                               ///< --checkpoint-every, minutes
  std::string to;                                             ///< --to
  std::vector<double> confining{1, 5};                        ///< --confining, MPa
  double size = 0.5;                                          ///< --size, m
  double strain = 0;                                          ///< --strain; 0: as far as flow needs
  double tolerance = -1;                                      ///< --tolerance; negative: none
  std::vector<double> line;                                   ///< --line: start and end, m; empty: none
  std::string stage, of;                                      ///< --stage, --of
  std::vector<std::string> passed;  ///< plot: everything after the verb, for the plotting program
};

/// Throws UsageError: unknown verb or option (with the nearest one), missing or bad value, too few or too many
/// operands.
Arguments parse_arguments(const std::vector<std::string>& words);

/// One verb of the program.
struct Verb {
  std::string name;
  std::string operands;  ///< as usage lines show them: "DECK", "[NOUN]"
  int fewest_operands = 0, most_operands = 0;
  std::vector<std::string> options;  ///< names of those that the verb takes
  std::string doc;
};
std::span<const Verb> verbs();

/// The page that `ashlar help` prints above the nouns.
std::string usage_page();
/// What one command does, with its options; empty if there is no such command.
std::string usage_of(const std::string& verb);

}  // namespace ashlar
