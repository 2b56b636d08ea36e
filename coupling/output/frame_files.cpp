// Pieces go through VTK's writers. The header is a few lines of XML and written here: VTK's own parallel writers want a
// pipeline and a second MPI layer for it.
#include "coupling/output/frame_files.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLPolyDataWriter.h>

#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "liggghts_plugins/collective.h"
#include "coupling/output/quiet_vtk.h"

namespace swellflow {

namespace {

namespace fs = std::filesystem;

struct Ranks {
  int rank, size;
  explicit Ranks(MPI_Comm comm)
  {
    MPI_Comm_rank(comm, &rank);
    MPI_Comm_size(comm, &size);
  }
};

std::string stem(const FrameName &name)
{
  char digits[24];
  std::snprintf(digits, sizeof digits, "%010ld", name.step);
  return name.set + "_" + digits;
}

std::string piece_name(const FrameName &name, int rank, const std::string &extension)
{
  char suffix[16];
  std::snprintf(suffix, sizeof suffix, "_r%04d", rank);
  return stem(name) + suffix + extension;
}

template <typename Writer>
void write_piece(const fs::path &file, vtkDataObject *data)
{
  const QuietVtk quiet;
  vtkNew<Writer> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputData(data);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();  // raw binary: base64 would add a third
  writer->SetCompressorTypeToZLib();
  writer->SetHeaderTypeToUInt64();
  if (writer->Write() != 1 || writer->GetErrorCode() != 0 || !fs::exists(file))
    throw std::runtime_error("cannot write '" + file.string() + "': free disk space or check the rights of the folder");
}

std::string array_list(vtkDataSetAttributes *attributes, const char *element)
{
  std::ostringstream xml;
  xml << "    <" << element << ">\n";
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i) {
    vtkDataArray *array = attributes->GetArray(i);
    const char *type = array->GetDataType() == VTK_DOUBLE ? "Float64" : "Int32";
    xml << "      <PDataArray type=\"" << type << "\" Name=\"" << array->GetName() << "\" NumberOfComponents=\""
        << array->GetNumberOfComponents() << "\"/>\n";
  }
  xml << "    </" << element << ">\n";
  return xml.str();
}

void write_header(const fs::path &file, const std::string &type, const std::string &attributes, const std::string &content)
{
  std::ofstream out(file);
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"" << type << "\" version=\"1.0\" byte_order=\"LittleEndian\" "
      << "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n  <" << type << attributes << " GhostLevel=\"0\">\n"
      << content << "  </" << type << ">\n</VTKFile>\n";
  out.close();
  if (!out) throw std::runtime_error("cannot write '" + file.string() + "': free disk space or check the rights of the folder");
}

std::vector<int> gather(MPI_Comm comm, const std::vector<int> &mine)
{
  const int n = static_cast<int>(mine.size());
  std::vector<int> all(mine.size() * Ranks(comm).size);
  MPI_Gather(mine.data(), n, MPI_INT, all.data(), n, MPI_INT, 0, comm);
  return all;
}

std::string numbers(const int *first, int count)
{
  std::ostringstream text;
  for (int i = 0; i < count; ++i) text << (i ? " " : "") << first[i];
  return text.str();
}

std::string triple(const double *v)
{
  std::ostringstream text;
  text.precision(17);
  text << v[0] << ' ' << v[1] << ' ' << v[2];
  return text.str();
}

/// A rank without objects or cells writes nothing, but the header needs one piece to know the arrays from.
bool has_piece(int rank, vtkDataSet *piece) { return piece->GetNumberOfPoints() > 0 || rank == 0; }

}  // namespace

std::string write_poly_data(MPI_Comm comm, const FrameName &name, vtkPolyData *piece)
{
  const Ranks ranks(comm);
  const std::string file = stem(name) + (ranks.size == 1 ? ".vtp" : ".pvtp");
  const auto piece_file = [&](int rank) { return ranks.size == 1 ? file : piece_name(name, rank, ".vtp"); };
  const bool written = has_piece(ranks.rank, piece);
  all_or_none(comm, [&] {
    if (written) write_piece<vtkXMLPolyDataWriter>(name.folder / piece_file(ranks.rank), piece);
  });
  if (ranks.size == 1) return file;

  const auto pieces = gather(comm, {written});
  on_rank_0(comm, [&] {
    std::string content = array_list(piece->GetPointData(), "PPointData") + array_list(piece->GetCellData(), "PCellData") +
                          "    <PPoints><PDataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"/></PPoints>\n";
    for (int r = 0; r < ranks.size; ++r)
      if (pieces[r]) content += "    <Piece Source=\"" + piece_file(r) + "\"/>\n";
    write_header(name.folder / file, "PPolyData", "", content);
  });
  return file;
}

std::string write_image_data(MPI_Comm comm, const FrameName &name, vtkImageData *piece, const std::array<int, 3> &whole)
{
  const Ranks ranks(comm);
  const std::string file = stem(name) + (ranks.size == 1 ? ".vti" : ".pvti");
  const auto piece_file = [&](int rank) { return ranks.size == 1 ? file : piece_name(name, rank, ".vti"); };
  const bool written = piece->GetNumberOfCells() > 0;
  all_or_none(comm, [&] {
    if (written) write_piece<vtkXMLImageDataWriter>(name.folder / piece_file(ranks.rank), piece);
  });
  if (ranks.size == 1) return file;

  std::vector<int> extent(6);
  piece->GetExtent(extent.data());
  extent.push_back(written);
  const auto extents = gather(comm, extent);
  on_rank_0(comm, [&] {
    const int whole_extent[6] = {0, whole[0], 0, whole[1], 0, whole[2] <= 1 ? 0 : whole[2]};
    std::string content = array_list(piece->GetCellData(), "PCellData");
    for (int r = 0; r < ranks.size; ++r)
      if (extents[7 * r + 6])
        content += "    <Piece Extent=\"" + numbers(&extents[7 * r], 6) + "\" Source=\"" + piece_file(r) + "\"/>\n";
    write_header(name.folder / file, "PImageData",
                 " WholeExtent=\"" + numbers(whole_extent, 6) + "\" Origin=\"" + triple(piece->GetOrigin()) + "\" Spacing=\"" +
                     triple(piece->GetSpacing()) + "\"",
                 content);
  });
  return file;
}

}  // namespace swellflow
