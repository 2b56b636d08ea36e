// A data set of one frame on disk: one file on one rank; on several, a piece a rank and a header that lists them.
#pragma once

#include <mpi.h>
#include <vtkImageData.h>
#include <vtkPolyData.h>

#include <array>
#include <filesystem>
#include <string>

namespace swellflow {

struct FrameName {
  std::filesystem::path folder;
  std::string set;  ///< "fields", "outline", "points", "cds" or "centres"
  long step;
};

/// Both are collective, give the name (within the folder) of the file that ParaView is to open, and throw
/// std::runtime_error on every rank if a rank could not write.
std::string write_poly_data(MPI_Comm comm, const FrameName &name, vtkPolyData *piece);
/// `whole`: cells of the whole grid per direction.
std::string write_image_data(MPI_Comm comm, const FrameName &name, vtkImageData *piece, const std::array<int, 3> &whole);

}  // namespace swellflow
