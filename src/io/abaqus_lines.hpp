#pragma once
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/scanner.hpp"

/// Lines of Abaqus input: keywords with parameters, and data between commas.
namespace ashlar::abaqus {

/// A piece of the file.
struct Field {
  std::string_view text;
  std::size_t position = 0;
};

std::string upper(std::string_view text);
/// As messages show it: quoted, short, printable.
std::string shown(std::string_view text);
/// Between commas; an empty last one (the line goes on) is left out.
std::vector<Field> split(const Field& line);

/// A keyword line: "*ELEMENT, TYPE=C3D8, ELSET=dam".
struct Card {
  std::string keyword;  ///< upper case
  std::size_t position = 0;
  std::map<std::string, Field> parameters;  ///< by upper-case name
};

/// Goes through the lines that are neither empty nor comments. Every failure is a DeckError with the line.
class Lines {
 public:
  explicit Lines(Scanner& scanner) : scanner_(scanner) {}

  std::optional<Field> peek();
  /// The next line unless it is a keyword's.
  std::optional<Field> data();
  void skip_data() {
    while (data()) {
    }
  }
  Card card();

  long integer(const Field& field, const char* expected) const;
  double real(const Field& field, const char* expected) const;
  /// Throws unless the card has it.
  const Field& parameter(const Card& card, const char* name) const;
  void refuse_parameters(const Card& card, std::initializer_list<const char*> names) const;

  Scanner& scanner() const { return scanner_; }

 private:
  Field take();

  Scanner& scanner_;
  std::size_t at_ = 0;
};

}  // namespace ashlar::abaqus
