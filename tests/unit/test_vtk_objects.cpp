// Outlines, points and spheres are read back with VTK's own readers: what ParaView would see must be what was written.
#include <vtkCellData.h>
#include <vtkPointData.h>
#include <vtkXMLPPolyDataReader.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "coupling/output/frame_data.h"
#include "coupling/output/frame_files.h"
#include "vtk_reading.h"

using namespace swellflow;

namespace {

PointState point(double x, double y, int tag)
{
  PointState state;
  state.x = {x, y, 0.0};
  state.velocity = {y, -x, 0.0};
  state.force = {1.0, 2.0, 0.0};
  state.mass = 3.0;
  state.tag = tag;
  return state;
}

/// An ellipse with 20 ring points whose half axes are a and b.
ObjectState ellipse(int id, double x, double y, double a, double b)
{
  ObjectState object;
  object.id = id;
  object.swelling_ratio = 1.5;
  object.natural_diameter = 0.18;
  object.hub = point(x, y, 21 * id);
  for (int k = 0; k < 20; ++k) {
    const double angle = 2 * std::numbers::pi * k / 20;
    object.ring.push_back(point(x + a * std::cos(angle), y + b * std::sin(angle), 21 * id + 1 + k));
    object.ring.back().cds_radius = 0.036;
  }
  return object;
}

template <typename Use>
void read_poly(const fs::path &file, const Use &use)
{
  read_back<vtkXMLPolyDataReader, vtkXMLPPolyDataReader>(file, use);
}

}  // namespace

TEST(ObjectFrames, OutlinesAreClosedPolygonsWithTheirObjectsValues)
{
  Folder folder;
  std::vector<ObjectState> mine;  // the object's id tells the rank that writes it; the last rank has none
  if (size_of_world() == 1 || rank_of_world() + 1 < size_of_world()) mine = {ellipse(rank_of_world() + 1, 0.3, 0.4, 0.2, 0.1)};
  const auto file = write_poly_data(MPI_COMM_WORLD, {folder.path, "outline", 3}, outline_data(mine, unit_names("si"), {3, 1.5}));
  if (rank_of_world() != 0) return;
  read_poly(folder.path / file, [&](vtkPolyData *data) {
    const int n = std::max(1, size_of_world() - 1);
    ASSERT_EQ(data->GetNumberOfPolys(), n);
    ASSERT_EQ(data->GetNumberOfPoints(), 20 * n);
    const auto value = [&](const char *name, int cell, int component = 0) {
      return data->GetCellData()->GetArray(name)->GetComponent(cell, component);
    };
    const double area = 10 * std::sin(2 * std::numbers::pi / 20) * 0.2 * 0.1;
    for (int i = 0; i < n; ++i) {
      EXPECT_EQ(data->GetCell(i)->GetNumberOfPoints(), 20);
      EXPECT_EQ(value("object_id", i), i + 1);
      EXPECT_EQ(value("natural_diameter", i), 0.18);
      EXPECT_EQ(value("swelling_ratio", i), 1.5);
      EXPECT_NEAR(value("area", i), area, 1e-15);
      EXPECT_NEAR(value("aspect_ratio", i), 2.0, 1e-12);
      EXPECT_NEAR(value("mass", i), 63.0, 1e-12);
      EXPECT_NEAR(value("velocity", i, 0), 0.4, 1e-12);  // v = (y, -x) turns about the origin: that of the centre
      EXPECT_NEAR(value("velocity", i, 1), -0.3, 1e-12);
      EXPECT_NEAR(value("outer_force", i, 1), 42.0, 1e-12);
    }
    if (size_of_world() == 1) {
      EXPECT_EQ(unit_of(data->GetCellData()->GetArray("area")), "m^2");
    }
  });
}

TEST(ObjectFrames, PointsAndSpheresAreVerticesWithTheirValues)
{
  Folder folder;
  const std::vector<ObjectState> mine = {ellipse(2 * rank_of_world() + 1, 0, 0, 1, 1), ellipse(2 * rank_of_world() + 2, 5, 0, 1, 1)};
  const auto units = unit_names("si");
  const auto points = write_poly_data(MPI_COMM_WORLD, {folder.path, "points", 3}, point_data(mine, units, {3, 1.5}));
  const auto cds = write_poly_data(MPI_COMM_WORLD, {folder.path, "cds", 3}, cds_data(mine, units, {3, 1.5}));
  if (rank_of_world() != 0) return;
  const int n = 2 * size_of_world();
  read_poly(folder.path / points, [&](vtkPolyData *data) {
    ASSERT_EQ(data->GetNumberOfPoints(), 21 * n);
    ASSERT_EQ(data->GetNumberOfVerts(), 21 * n);
    for (int i = 0; i < 21 * n; ++i) {
      EXPECT_EQ(data->GetPointData()->GetArray("tag")->GetTuple1(i), 21 + i);
      EXPECT_EQ(data->GetPointData()->GetArray("hub")->GetTuple1(i), i % 21 == 0);
      EXPECT_EQ(data->GetPointData()->GetArray("object_id")->GetTuple1(i), 1 + i / 21);
      EXPECT_EQ(data->GetPointData()->GetArray("velocity")->GetComponent(i, 1), -data->GetPoint(i)[0]);
    }
  });
  read_poly(folder.path / cds, [&](vtkPolyData *data) {  // these hubs have no sphere
    ASSERT_EQ(data->GetNumberOfVerts(), 20 * n);
    for (int i = 0; i < 20 * n; ++i) EXPECT_EQ(data->GetPointData()->GetArray("radius")->GetTuple1(i), 0.036);
  });
}

