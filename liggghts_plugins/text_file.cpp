#include "text_file.h"

#include <fstream>
#include <vector>

#include "comm.h"
#include "lammps.h"
#include "options.h"

namespace {

constexpr std::size_t most = 1000000000;  ///< bytes; some names stand for what has no end

}  // namespace

std::string LAMMPS_NS::text_of_file(LAMMPS *lmp, const std::string &place, const std::string &name)
{
  std::string text;
  int size = -1;
  if (lmp->comm->me == 0) {
    std::ifstream file(name, std::ios::binary);
    std::vector<char> part(1 << 20);
    while (text.size() <= most && file && (file.read(part.data(), part.size()), file.gcount() > 0)) text.append(part.data(), file.gcount());
    if (!text.empty()) size = static_cast<int>(text.size());
  }
  MPI_Bcast(&size, 1, MPI_INT, 0, lmp->world);
  if (size > static_cast<int>(most)) throw swellflow::OptionError(place + ": the file must have at most 1 GB, but '" + name + "' has more: correct the name");
  if (size < 0) throw swellflow::OptionError(place + ": the file must be readable and not empty, but '" + name + "' is not: correct the name");
  text.resize(size);
  MPI_Bcast(text.data(), size, MPI_CHAR, 0, lmp->world);
  return text;
}
