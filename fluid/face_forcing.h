// What the markers give to the fluid: a change of velocity on each face.
#pragma once

#include <vector>

#include "fluid/halo.h"

namespace swellflow {

/// Face values f [velocity]; planes that no marker touches cost nothing. A cell receives the mean of its two faces.
template <int Dim> class FaceForcing {
public:
  FaceForcing(const Grid<Dim> &grid, const Layout<Dim> &layout)
      : layout_(layout), halo_(grid, layout), faces_(layout), touched_(layout.planes() + 2 * Grid<Dim>::ghost, 0)
  {
  }

  void clear()
  {
    for (int k = first(); k < end(); ++k) {
      if (!touched(k)) continue;
      for (int c = 0; c < Dim; ++c) std::fill_n(faces_[c].data() + layout_.plane_begin(k), layout_.plane_stride(), 0.0);
      touched_[k - first()] = 0;
    }
  }

  const VectorField<Dim> &field() const { return faces_; }
  double *faces(int c) { return faces_[c].data(); }
  const double *faces(int c) const { return faces_[c].data(); }
  /// To be said of the planes first … last before faces there are written.
  void touch(int first_touched, int last_touched)
  {
    for (int k = first_touched; k <= last_touched; ++k) touched_[k - first()] = 1;
  }
  bool touched(int k) const { return touched_[k - first()]; }
  /// Whether the cells of plane k, or the faces around it, receive anything.
  bool touches_neighbourhood(int k) const { return touched(k - 1) || touched(k) || touched(k + 1); }

  /// Joins what was given to shared faces from both sides of slab borders and of periodic ones; afterwards all ghosts are right. Collective.
  void complete()
  {
    if (halo_.has_neighbours()) {
      for (int c = 0; c < Dim; ++c) halo_.add(faces_[c]);
      // A neighbour may have written here: only the middle of the slab is known to be untouched.
      touch(first(), std::min(end() - 1, first() + 2 * Grid<Dim>::ghost));
      touch(std::max(first(), end() - 1 - 2 * Grid<Dim>::ghost), end() - 1);
    }
    for (int k = 0; k < layout_.planes(); ++k)
      if (touched(k))
        for (int c = 0; c < Dim; ++c) halo_.fold(faces_[c], k);
    for (int c = 0; c < Dim; ++c) halo_.fill(faces_[c], Grid<Dim>::ghost);
  }

private:
  int first() const { return -Grid<Dim>::ghost; }
  int end() const { return layout_.planes() + Grid<Dim>::ghost; }

  const Layout<Dim> &layout_;
  Halo<Dim> halo_;
  VectorField<Dim> faces_;
  std::vector<char> touched_;
};

}  // namespace swellflow
