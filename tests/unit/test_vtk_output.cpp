// Fields are read back with VTK's own readers on any number of ranks; collections survive restarts; failures reach every rank.
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLPImageDataReader.h>

#include <cmath>

#include "liggghts_plugins/collective.h"
#include "coupling/output/frame_data.h"
#include "coupling/output/frame_files.h"
#include "coupling/output/pvd_collection.h"
#include "coupling/output/vtk_output.h"
#include "library.h"
#include "vtk_reading.h"

using namespace swellflow;

namespace {

/// A closed form in place of a fluid, cut into slabs across y; with more ranks than rows some ranks have no cells.
class ClosedFormFluid : public FluidPartner {
public:
  ClosedFormFluid(int nx, int ny) : nx_(nx), ny_(ny)
  {
    first_row_ = ny * rank_of_world() / size_of_world();
    rows_ = ny * (rank_of_world() + 1) / size_of_world() - first_row_;
  }
  static double pressure(int i, int j) { return 100.0 * i + j; }
  static Vec3 velocity(int i, int j) { return {0.1 * i, std::sin(j), 0.0}; }

  void complete_law(const std::vector<ObjectPoints> &, const FluidDrive &) override {}
  int choose_dem_steps(double, const FluidDrive &) override { return 1; }
  void begin_step(const std::vector<ObjectPoints> &, const FluidDrive &, int) override {}
  void finish_step(const std::vector<ObjectPoints> &) override {}
  FluidReport report() override { return {}; }
  double largest_speed() override { return 0.0; }
  FieldBlock field_block() const override { return {{nx_, ny_, 1}, {0, first_row_, 0}, {nx_, rows_, 1}, {-1.0, 2.0, 0.0}, 0.25}; }
  std::vector<FieldInfo> fields() const override { return {{"velocity", "m/s", 3}, {"pressure", "Pa", 1}}; }
  void copy_field(const std::string &name, std::vector<double> &values) const override
  {
    values.clear();
    for (int j = first_row_; j < first_row_ + rows_; ++j)
      for (int i = 0; i < nx_; ++i)
        if (name == "pressure")
          values.push_back(pressure(i, j));
        else
          for (double component : velocity(i, j)) values.push_back(component);
  }
  void save(const std::string &) override {}
  void load(const std::string &, long, long) override {}
  bool add_scalar(const ScalarOptions &) override { return false; }
  void remove_scalar(const std::string &) override {}
  ScalarPartner *scalar(const std::string &) override { return nullptr; }
  std::vector<PhaseTime> phase_times() const override { return {}; }
  double seconds_in_fluid() const override { return 0.0; }
  double seconds_in_coupling() const override { return 0.0; }

private:
  int nx_, ny_, first_row_, rows_;
};

/// An idle LIGGGHTS, which the output asks for its communicator. Opened once: it warns when it is opened again.
class WholeOutput : public testing::Test {
protected:
  static void SetUpTestSuite()
  {
    std::string words[] = {"test", "-log", "none", "-screen", "none"};
    char *argv[5];
    for (int i = 0; i < 5; ++i) argv[i] = words[i].data();
    lammps_open(5, argv, MPI_COMM_WORLD, &liggghts);
  }
  static void TearDownTestSuite() { lammps_close(liggghts); }
  static inline void *liggghts = nullptr;
};

void check_field_values(vtkImageData *image, int nx, int ny)
{
  auto *pressure = image->GetCellData()->GetArray("pressure");
  auto *velocity = image->GetCellData()->GetArray("velocity");
  ASSERT_NE(pressure, nullptr);
  ASSERT_NE(velocity, nullptr);
  ASSERT_EQ(pressure->GetNumberOfTuples(), nx * ny);
  ASSERT_EQ(velocity->GetNumberOfComponents(), 3);
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const vtkIdType cell = j * nx + i;
      EXPECT_EQ(pressure->GetTuple1(cell), ClosedFormFluid::pressure(i, j));
      for (int d = 0; d < 3; ++d) EXPECT_EQ(velocity->GetComponent(cell, d), ClosedFormFluid::velocity(i, j)[d]);
    }
}

}  // namespace

TEST_F(WholeOutput, FieldsComeBackExactlyWithTheGridTimeAndUnits)
{
  Folder folder;
  const int nx = 7, ny = 5;
  const ClosedFormFluid fluid(nx, ny);
  OutputFrame frame;
  frame.step = 2000;
  frame.time = 10.0;
  frame.fluid = &fluid;
  make_vtk_output(liggghts, {(folder.path / "post").string(), {"velocity", "pressure"}})->write(frame);
  if (rank_of_world() != 0) return;
  const std::string file = size_of_world() == 1 ? "fields_0000002000.vti" : "fields_0000002000.pvti";
  read_back<vtkXMLImageDataReader, vtkXMLPImageDataReader>(folder.path / "post" / file, [&](vtkImageData *image) {
    int extent[6];
    image->GetExtent(extent);
    EXPECT_EQ(std::vector<int>(extent, extent + 6), (std::vector<int>{0, nx, 0, ny, 0, 0}));
    EXPECT_EQ(image->GetOrigin()[0], -1.0);
    EXPECT_EQ(image->GetOrigin()[1], 2.0);
    EXPECT_EQ(image->GetSpacing()[1], 0.25);
    check_field_values(image, nx, ny);
    if (size_of_world() > 1) return;  // VTK's parallel readers leave field data and information in the pieces
    EXPECT_EQ(image->GetFieldData()->GetArray("TimeValue")->GetTuple1(0), 10.0);
    EXPECT_EQ(unit_of(image->GetCellData()->GetArray("velocity")), "m/s");
    EXPECT_EQ(unit_of(image->GetCellData()->GetArray("pressure")), "Pa");
  });
  const std::string entry = "timestep=\"10\" group=\"\" part=\"0\" name=\"fields\" file=\"" + file;
  EXPECT_NE(text_of(folder.path / "post" / "fields.pvd").find(entry), std::string::npos);
}

