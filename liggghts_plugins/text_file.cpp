#include "text_file.h"

#include <fstream>
#include <sstream>

#include "comm.h"
#include "lammps.h"
#include "options.h"

std::string LAMMPS_NS::text_of_file(LAMMPS *lmp, const std::string &place, const std::string &name)
{
  std::string text;
  int size = -1;
  if (lmp->comm->me == 0) {
    std::ifstream file(name);
    std::ostringstream contents;
    if (file && contents << file.rdbuf()) {
      text = contents.str();
      size = static_cast<int>(text.size());
    }
  }
  MPI_Bcast(&size, 1, MPI_INT, 0, lmp->world);
  if (size < 0) throw swellflow::OptionError(place + ": the file must be readable and not empty, but '" + name + "' is not: correct the name");
  text.resize(size);
  MPI_Bcast(text.data(), size, MPI_CHAR, 0, lmp->world);
  return text;
}
