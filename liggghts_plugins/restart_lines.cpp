// They are private. Access is not checked in an explicit instantiation ([temp.spec.general]), so their addresses may be template arguments there.
#include "restart_lines.h"

#include "output.h"

namespace LAMMPS_NS {

namespace {

struct NextRestart {};
struct EverySingle {};
struct EveryDouble {};
struct NameSingle {};
struct NameFirst {};
struct NameSecond {};

bigint &member_of(Output &, NextRestart);
int &member_of(Output &, EverySingle);
int &member_of(Output &, EveryDouble);
char *&member_of(Output &, NameSingle);
char *&member_of(Output &, NameFirst);
char *&member_of(Output &, NameSecond);

template <typename Tag, typename T, T Output::*Member>
struct Access {
  friend T &member_of(Output &output, Tag) { return output.*Member; }
};
template struct Access<NextRestart, bigint, &Output::next_restart>;
template struct Access<EverySingle, int, &Output::restart_every_single>;
template struct Access<EveryDouble, int, &Output::restart_every_double>;
template struct Access<NameSingle, char *, &Output::restart1>;
template struct Access<NameFirst, char *, &Output::restart2a>;
template struct Access<NameSecond, char *, &Output::restart2b>;

}  // namespace

std::vector<RestartLine> restart_lines(Output &output)
{
  std::vector<RestartLine> lines;
  if (member_of(output, NameSingle{})) lines.push_back({member_of(output, EverySingle{}), {&member_of(output, NameSingle{})}});
  if (member_of(output, NameFirst{})) lines.push_back({member_of(output, EveryDouble{}), {&member_of(output, NameFirst{}), &member_of(output, NameSecond{})}});
  return lines;
}

bigint next_restart(Output &output) { return member_of(output, NextRestart{}); }

}  // namespace LAMMPS_NS
