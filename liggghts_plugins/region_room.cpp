#include "region_room.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "domain.h"
#include "options.h"
#include "region.h"

using swellflow::NearWall;
using swellflow::PlaneBox;
using swellflow::Vector2;

namespace LAMMPS_NS {

namespace {

class RegionRoom : public swellflow::PackingRoom {
public:
  RegionRoom(Region *region, const PlaneBox &box) : PackingRoom(box), region_(region), sides_(box), low_(box.low), high_(box.high)
  {
    region->init();
    region->prematch();
    if (region->bboxflag && !region->dynamic_check()) {
      low_ = low_.cwiseMax(Vector2(region->extent_xlo, region->extent_ylo));
      high_ = high_.cwiseMin(Vector2(region->extent_xhi, region->extent_yhi));
    }
    measure();
  }

  Vector2 low() const override { return low_; }
  Vector2 high() const override { return high_; }
  double area() const override { return area_; }
  bool contains(const Vector2 &x) const override
  {
    const Vector2 in_box = box().wrapped(x);
    return sides_.contains(in_box) && region_->match(in_box.x(), in_box.y(), 0.0);
  }

  void walls_near(const Vector2 &x, double reach, std::vector<NearWall> &walls) const override
  {
    const Vector2 in_box = box().wrapped(x);
    sides_.walls_near(in_box, reach, walls);
    if (region_->match(in_box.x(), in_box.y(), 0.0)) {
      add_surfaces(in_box, reach, 1.0, walls);
      return;
    }
    // The region turned inside out knows the way back; its nearest surface is enough.
    std::vector<NearWall> outside;
    region_->interior ^= 1;
    add_surfaces(in_box, (high_ - low_).norm(), -1.0, outside);
    region_->interior ^= 1;
    const auto nearest = std::max_element(outside.begin(), outside.end(), [](const NearWall &a, const NearWall &b) { return a.distance < b.distance; });
    if (nearest != outside.end()) walls.push_back(*nearest);
  }

private:
  /// The area is that of as many of n x n places as lie in the region: to 1e-4 and better.
  void measure()
  {
    constexpr int n = 2000;
    long inside = 0;
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) inside += contains(low_ + (high_ - low_).cwiseProduct(Vector2((i + 0.5) / n, (j + 0.5) / n)));
    area_ = (high_ - low_).cwiseMax(0.0).prod() * inside / (static_cast<double>(n) * n);
  }

  /// A surface in a periodic side of the box is no wall: there the region goes on.
  bool in_periodic_side(const Vector2 &x) const
  {
    for (int d = 0; d < 2; ++d)
      if (box().periodic[d] && std::min(std::abs(x[d] - box().low[d]), std::abs(x[d] - box().high[d])) < 1e-9 * box().length()[d]) return true;
    return false;
  }

  void add_surfaces(const Vector2 &x, double reach, double sign, std::vector<NearWall> &walls) const
  {
    const int n = region_->surface(x.x(), x.y(), 0.0, reach);
    for (int k = 0; k < n; ++k) {
      const Region::Contact &contact = region_->contact[k];
      const Vector2 from_surface(contact.delx, contact.dely);
      const double distance = from_surface.norm();
      if (distance == 0.0 || std::abs(contact.delz) > 1e-9 * distance || in_periodic_side(x - from_surface)) continue;  // surfaces above and below are none here
      walls.push_back({sign * from_surface / distance, sign * distance});
    }
  }

  Region *region_;
  swellflow::RectangularRoom sides_;
  Vector2 low_, high_;
  double area_ = 0.0;
};

}  // namespace

std::shared_ptr<const swellflow::PackingRoom> room_of_region(LAMMPS *lmp, const std::string &id, const PlaneBox &box)
{
  const int found = lmp->domain->find_region(const_cast<char *>(id.c_str()));
  if (found < 0) return nullptr;
  Region *region = lmp->domain->regions[found];
  if (std::strncmp(region->style, "mesh", 4) == 0)
    throw swellflow::OptionError("create_objects random: 'region' must have surfaces that can be asked for, but '" + id + "' is of style " + region->style +
                                 ": use block, cylinder, sphere, prism, cone, plane, wedge, union or intersect");
  auto room = std::make_shared<RegionRoom>(region, box);
  if (room->area() <= 0.0) throw swellflow::OptionError("create_objects random: region '" + id + "' must reach into the box at z = 0, but does not: move it");
  return room;
}

}  // namespace LAMMPS_NS