TEST(FieldFrames, RanksWithoutCellsWriteNoPiece)
{
  Folder folder;
  const ClosedFormFluid fluid(3, 2);  // two rows: on four ranks two ranks have none
  const auto piece = field_data(fluid, {"velocity", "pressure"}, {1, 0.5});
  const auto file = write_image_data(MPI_COMM_WORLD, {folder.path, "fields", 1}, piece, {3, 2, 1});
  if (rank_of_world() != 0) return;
  read_back<vtkXMLImageDataReader, vtkXMLPImageDataReader>(folder.path / file, [](vtkImageData *image) { check_field_values(image, 3, 2); });
}

TEST_F(WholeOutput, UnknownFieldFailsOnEveryRankAndNamesIt)
{
  Folder folder;
  const ClosedFormFluid fluid(4, 4);
  OutputFrame frame;
  frame.fluid = &fluid;
  auto output = make_vtk_output(liggghts, {folder.path.string(), {"vorticity"}});
  try {
    output->write(frame);
    FAIL() << "no error";
  } catch (const std::runtime_error &failure) {
    EXPECT_NE(std::string(failure.what()).find("'vorticity'"), std::string::npos);
  }
}

TEST(PvdCollection, LaterEntriesOfAnEarlierRunAreReplaced)
{
  if (rank_of_world() != 0) return;
  const fs::path file = fs::temp_directory_path() / ("swellflow_test_pvd_" + std::to_string(getpid()) + ".pvd");
  fs::remove(file);
  PvdCollection first(file, 0.0);
  for (int i = 0; i < 4; ++i) first.add({0.1 * i, 0, "outline", "outline_" + std::to_string(i) + ".vtp"});
  first.write();
  PvdCollection second(file, 0.2);  // a restart at the third frame
  second.add({0.2, 0, "outline", "again.vtp"});
  second.write();
  const std::string text = text_of(file);
  EXPECT_NE(text.find("outline_0.vtp"), std::string::npos);
  EXPECT_NE(text.find("outline_1.vtp"), std::string::npos);
  EXPECT_EQ(text.find("outline_2.vtp"), std::string::npos);
  EXPECT_EQ(text.find("outline_3.vtp"), std::string::npos);
  EXPECT_NE(text.find("again.vtp"), std::string::npos);
  EXPECT_FALSE(fs::exists(file.string() + ".new"));
  std::ofstream(file) << "not a collection";
  EXPECT_THROW(PvdCollection(file, 0.0), std::runtime_error);
  fs::remove(file);
}

TEST_F(WholeOutput, SecondOutputIntoTheSameFolderKeepsEarlierFrames)
{
  Folder folder;
  const ClosedFormFluid fluid(4, 4);
  OutputOptions options;
  options.folder = folder.path.string();
  options.fields = {"pressure"};
  OutputFrame frame;
  frame.fluid = &fluid;
  auto write = [&](OutputPartner &output, long step) {
    frame.step = step;
    frame.time = 0.5 * step;
    output.write(frame);
  };
  auto first = make_vtk_output(liggghts, options);
  for (long step : {0, 1, 2, 3}) write(*first, step);
  auto second = make_vtk_output(liggghts, options);
  frame.own_from = 1.0;
  write(*second, 2);
  if (rank_of_world() != 0) return;
  for (const char *name : {"fields.pvd", "all.pvd"}) {
    const std::string text = text_of(folder.path / name);
    for (const char *step : {"0000", "0001", "0002"}) EXPECT_NE(text.find(std::string("fields_000000") + step), std::string::npos) << name;
    EXPECT_EQ(text.find("fields_0000000003"), std::string::npos) << name;
  }
}

TEST_F(WholeOutput, FolderThatCannotBeMadeIsNamedOnEveryRank)
{
  Folder folder;
  if (rank_of_world() == 0) std::ofstream(folder.path / "file") << "in the way";
  OutputOptions options;
  options.folder = (folder.path / "file" / "post").string();
  try {
    make_vtk_output(liggghts, options);
    FAIL() << "no error";
  } catch (const std::runtime_error &failure) {
    const std::string message = failure.what();
    EXPECT_NE(message.find(options.folder), std::string::npos);
    EXPECT_NE(message.find("keyword folder"), std::string::npos);
  }
}

TEST(Collective, OneRanksFailureIsEveryRanksFailure)
{
  const int last = size_of_world() - 1;
  EXPECT_NO_THROW(all_or_none(MPI_COMM_WORLD, [] {}));
  try {
    all_or_none(MPI_COMM_WORLD, [&] {
      if (rank_of_world() == last) throw std::runtime_error("disk full");
    });
    FAIL() << "no error";
  } catch (const std::runtime_error &failure) {
    EXPECT_STREQ(failure.what(), "disk full");
  }
}
