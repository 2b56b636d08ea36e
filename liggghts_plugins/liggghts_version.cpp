#include "liggghts_version.h"

#include <cstring>
#include <stdexcept>
#include <string>

#include "universe.h"

using LAMMPS_NS::Universe;

namespace swellflow {

namespace {

/// Where its version has this word LIGGGHTS adds a joke to every fifth error, read from memory that it has freed by then.
constexpr char jokes[] = "PUBLIC", no_jokes[] = "Public";

void replace(char *text, const char *word, const char *by)
{
  if (char *at = std::strstr(text, word)) std::memcpy(at, by, std::strlen(by));
}

}  // namespace

void check_version(const Universe &universe)
{
  if (!std::strstr(universe.version, supported_liggghts))
    throw std::runtime_error(std::string("LIGGGHTS must be version ") + supported_liggghts + " but calls itself '" +
                             universe.version + "': install Debian's libliggghts3 " + supported_liggghts);
}

void mark_version(Universe &universe)
{
  replace(universe.version, jokes, no_jokes);
  if (!std::strstr(universe.version, version_mark)) std::strcat(universe.version, version_mark);  // LIGGGHTS left room behind its text
}

void unmark_version(Universe &universe)
{
  replace(universe.version, no_jokes, jokes);
  if (char *mark = std::strstr(universe.version, version_mark)) *mark = '\0';
}

}  // namespace swellflow
