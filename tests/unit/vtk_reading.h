// Shared by the tests of the VTK output: a scratch folder on all ranks, and VTK's own readers.
#pragma once

#include <gtest/gtest.h>
#include <mpi.h>
#include <unistd.h>
#include <vtkDataArray.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkNew.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace fs = std::filesystem;

inline int rank_of_world()
{
  int rank;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}

inline int size_of_world()
{
  int size;
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  return size;
}

/// An empty folder, the same on all ranks, gone at the end.
class Folder {
public:
  Folder()
  {
    char name[64] = {};
    if (rank_of_world() == 0) {
      std::snprintf(name, sizeof name, "swellflow_test_%d", static_cast<int>(getpid()));
      fs::remove_all(fs::temp_directory_path() / name);
      fs::create_directories(fs::temp_directory_path() / name);
    }
    MPI_Bcast(name, sizeof name, MPI_CHAR, 0, MPI_COMM_WORLD);
    path = fs::temp_directory_path() / name;
  }
  ~Folder()
  {
    MPI_Barrier(MPI_COMM_WORLD);
    if (rank_of_world() == 0) fs::remove_all(path);
    MPI_Barrier(MPI_COMM_WORLD);
  }
  fs::path path;
};

template <typename SerialReader, typename ParallelReader, typename Use>
void read_back(const fs::path &file, const Use &use)
{
  const auto read = [&](auto &reader) {
    reader->SetFileName(file.c_str());
    reader->Update();
    ASSERT_EQ(reader->GetErrorCode(), 0u) << file;
    use(reader->GetOutput());
  };
  if (size_of_world() == 1) {
    vtkNew<SerialReader> reader;
    read(reader);
  } else {
    vtkNew<ParallelReader> reader;
    read(reader);
  }
}

inline std::string text_of(const fs::path &file)
{
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

inline std::string unit_of(vtkDataArray *array)
{
  const char *unit = array->GetInformation()->Get(vtkDataArray::UNITS_LABEL());
  return unit ? unit : "";
}
