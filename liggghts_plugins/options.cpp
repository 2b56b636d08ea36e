// Reading of options: the one place where a keyword or a number can be wrong.
#include "options.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "error.h"
#include "lammps.h"

namespace swellflow {

std::string shown(double value)
{
  char text[32];
  for (int digits = 6; digits <= 17; ++digits) {
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    if (std::strtod(text, nullptr) == value) break;
  }
  return text;
}

std::string rounded(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

bool Range::holds(double value) const
{
  const bool above = low_open ? value > low : value >= low;
  const bool below = high_open ? value < high : value <= high;
  const bool large_enough = !(low_open && low == 0.0) || value >= smallest_number;
  return above && below && large_enough && std::abs(value) <= largest_number;
}

std::string magnitude_words(double value)
{
  const double magnitude = std::abs(value);
  const bool usual = magnitude == 0.0 || (magnitude >= smallest_number && magnitude <= largest_number);
  return usual || !std::isfinite(value) ? "" : " and of a magnitude from 1e-100 to 1e100";
}

std::string Range::words() const
{
  const bool has_low = std::isfinite(low), has_high = std::isfinite(high);
  if (has_low && has_high)
    return std::string("in ") + (low_open ? "(" : "[") + shown(low) + ", " + shown(high) + (high_open ? ")" : "]");
  if (has_low) return (low_open ? "> " : ">= ") + shown(low);
  if (has_high) return (high_open ? "< " : "<= ") + shown(high);
  return "";
}

namespace {

std::string number_words(const char *kind, const Range &range, const std::string &unit)
{
  std::string words = kind;
  if (!range.words().empty()) words.append(" ").append(range.words());
  if (!unit.empty()) words.append(" (").append(unit).append(")");
  return words;
}

/// The whole word as a number, or false.
bool to_number(const std::string &word, double &value)
{
  if (word.empty()) return false;
  char *end = nullptr;
  value = std::strtod(word.c_str(), &end);
  return *end == '\0';
}

std::string joined(const std::vector<std::string> &words, const char *separator)
{
  std::string text;
  for (const std::string &word : words) text += (text.empty() ? "" : separator) + word;
  return text;
}

}  // namespace

Arguments::Arguments(std::string place, int narg, char **arg) : place_(std::move(place)), words_(arg, arg + narg) {}

Arguments::Arguments(std::string place, std::vector<std::string> words) : place_(std::move(place)), words_(std::move(words)) {}

void Arguments::fail(const std::string &message) const { throw OptionError(place_ + ": " + message); }

bool Arguments::next_is_number() const
{
  double value;
  return !empty() && to_number(peek(), value);
}

std::string Arguments::word(const std::string &what)
{
  if (empty()) fail("not enough arguments for '" + what + "': add what belongs to it");
  return words_[next_++];
}

double Arguments::number(const std::string &what, const Range &range, const std::string &unit)
{
  const std::string wanted = number_words("a number", range, unit);
  if (empty()) fail("not enough arguments for '" + what + "': give " + wanted);
  double value = 0.0;
  const std::string given = words_[next_++];
  if (!to_number(given, value) || !range.holds(value))
    fail("'" + what + "' must be " + wanted + magnitude_words(value) + ", but is '" + given + "': change it");
  return value;
}

int Arguments::integer(const std::string &what, const Range &range)
{
  const std::string wanted = number_words("a whole number", range, "");
  if (empty()) fail("not enough arguments for '" + what + "': give " + wanted);
  double value;
  const std::string given = words_[next_++];
  const bool fits = to_number(given, value) && range.holds(value) && std::abs(value) < 2147483648.0;
  if (!fits || value != std::floor(value)) fail("'" + what + "' must be " + wanted + ", but is '" + given + "': change it");
  return static_cast<int>(value);
}

bool Arguments::yes_no(const std::string &what) { return choice(what, {"yes", "no"}) == 0; }

int Arguments::choice(const std::string &what, const std::vector<std::string> &choices)
{
  const std::string wanted = joined(choices, " or ");
  if (empty()) fail("not enough arguments for '" + what + "': give " + wanted);
  const std::string given = words_[next_++];
  const auto found = std::find(choices.begin(), choices.end(), given);
  if (found == choices.end()) fail("'" + what + "' must be " + wanted + ", but is '" + given + "': change it");
  return static_cast<int>(found - choices.begin());
}

void Arguments::expect(const std::string &wanted)
{
  const std::string given = word(wanted);
  if (given != wanted) fail("here must stand '" + wanted + "', but there is '" + given + "': change it");
}

Options &Options::add(const std::string &name, const std::string &range, const std::string &words,
                      const std::function<void(Arguments &)> &read)
{
  options_.push_back({.name = name, .range = range, .words = words, .read = read});
  return *this;
}

Options &Options::number(const std::string &name, double &value, const Range &range, const std::string &unit,
                         const std::string &words)
{
  return add(name, number_words("number", range, unit), words,
             [&value, name, range, unit](Arguments &line) { value = line.number(name, range, unit); });
}

Options &Options::integer(const std::string &name, int &value, const Range &range, const std::string &words)
{
  return add(name, number_words("whole number", range, ""), words,
             [&value, name, range](Arguments &line) { value = line.integer(name, range); });
}

Options &Options::yes_no(const std::string &name, bool &value, const std::string &words)
{
  return add(name, "yes or no", words, [&value, name](Arguments &line) { value = line.yes_no(name); });
}

Options &Options::text(const std::string &name, std::string &value, const std::string &words)
{
  return add(name, "a word", words, [&value, name](Arguments &line) { value = line.word(name); });
}

Options &Options::choice(const std::string &name, int &value, const std::vector<std::string> &choices, const std::string &words)
{
  return add(name, joined(choices, " or "), words,
             [&value, name, choices](Arguments &line) { value = line.choice(name, choices); });
}

Options &Options::flag(const std::string &name, bool &value, const std::string &words)
{
  return add(name, "", words, [&value](Arguments &) { value = true; });
}

Options &Options::list(const std::string &name, std::vector<std::string> &values, const std::vector<std::string> &allowed,
                       const std::string &words)
{
  const std::string range = allowed.empty() ? "words" : "any of " + joined(allowed, ", ");
  return add(name, range, words, [this, &values, name, allowed](Arguments &line) {
    values.clear();
    while (!line.empty() && (values.empty() || !find(line.peek())))
      values.push_back(allowed.empty() ? line.word(name) : allowed[line.choice(name, allowed)]);
    if (values.empty()) line.word(name);
  });
}

Options &Options::custom(const std::string &name, const std::function<void(Arguments &)> &read, const std::string &words)
{
  return add(name, "", words, read);
}

Options &Options::required()
{
  options_.back().required = true;
  return *this;
}

Options &Options::repeatable()
{
  options_.back().repeatable = true;
  return *this;
}

const Options::Option *Options::find(const std::string &name) const
{
  const auto found = std::find_if(options_.begin(), options_.end(), [&](const Option &o) { return o.name == name; });
  return found == options_.end() ? nullptr : &*found;
}

std::string Options::names() const
{
  std::vector<std::string> all;
  for (const Option &option : options_) all.push_back(option.name);
  return joined(all, ", ");
}

void Options::parse(Arguments &arguments)
{
  while (!arguments.empty()) {
    const std::string name = arguments.word("keyword");
    auto *option = const_cast<Option *>(find(name));
    if (!option) {
      const std::string remedy = options_.empty() ? "there are none; remove it" : "known are " + names();
      arguments.fail("unknown keyword '" + name + "': " + remedy);
    }
    if (option->given && !option->repeatable) arguments.fail("keyword '" + name + "' is given twice: keep one of them");
    option->given = true;
    option->read(arguments);
  }
  for (const Option &option : options_)
    if (option.required && !option.given)
      arguments.fail("keyword '" + option.name + "' is missing: add '" + option.name + "' with " + option.range + (option.range.empty() ? "" : ", ") + option.words);
}

bool Options::given(const std::string &name) const
{
  const Option *option = find(name);
  return option && option->given;
}

std::string Options::summary() const
{
  std::string text;
  for (const Option &option : options_)
    text += option.name + (option.range.empty() ? "" : " (" + option.range + ")") + ": " + option.words + "\n";
  return text;
}

void or_stop(LAMMPS_NS::LAMMPS *lmp, const std::function<void()> &work)
{
  std::string message;
  try {
    work();
  } catch (const std::invalid_argument &problem) {
    message = problem.what();
  }
  if (!message.empty()) lmp->error->all(FLERR, message.c_str());
}

}  // namespace swellflow
