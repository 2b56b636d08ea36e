// Builders of the data sets.
#include "coupling/output/frame_data.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkIntArray.h>
#include <vtkLongLongArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <algorithm>
#include <stdexcept>

namespace swellflow {

namespace {

/// Columns of values that grow with each point or cell; attached to a data set at the end.
template <typename Array>
class Column {
public:
  Column(const char *name, int components, const std::string &unit)
  {
    array_->SetName(name);
    array_->SetNumberOfComponents(components);
    if (!unit.empty()) array_->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), unit.c_str());
  }
  template <typename Value>
  void add(Value value) { array_->InsertNextValue(value); }
  void add(const Vec3 &vector) { array_->InsertNextTuple(vector.data()); }
  void attach(vtkDataSetAttributes *to) const { to->AddArray(array_); }

private:
  vtkNew<Array> array_;
};

using Doubles = Column<vtkDoubleArray>;
using Integers = Column<vtkIntArray>;

void stamp(vtkDataObject *data, FrameTime when)
{
  vtkNew<vtkDoubleArray> time;  // the name that ParaView looks for
  time->SetName("TimeValue");
  time->InsertNextValue(when.time);
  vtkNew<vtkLongLongArray> step;
  step->SetName("step");
  step->InsertNextValue(when.step);
  data->GetFieldData()->AddArray(time);
  data->GetFieldData()->AddArray(step);
}

/// Positions, each with a vertex cell: ParaView and glyphs then see them without further filters.
class Vertices {
public:
  Vertices() { points_->SetDataTypeToDouble(); }
  void add(const Vec3 &x)
  {
    const vtkIdType id = points_->InsertNextPoint(x.data());
    cells_->InsertNextCell(1, &id);
  }
  vtkSmartPointer<vtkPolyData> data() const
  {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points_);
    data->SetVerts(cells_);
    return data;
  }

private:
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> cells_;
};

template <typename Visit>
void for_each_point(const ObjectState &object, const Visit &visit)
{
  visit(object.hub, true);
  for (const PointState &point : object.ring) visit(point, false);
}

void add_outlines(const std::vector<ObjectState> &objects, vtkPolyData *data)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polygons;
  for (const ObjectState &object : objects) {
    const Vec3 &hub = object.hub.x;
    polygons->InsertNextCell(static_cast<int>(object.ring.size()));
    for (const Vector2 &vertex : object.outline())
      polygons->InsertCellPoint(points->InsertNextPoint(hub[0] + vertex.x(), hub[1] + vertex.y(), hub[2]));
  }
  data->SetPoints(points);
  data->SetPolys(polygons);
}

void attach_measure(const std::vector<ObjectMeasures> &objects, const char *name, const std::string &unit, ObjectMeasures::Plane ObjectMeasures::*vector,
                    vtkDataSetAttributes *to)
{
  Doubles column(name, 3, unit);
  for (const ObjectMeasures &object : objects) column.add(Vec3{(object.*vector)[0], (object.*vector)[1], 0.0});
  column.attach(to);
}

void attach_measure(const std::vector<ObjectMeasures> &objects, const char *name, const std::string &unit, double ObjectMeasures::*value, vtkDataSetAttributes *to)
{
  Doubles column(name, 1, unit);
  for (const ObjectMeasures &object : objects) column.add(object.*value);
  column.attach(to);
}

void attach_measure(const std::vector<ObjectMeasures> &objects, const char *name, const std::string &unit, int ObjectMeasures::*number, vtkDataSetAttributes *to)
{
  Integers column(name, 1, unit);
  for (const ObjectMeasures &object : objects) column.add(object.*number);
  column.attach(to);
}

FieldInfo find_field(const FluidPartner &fluid, const std::string &name)
{
  const auto fields = fluid.fields();
  const auto found = std::find_if(fields.begin(), fields.end(), [&](const FieldInfo &field) { return field.name == name; });
  if (found == fields.end()) throw std::runtime_error("the fluid has no field '" + name + "'");
  return *found;
}

/// VTK counts points, the fluid cells: n cells lie between n + 1 points; a direction that is not solved has one plane of points.
std::array<int, 6> point_extent(const std::array<int, 3> &first, const std::array<int, 3> &count, bool planar)
{
  if (count[0] == 0 || count[1] == 0 || count[2] == 0) return {0, -1, 0, -1, 0, -1};  // VTK's empty extent
  std::array<int, 6> extent{};
  for (int d = 0; d < (planar ? 2 : 3); ++d) {
    extent[2 * d] = first[d];
    extent[2 * d + 1] = first[d] + count[d];
  }
  return extent;
}

