#include "shape_options.h"

#include "objects/outline_file.h"

namespace swellflow {

// A sphere on the outline must not be wider than its object.
Range cds_range() { return Range::above_to(0.0, 0.5); }
Range reach_range() { return Range::not_negative(); }
Range points_range(ShapeOptions::Kind kind) { return {.low = kind == ShapeOptions::OUTLINE ? 0.0 : 3.0, .high = 1e4}; }

const std::vector<std::string> ShapeOptions::names = {"disk", "ellipse", "outline"};

ShapeOptions::ShapeOptions(Kind kind, Arguments &line, const ObjectScene &scene) : kind_(kind)
{
  request_.points = scene.points;
  if (kind == DISK) request_.contour = std::make_shared<Contour>(Contour::disk());
  if (kind != OUTLINE) return;
  const std::string file = line.word("outline");
  request_.contour = std::make_shared<Contour>(Contour::polygon(read_outline(file, scene.text_of_file(file))));
}

void ShapeOptions::read(Arguments &line, const CsvTable *table, const std::function<void(Options &)> &declare_more)
{
  const auto in_table = [table](const char *column) { return table && table->has(column); };
  int spacing = 0, share = 0;
  double reach = 0.0;
  Options options(line.place());
  if (kind_ != ELLIPSE) options.number("diameter", diameter_, Range::positive(), "length", "natural diameter, of the disc of the same area");
  if (kind_ == DISK && !in_table("diameter")) options.required();
  const auto read_axes = [this](Arguments &rest) {
    for (double &axis : axes_) axis = rest.number("axes", Range::positive(), "length");
  };
  if (kind_ == ELLIPSE) options.custom("axes", read_axes, "A B: the whole axes").required();
  options.number("density", density_, Range::positive(), "mass per volume", "density of the object");
  if (!in_table("density")) options.required();
  options.integer("points", request_.points, points_range(kind_), "mass points on the ring");
  if (kind_ != DISK) options.choice("point_spacing", spacing, {"arc", "angle"}, "what is equal between ring points: the way along the outline, or the angle");
  options.number("angle", angle_, Range::any(), "degrees", "by which the shape is turned about its centre");
  options.yes_no("spokes", request_.spokes, "whether springs join ring and hub");
  options.number("cds", request_.cds, cds_range(), "of the diameter", "radius of the contact detection spheres");
  options.number("reach", reach, reach_range(), "of the diameter", "how far the spheres reach beyond the outline");
  options.integer("cds_points", request_.cds_points, Range::at_least(1), "ring points that have a sphere");
  options.yes_no("hub_cds", request_.hub_cds, "whether the hub has a sphere");
  options.integer("type", type_, Range::at_least(1), "atom type of all points");
  options.choice("mass", share, {"hub_half", "equal"}, "how the mass is shared among hub and ring");
  options.custom("sizes", [this](Arguments &rest) { read_sizes(rest); }, "normal, lognormal or uniform SPREAD seed S: random factors of the diameters");
  if (declare_more) declare_more(options);
  options.parse(line);
  if (options.given("reach")) request_.reach = reach;
  if (kind_ == ELLIPSE) request_.contour = std::make_shared<Contour>(Contour::ellipse(axes_[0], axes_[1]));
  request_.spacing = static_cast<PointSpacing>(spacing);
  request_.share = static_cast<MassShare>(share);
  if (!request_.spokes && options.given("hub_cds") && request_.hub_cds)
    line.fail("a hub without spokes takes part in no contact, but 'hub_cds yes' gives it a sphere: leave it out");
}

void ShapeOptions::read_sizes(Arguments &line)
{
  sizes_.kind = line.choice("sizes", {"normal", "lognormal", "uniform"});
  sizes_.spread = line.number("sizes", Range::above_to(0.0, SizeDistribution::largest_spread(sizes_.kind)), "standard deviation over mean");
  line.expect("seed");
  sizes_.seed = line.integer("seed", Range::at_least(0));
}

NewObject ShapeOptions::object(const std::string &place, const Row &row)
{
  NewObject object;
  object.place = place;
  ShapeRequest request = request_;
  const double given = diameter_ > 0.0 ? diameter_ : request.contour->own_diameter();
  object.diameter = row.diameter.value_or(given);
  object.density = row.density.value_or(density_);
  object.angle = row.angle.value_or(angle_);
  object.type = row.type.value_or(type_);
  request.points = row.points.value_or(request.points);
  request.cds = row.cds.value_or(request.cds);
  if (row.reach) request.reach = row.reach;
  if (request.reach > request.cds)
    throw OptionError(place + ": 'reach' must be at most 'cds', the radius of the spheres, " + shown(request.cds) + ", but is " + shown(*request.reach) +
                      ": lower it, or raise 'cds'");
  object.shape = shape(request, place);
  return object;
}

std::shared_ptr<const Shape> ShapeOptions::shape(const ShapeRequest &request, const std::string &place)
{
  auto &made = made_[{request.points, request.cds, request.reach.value_or(request.cds)}];
  if (made) return made;
  try {
    made = std::make_shared<Shape>(make_shape(request));
  } catch (const std::invalid_argument &problem) {
    throw OptionError(place + ": " + problem.what());
  }
  return made;
}

}  // namespace swellflow