TEST(ObjectFrames, OutlinesLieBeyondTheRing)
{
  Folder folder;
  ObjectState object = ellipse(1, 0.3, 0.4, 0.2, 0.2);
  for (PointState &p : object.ring) p.outline_offset = 0.05;
  EXPECT_NEAR(object.mean_diameter(), 0.5, 1e-12);
  const std::vector<ObjectState> mine(rank_of_world() == 0 ? 1 : 0, object);
  const auto file = write_poly_data(MPI_COMM_WORLD, {folder.path, "outline", 3}, outline_data(mine, unit_names("si"), {3, 1.5}));
  if (rank_of_world() != 0) return;
  read_poly(folder.path / file, [&](vtkPolyData *data) {
    ASSERT_EQ(data->GetNumberOfPoints(), 20);
    for (int i = 0; i < 20; ++i) EXPECT_NEAR(std::hypot(data->GetPoint(i)[0] - 0.3, data->GetPoint(i)[1] - 0.4), 0.25, 1e-12);
    EXPECT_NEAR(data->GetCellData()->GetArray("area")->GetTuple1(0), 10 * std::sin(2 * std::numbers::pi / 20) * 0.0625, 1e-12);
  });
}

TEST(ObjectFrames, CentresCarryAllMeasures)
{
  Folder folder;
  std::vector<ObjectMeasures> mine(2);
  for (int k = 0; k < 2; ++k) {
    mine[k].id = 2 * rank_of_world() + 1 + k;
    mine[k].centroid = {0.1 * mine[k].id, 0.2};
    mine[k].velocity = {3.0, -1.0 * mine[k].id};
    mine[k].contact_pressure = 1.0 / mine[k].id;
    mine[k].coordination = 4;
  }
  const auto file = write_poly_data(MPI_COMM_WORLD, {folder.path, "centres", 3}, centre_data(mine, unit_names("si"), {3, 1.5}));
  if (rank_of_world() != 0) return;
  read_poly(folder.path / file, [&](vtkPolyData *data) {
    const int n = 2 * size_of_world();
    ASSERT_EQ(data->GetNumberOfVerts(), n);
    const auto array = [&](const char *name) { return data->GetPointData()->GetArray(name); };
    for (int i = 0; i < n; ++i) {
      EXPECT_EQ(array("object_id")->GetTuple1(i), i + 1);
      EXPECT_EQ(data->GetPoint(i)[0], 0.1 * (i + 1));
      EXPECT_EQ(data->GetPoint(i)[1], 0.2);
      EXPECT_EQ(array("velocity")->GetComponent(i, 1), -(i + 1));
      EXPECT_EQ(array("contact_pressure")->GetTuple1(i), 1.0 / (i + 1));
      EXPECT_EQ(array("coordination")->GetTuple1(i), 4);
    }
    for_each_measure({}, [&](const char *name, const std::string &, auto) { EXPECT_NE(array(name), nullptr) << name; });
    if (size_of_world() == 1) {
      EXPECT_EQ(unit_of(array("contact_pressure")), "Pa");
      EXPECT_EQ(unit_of(array("rotation")), "rad");
    }
  });
}

TEST(ObjectFrames, ScenesWithoutObjectsGiveEmptyButReadableSets)
{
  Folder folder;
  const auto file = write_poly_data(MPI_COMM_WORLD, {folder.path, "outline", 0}, outline_data({}, unit_names("si"), {0, 0.0}));
  if (rank_of_world() == 0) read_poly(folder.path / file, [](vtkPolyData *data) { EXPECT_EQ(data->GetNumberOfCells(), 0); });
}

TEST(ObjectFrames, ShapeMeasuresOfAnObliqueEllipse)
{
  ObjectState object = ellipse(1, 0.0, 0.0, 0.3, 0.1);
  for (PointState &p : object.ring) {  // turned by 30 degrees and moved off its hub
    const double c = std::cos(std::numbers::pi / 6), s = std::sin(std::numbers::pi / 6);
    p.x = {c * p.x[0] - s * p.x[1] + 0.02, s * p.x[0] + c * p.x[1], 0.0};
  }
  EXPECT_NEAR(object.shape().aspect_ratio, 3.0, 1e-12);
  EXPECT_NEAR(object.shape().area, 10 * std::sin(2 * std::numbers::pi / 20) * 0.03, 1e-15);
  std::reverse(object.ring.begin(), object.ring.end());
  EXPECT_LT(object.shape().area, 0.0);  // inside out
  EXPECT_NEAR(ellipse(1, 3.0, 4.0, 0.1, 0.1).mean_diameter(), 0.2, 1e-12);
}