void add_field(const FluidPartner &fluid, const FieldInfo &info, vtkIdType n_cells, vtkImageData *image)
{
  std::vector<double> values;
  fluid.copy_field(info.name, values);
  if (static_cast<vtkIdType>(values.size()) != n_cells * info.components)
    throw std::runtime_error("field '" + info.name + "' must have " + std::to_string(n_cells * info.components) + " values but has " +
                             std::to_string(values.size()));
  vtkNew<vtkDoubleArray> array;
  array->SetName(info.name.c_str());
  array->SetNumberOfComponents(info.components);
  array->SetNumberOfTuples(n_cells);
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  if (!info.unit.empty()) array->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), info.unit.c_str());
  image->GetCellData()->AddArray(array);
}

}  // namespace

vtkSmartPointer<vtkPolyData> outline_data(const std::vector<ObjectState> &objects, const UnitNames &units, FrameTime when)
{
  Integers id("object_id", 1, "");
  Doubles natural("natural_diameter", 1, units.length), mean("mean_diameter", 1, units.length), ratio("swelling_ratio", 1, "1"),
      area("area", 1, units.area), aspect("aspect_ratio", 1, "1"), mass("mass", 1, units.mass),
      velocity("velocity", 3, units.velocity), force("outer_force", 3, units.force);
  for (const ObjectState &object : objects) {
    const OutlineShape shape = object.shape();
    id.add(object.id);
    natural.add(object.natural_diameter);
    mean.add(object.mean_diameter());
    ratio.add(object.swelling_ratio);
    area.add(shape.area);
    aspect.add(shape.aspect_ratio);
    mass.add(object.mass());
    velocity.add(object.velocity());
    force.add(object.outer_force());
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  add_outlines(objects, data);
  id.attach(data->GetCellData());
  for (const Doubles *column : {&natural, &mean, &ratio, &area, &aspect, &mass, &velocity, &force}) column->attach(data->GetCellData());
  stamp(data, when);
  return data;
}

vtkSmartPointer<vtkPolyData> point_data(const std::vector<ObjectState> &objects, const UnitNames &units, FrameTime when)
{
  Vertices vertices;
  Integers id("object_id", 1, ""), tag("tag", 1, ""), hub("hub", 1, "");
  Doubles velocity("velocity", 3, units.velocity), force("force", 3, units.force), mass("mass", 1, units.mass);
  for (const ObjectState &object : objects)
    for_each_point(object, [&](const PointState &point, bool is_hub) {
      vertices.add(point.x);
      id.add(object.id);
      tag.add(point.tag);
      hub.add(is_hub ? 1 : 0);
      velocity.add(point.velocity);
      force.add(point.force);
      mass.add(point.mass);
    });
  auto data = vertices.data();
  for (const Integers *column : {&id, &tag, &hub}) column->attach(data->GetPointData());
  for (const Doubles *column : {&velocity, &force, &mass}) column->attach(data->GetPointData());
  stamp(data, when);
  return data;
}

vtkSmartPointer<vtkPolyData> cds_data(const std::vector<ObjectState> &objects, const UnitNames &units, FrameTime when)
{
  Vertices vertices;
  Integers id("object_id", 1, ""), tag("tag", 1, ""), hub("hub", 1, "");
  Doubles radius("radius", 1, units.length);
  for (const ObjectState &object : objects)
    for_each_point(object, [&](const PointState &point, bool is_hub) {
      if (point.cds_radius <= 0.0) return;
      vertices.add(point.x);
      id.add(object.id);
      tag.add(point.tag);
      hub.add(is_hub ? 1 : 0);
      radius.add(point.cds_radius);
    });
  auto data = vertices.data();
  for (const Integers *column : {&id, &tag, &hub}) column->attach(data->GetPointData());
  radius.attach(data->GetPointData());
  stamp(data, when);
  return data;
}

vtkSmartPointer<vtkPolyData> centre_data(const std::vector<ObjectMeasures> &objects, const UnitNames &units, FrameTime when)
{
  Vertices vertices;
  Integers id("object_id", 1, "");
  for (const ObjectMeasures &object : objects) {
    vertices.add({object.centroid[0], object.centroid[1], 0.0});
    id.add(object.id);
  }
  auto data = vertices.data();
  id.attach(data->GetPointData());
  for_each_measure(units, [&](const char *name, const std::string &unit, auto member) {
    attach_measure(objects, name, unit, member, data->GetPointData());
  });
  stamp(data, when);
  return data;
}

vtkSmartPointer<vtkImageData> field_data(const FluidPartner &fluid, const std::vector<std::string> &names, FrameTime when)
{
  const FieldBlock block = fluid.field_block();
  auto extent = point_extent(block.first, block.count, block.global_cells[2] <= 1);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetOrigin(block.origin.data());
  image->SetSpacing(block.spacing, block.spacing, block.spacing);
  image->SetExtent(extent.data());
  const vtkIdType n_cells = vtkIdType(block.count[0]) * block.count[1] * block.count[2];
  for (const std::string &name : names) add_field(fluid, find_field(fluid, name), n_cells, image);
  stamp(image, when);
  return image;
}

}  // namespace swellflow
