#include "fluid/markers.h"

namespace swellflow {

template <int Dim, class Kernel> void Markers<Dim, Kernel>::place(const std::vector<Vec<Dim>> &positions)
{
  stencils_.resize(positions.size());
  for (std::size_t l = 0; l < positions.size(); ++l)
    for (int c = 0; c < Dim; ++c) place_component(positions[l], c, stencils_[l]);
}

template <int Dim, class Kernel>
void Markers<Dim, Kernel>::place_component(const Vec<Dim> &position, int c, Stencil &stencil) const
{
  std::array<int, Dim> first;
  for (int d = 0; d < Dim; ++d) {
    // In units of h: faces of component c lie at whole numbers in direction c, at half ones in the others.
    const double size = grid_.cells[d];
    const double x = std::clamp((position[d] - grid_.origin[d]) / grid_.h, 0.0, size) - (d == c ? 0.0 : 0.5);
    const int middle = static_cast<int>(std::floor(x + 0.5));
    auto &w = stencil.weight[c][d];
    Kernel::weights(x - middle, w.data());
    first[d] = middle - width / 2;

    const int lowest = d == c ? 1 : 0, highest = grid_.cells[d] - 1;
    if (first[d] < lowest || first[d] + width - 1 > highest) {
      double sum = 0.0;
      for (int i = 0; i < width; ++i) {
        if (first[d] + i < lowest || first[d] + i > highest) w[i] = 0.0;
        sum += w[i];
      }
      for (double &weight : w) weight /= sum;
    }
  }
  first[Dim - 1] -= grid_.first_plane;
  stencil.first_plane[c] = first[Dim - 1];
  stencil.first[c] = layout_.at(first);
}

template <int Dim, class Kernel>
void Markers<Dim, Kernel>::interpolate(const VectorField<Dim> &face_velocity, std::vector<Vec<Dim>> &velocities) const
{
  velocities.resize(stencils_.size());
  for (std::size_t l = 0; l < stencils_.size(); ++l)
    for (int c = 0; c < Dim; ++c) {
      const double *face = face_velocity[c].data();
      double sum = 0.0;
      each_point(stencils_[l], c, [&](std::ptrdiff_t at, double weight) { sum += weight * face[at]; });
      velocities[l][c] = sum;
    }
}

template <int Dim, class Kernel>
void Markers<Dim, Kernel>::spread(const std::vector<Vec<Dim>> &impulses, double density, FaceForcing<Dim> &forcing) const
{
  const double per_impulse = 1.0 / (density * grid_.cell_volume());
  for (std::size_t l = 0; l < stencils_.size(); ++l)
    for (int c = 0; c < Dim; ++c) {
      const double change = per_impulse * impulses[l][c];
      double *face = forcing.faces(c);
      forcing.touch(stencils_[l].first_plane[c], stencils_[l].first_plane[c] + width - 1);
      each_point(stencils_[l], c, [&](std::ptrdiff_t at, double weight) { face[at] += weight * change; });
    }
}

template class Markers<2>;

}  // namespace swellflow
