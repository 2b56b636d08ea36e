// Reading and writing of .pvd files.
#include "coupling/output/pvd_collection.h"

#include <unistd.h>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "coupling/output/quiet_vtk.h"

namespace swellflow {

namespace {

namespace fs = std::filesystem;

std::vector<PvdEntry> read_entries(const fs::path &file)
{
  const QuietVtk quiet;
  const auto root = vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromFile(file.c_str()));
  vtkXMLDataElement *collection = root ? root->FindNestedElementWithName("Collection") : nullptr;
  if (!collection)
    throw std::runtime_error("'" + file.string() + "' must be a ParaView collection but cannot be read: remove it or name another folder");
  std::vector<PvdEntry> entries;
  for (int i = 0; i < collection->GetNumberOfNestedElements(); ++i) {
    vtkXMLDataElement *element = collection->GetNestedElement(i);
    PvdEntry entry{0.0, 0, "", ""};
    const char *name = element->GetAttribute("name"), *path = element->GetAttribute("file");
    if (!path || !element->GetScalarAttribute("timestep", entry.time)) continue;
    element->GetScalarAttribute("part", entry.part);
    entry.name = name ? name : "";
    entry.file = path;
    entries.push_back(entry);
  }
  return entries;
}

void write_to_disk(const fs::path &file, const std::string &text)
{
  FILE *out = std::fopen(file.c_str(), "w");
  bool good = out != nullptr;
  if (out) {
    good = std::fwrite(text.data(), 1, text.size(), out) == text.size();
    good = std::fflush(out) == 0 && fsync(fileno(out)) == 0 && good;
    good = std::fclose(out) == 0 && good;
  }
  if (!good) throw std::runtime_error("cannot write '" + file.string() + "': free disk space or check the rights of the folder");
}

}  // namespace

PvdCollection::PvdCollection(fs::path file, double now) : file_(std::move(file))
{
  if (!fs::exists(file_)) return;
  const double round_off = 1e-12 * std::abs(now);
  for (const PvdEntry &entry : read_entries(file_))
    if (entry.time < now - round_off) entries_.push_back(entry);
}

void PvdCollection::add(const PvdEntry &entry)
{
  // After reset_timestep a step number, and with it a file name, may come again.
  std::erase_if(entries_, [&](const PvdEntry &old) { return old.file == entry.file; });
  entries_.push_back(entry);
}

void PvdCollection::write() const
{
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n  <Collection>\n";
  for (const PvdEntry &entry : entries_) {
    char time[40];
    std::snprintf(time, sizeof time, "%.15g", entry.time);
    text += std::string("    <DataSet timestep=\"") + time + "\" group=\"\" part=\"" + std::to_string(entry.part) + "\" name=\"" +
            entry.name + "\" file=\"" + entry.file + "\"/>\n";
  }
  text += "  </Collection>\n</VTKFile>\n";
  const fs::path fresh = file_.string() + ".new";
  write_to_disk(fresh, text);
  fs::rename(fresh, file_);
}

}  // namespace swellflow
