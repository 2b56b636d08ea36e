// One frame as VTK data sets: what is a point, what is a cell, which arrays they carry, in which units.
#pragma once

#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "coupling/output/object_shape.h"
#include "liggghts_plugins/objects/unit_names.h"

namespace swellflow {

struct FrameTime {
  long step;
  double time;
};

/// One polygon an object; its values are cell data.
vtkSmartPointer<vtkPolyData> outline_data(const std::vector<ObjectState> &objects, const UnitNames &units, FrameTime when);
/// Every mass point, hub and ring, as a vertex with point data.
vtkSmartPointer<vtkPolyData> point_data(const std::vector<ObjectState> &objects, const UnitNames &units, FrameTime when);
/// Every contact-detection sphere as a vertex with its radius.
vtkSmartPointer<vtkPolyData> cds_data(const std::vector<ObjectState> &objects, const UnitNames &units, FrameTime when);
/// Every object as a vertex at its centroid, with all its measures as point data.
vtkSmartPointer<vtkPolyData> centre_data(const std::vector<ObjectMeasures> &objects, const UnitNames &units, FrameTime when);
/// This rank's cells of the fluid's grid; a plane of cells when the fluid is 2-D.
vtkSmartPointer<vtkImageData> field_data(const FluidPartner &fluid, const std::vector<std::string> &names, FrameTime when);

}  // namespace swellflow
