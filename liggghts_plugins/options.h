// How a command or fix states its options: each is declared once, with name, unit, range and words; the rest is done here.
#pragma once

#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace LAMMPS_NS {
class LAMMPS;
class Fix;
}

namespace swellflow {

/// A user's mistake: rule, offending value, place and remedy in one sentence.
struct OptionError : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// Squares and products of numbers within these bounds are numbers, too.
inline constexpr double largest_number = 1e100, smallest_number = 1e-100;

/// The values that an option may take; open bounds exclude the bound itself.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false, high_open = false;

  bool holds(double value) const;  ///< and no larger than largest_number; what must be > 0 is no smaller than smallest_number, either
  std::string words() const;  ///< "> 0", ">= 3", "in (0, 1]"

  static Range any() { return {}; }
  static Range positive() { return {.low = 0.0, .low_open = true}; }
  static Range not_negative() { return {.low = 0.0}; }
  static Range at_least(double bound) { return {.low = bound}; }
  static Range above_to(double low, double high) { return {.low = low, .high = high, .low_open = true}; }
};

/// The arguments of one line, read from left to right. Every reader throws OptionError when it cannot be served.
class Arguments {
public:
  Arguments(std::string place, int narg, char **arg);
  Arguments(std::string place, std::vector<std::string> words);

  bool empty() const { return next_ == words_.size(); }
  bool next_is_number() const;
  const std::string &peek() const { return words_[next_]; }
  std::string word(const std::string &what);
  double number(const std::string &what, const Range &range = Range::any(), const std::string &unit = "");
  int integer(const std::string &what, const Range &range = Range::any());
  bool yes_no(const std::string &what);
  /// The position of the next word among `choices`.
  int choice(const std::string &what, const std::vector<std::string> &choices);
  /// Takes a word that must stand here.
  void expect(const std::string &word);
  const std::string &place() const { return place_; }
  [[noreturn]] void fail(const std::string &message) const;  ///< adds the place

private:
  std::string place_;
  std::vector<std::string> words_;
  std::size_t next_ = 0;
};

/// The keywords of one style. Variables keep the value that they have when their keyword is not given.
class Options {
public:
  explicit Options(std::string place) : place_(std::move(place)) {}

  Options &number(const std::string &name, double &value, const Range &range, const std::string &unit, const std::string &words);
  Options &integer(const std::string &name, int &value, const Range &range, const std::string &words);
  Options &yes_no(const std::string &name, bool &value, const std::string &words);
  Options &text(const std::string &name, std::string &value, const std::string &words);
  Options &choice(const std::string &name, int &value, const std::vector<std::string> &choices, const std::string &words);
  /// A keyword without arguments.
  Options &flag(const std::string &name, bool &value, const std::string &words);
  /// All words up to the next keyword, at least one; `allowed` empty: any word.
  Options &list(const std::string &name, std::vector<std::string> &values, const std::vector<std::string> &allowed,
                const std::string &words);
  /// Anything else: `read` takes what belongs to the keyword.
  Options &custom(const std::string &name, const std::function<void(Arguments &)> &read, const std::string &words);

  Options &required();    ///< the option declared last must be given
  Options &repeatable();  ///< the option declared last may be given more than once

  void parse(Arguments &arguments);             ///< all that is left of the line
  bool given(const std::string &name) const;    ///< after parse
  std::string summary() const;                  ///< "name (range, unit): words", one line an option

private:
  struct Option {
    std::string name, range, words;
    std::function<void(Arguments &)> read;
    bool required = false, repeatable = false, given = false;
  };
  Options &add(const std::string &name, const std::string &range, const std::string &words,
               const std::function<void(Arguments &)> &read);
  const Option *find(const std::string &name) const;
  std::string names() const;

  std::string place_;
  std::vector<Option> options_;
};

/// What a message adds to the rule that a number broke by its magnitude alone; else nothing.
std::string magnitude_words(double value);
/// A number as a message shows it: as short as it is exact enough.
std::string shown(double value);
/// A computed number, to four digits.
std::string rounded(double value);

/// Runs `work`; an OptionError (or any std::invalid_argument) ends the run as a LIGGGHTS error. Every rank must reach it.
void or_stop(LAMMPS_NS::LAMMPS *lmp, const std::function<void()> &work);

}  // namespace swellflow
