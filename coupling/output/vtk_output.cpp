// One frame, from LIGGGHTS and the fluid to files, and the collections that list them.
#include "coupling/output/vtk_output.h"

#include <map>
#include <stdexcept>

#include "liggghts_plugins/collective.h"
#include "coupling/output/frame_data.h"
#include "coupling/output/frame_files.h"
#include "coupling/output/pvd_collection.h"
#include "lammps.h"

namespace swellflow {

namespace {

namespace fs = std::filesystem;

/// Fails now rather than after hours, when the first frame is due.
void prepare_folder(const fs::path &folder)
{
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (!fs::is_directory(folder))
    throw std::runtime_error("cannot create folder '" + folder.string() + "' (" + failure.message() +
                             "): name another with the keyword folder");
  const fs::path probe = folder / ".writable";
  FILE *file = std::fopen(probe.c_str(), "w");
  if (!file)
    throw std::runtime_error("cannot write into folder '" + folder.string() + "': change its rights or name another with the keyword folder");
  std::fclose(file);
  fs::remove(probe);
}

class VtkOutput : public OutputPartner {
public:
  VtkOutput(void *lammps, const OutputOptions &options)
      : lammps_(lammps), comm_(static_cast<LAMMPS_NS::LAMMPS *>(lammps)->world), options_(options), folder_(options.folder),
        units_(unit_names(options.units))
  {
    MPI_Comm_rank(comm_, &rank_);
    on_rank_0(comm_, [&] { prepare_folder(folder_); });
  }

  void write(const OutputFrame &frame) override
  {
    if (collections_.empty()) open_collections(frame.own_from);
    const FrameTime when{frame.step, frame.time};
    std::map<std::string, std::string> files;
    if (has_fields()) files["fields"] = write_fields(frame, when);
    write_objects(frame, when, files);
    on_rank_0(comm_, [&] { list(files, frame.time); });
  }

private:
  static constexpr const char *all_sets = "all";

  bool has_fields() const { return !options_.fields.empty(); }

  /// In the order in which all.pvd numbers them as parts.
  std::vector<std::string> sets() const
  {
    std::vector<std::string> names;
    if (has_fields()) names.push_back("fields");
    if (options_.outline) names.push_back("outline");
    if (options_.points) names.push_back("points");
    if (options_.cds) names.push_back("cds");
    if (options_.centres) names.push_back("centres");
    return names;
  }

  /// Written at once: frames that are about to be overwritten are no longer listed from here on.
  void open_collections(double own_from)
  {
    auto names = sets();
    names.push_back(all_sets);
    for (const std::string &name : names) {
      on_rank_0(comm_, [&] {
        PvdCollection collection(folder_ / (name + ".pvd"), own_from);
        collection.write();
        collections_.emplace(name, collection);
      });
      if (rank_ != 0) collections_.emplace(name, PvdCollection("", own_from));
    }
  }

  std::string write_fields(const OutputFrame &frame, FrameTime when)
  {
    vtkSmartPointer<vtkImageData> image;
    all_or_none(comm_, [&] { image = field_data(*frame.fluid, options_.fields, when); });
    return write_image_data(comm_, {folder_, "fields", frame.step}, image, frame.fluid->field_block().global_cells);
  }

  void write_objects(const OutputFrame &frame, FrameTime when, std::map<std::string, std::string> &files)
  {
    std::vector<ObjectState> objects;
    all_or_none(comm_, [&] { objects = object_states(lammps_, frame); });
    const auto write_data = [&](const char *set, vtkPolyData *data) { files[set] = write_poly_data(comm_, {folder_, set, frame.step}, data); };
    const auto write_set = [&](const char *set, auto data_of) { write_data(set, data_of(objects, units_, when)); };
    if (options_.outline) write_set("outline", outline_data);
    if (options_.points) write_set("points", point_data);
    if (options_.cds) write_set("cds", cds_data);
    if (options_.centres) write_data("centres", centre_data(frame.measures, units_, when));
  }

  /// Only now, with all files complete on all ranks, does the frame exist for a reader.
  void list(const std::map<std::string, std::string> &files, double time)
  {
    int part = 0;
    for (const std::string &set : sets()) {
      collections_.at(set).add({time, 0, set, files.at(set)});
      collections_.at(set).write();
      collections_.at(all_sets).add({time, part++, set, files.at(set)});
    }
    collections_.at(all_sets).write();
  }

  void *lammps_;
  MPI_Comm comm_;
  int rank_ = 0;
  OutputOptions options_;
  fs::path folder_;
  UnitNames units_;
  std::map<std::string, PvdCollection> collections_;
};

}  // namespace

std::unique_ptr<OutputPartner> make_vtk_output(void *lammps, const OutputOptions &options)
{
  return std::make_unique<VtkOutput>(lammps, options);
}

}  // namespace swellflow
