// The measures of a scene's objects.
#pragma once

#include "dry_scene.h"
#include "liggghts_plugins/all_ranks.h"
#include "liggghts_plugins/object_measures.h"

namespace swellflow_test {

using Measures = std::map<int, swellflow::ObjectMeasures>;

/// Of all objects, by id, on every rank.
inline Measures measures_of(const DryScene &scene)
{
  constexpr int group_all = 1;
  Measures measures;
  const auto all = LAMMPS_NS::from_all_ranks(LAMMPS_NS::measure_objects(scene.lmp(), group_all), scene.lmp()->world);
  for (const swellflow::ObjectMeasures &object : all) EXPECT_TRUE(measures.try_emplace(object.id, object).second) << "object " << object.id << " comes twice";
  return measures;
}

}  // namespace swellflow_test
