// What the user is told once, whatever the number of ranks.
#pragma once

#include <cstdio>
#include <string>

#include "comm.h"
#include "lammps.h"

namespace LAMMPS_NS {

/// A line on screen and in the log, by rank 0.
inline void say(LAMMPS *lmp, const std::string &line)
{
  if (lmp->comm->me != 0) return;
  for (FILE *out : {lmp->screen, lmp->logfile})
    if (out) std::fprintf(out, "%s\n", line.c_str());
}

}  // namespace LAMMPS_NS
